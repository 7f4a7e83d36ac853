#include "ui/model/opened_objects.h"

#include <QFileInfo>
#include <algorithm>
#include <mutex>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/report/start_surface.h"
#include "core/told_error.h"
#include "ui/model/error_sentence.h"
#include "ui/model/file_name.h"
#include "ui/model/opening.h"

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

Session objectOf(const std::string& file, const ObjectsToOpen& asked) {
  Session session;
  session.constraints.start.emplace();
  session.constraints.start->path = file;
  session.constraints.start->isDone = asked.as == OpenAs::done;
  session.requested.direction = Direction::both;
  session.stopAt = 0;
  return session;
}

//! Those that are asked for; one that the file does not have is refused when its voxels are looked for.
std::vector<NamedLabel> chosenOf(const std::vector<NamedLabel>& labels, const std::vector<int>& values) {
  if (values.empty()) return labels;
  std::vector<NamedLabel> chosen;
  for (const int value : values) {
    const auto found = std::ranges::find(labels, value, &NamedLabel::value);
    chosen.push_back(found == labels.end() ? NamedLabel{{}, value} : *found);
  }
  return chosen;
}

std::vector<OpenedObject> labelled(const std::string& file, const ObjectsToOpen& asked) {
  std::vector<OpenedObject> objects;
  const std::vector<NamedLabel> labels = labelsIn(file);
  const QString base = baseName(asked.path);
  for (const NamedLabel& label : chosenOf(labels, asked.labels)) {
    objects.push_back({objectOf(file, asked), label.hasLook()});
    Session& object = objects.back().session;
    object.constraints.start->label = label.value;
    object.constraints.start->shape = asked.shape;
    object.label.value = label.value;
    const QString plain =
        labels.size() == 1 ? base : handlebody::ui::Document::tr("%1 %2").arg(base).arg(label.value);
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

LabelsToOpen labelsToOpen(const QString& path, const std::atomic<bool>& cancelled) {
  LabelsToOpen found;
  try {
    const CancelScope scope(cancelled);
    const std::lock_guard lock(readingVolumes());
    giveUpIfCancelled();
    LabelFile file(fileName(path));
    found.mayOverlap = file.info().layers > 1;
    found.labels = file.labels();
  } catch (const Cancelled&) {
  } catch (...) {
    found.error = errorSentence();
  }
  return found;
}

std::vector<OpenedObject> readObjects(const ObjectsToOpen& asked, const Grid& grid) {
  const std::string file = fileName(asked.path);
  std::vector<OpenedObject> objects;
  if (isMeshInputPath(file)) {
    objects.push_back({objectOf(file, asked)});
    objects.back().session.label.name = named(baseName(asked.path));
  } else {
    objects = labelled(file, asked);
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
