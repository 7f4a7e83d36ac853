#include "ui/model/opened_objects.h"

#include <QFile>
#include <QFileInfo>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/report/start_surface.h"
#include "core/told_error.h"

namespace handlebody::ui {

namespace {

//! A name that no format refuses.
std::string named(const QString& wanted) {
  const std::string name = wanted.toStdString();
  return objectNameFault(name).empty() ? name : handlebody::ui::Document::tr("Object").toStdString();
}

// A file name without ".nii.gz" and its like.
QString baseName(const QString& path) {
  const QString name = QFileInfo(path).fileName();
  const auto dot = name.indexOf(QLatin1Char('.'), 1);
  return dot < 0 ? name : name.left(dot);
}

Session objectOf(const std::string& file, OpenAs as) {
  Session session;
  session.constraints.start.emplace();
  session.constraints.start->path = file;
  session.constraints.start->isDone = as == OpenAs::done;
  session.requested.direction = Direction::both;
  session.stopAt = 0;
  return session;
}

std::vector<OpenedObject> labelled(const QString& path, const std::string& file, OpenAs as) {
  std::vector<OpenedObject> objects;
  const std::vector<NamedLabel> labels = labelsIn(file);
  for (const NamedLabel& label : labels) {
    objects.push_back({objectOf(file, as), label.hasLook()});
    Session& object = objects.back().session;
    object.constraints.start->label = label.value;
    object.label.value = label.value;
    const QString plain = labels.size() == 1
                              ? baseName(path)
                              : handlebody::ui::Document::tr("%1 %2").arg(baseName(path)).arg(label.value);
    object.label.name = named(plain);
    object.label = labelledAs(label, object.label);
  }
  return objects;
}

bool isWithin(const Grid& grid, const Vec3& world) {
  const Vec3 index = grid.toIndex(world);
  for (int a = 0; a < 3; ++a)
    if (!(index[a] >= -0.5 && index[a] <= grid.size[a] - 0.5)) return false;
  return true;
}

}  // namespace

std::vector<OpenedObject> readObjects(const QString& path, OpenAs as, const Grid& grid) {
  const std::string file = QFile::encodeName(path).toStdString();
  std::vector<OpenedObject> objects;
  if (isMeshInputPath(file)) {
    objects.push_back({objectOf(file, as)});
    objects.back().session.label.name = named(baseName(path));
  } else {
    objects = labelled(path, file, as);
  }
  giveUpIfCancelled();
  std::vector<Session*> all;
  for (OpenedObject& object : objects) all.push_back(&object.session);
  loadStarts(all);
  for (const auto& [object, hasLook] : objects)
    if (!isWithin(grid, object.constraints.start->inside))
      throw Told<InputError>(
          Finding(FindingKind::otherVolume, {{"file", file}, {"object", object.label.name}}));
  return objects;
}

}  // namespace handlebody::ui
