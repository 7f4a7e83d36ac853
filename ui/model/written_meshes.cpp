#include "ui/model/written_meshes.h"

#include <QLocale>
#include <QMap>

#include "core/cancellation.h"
#include "core/collision/body_contact.h"
#include "core/errors.h"
#include "core/io/report/frame_files.h"
#include "ui/model/file_name.h"
#include "ui/model/finding_text.h"

namespace handlebody::ui {

namespace {

bool meet(const WrittenMesh& a, const WrittenMesh& b) {
  return bodyContact(a.made.mesh, b.made.mesh) != BodyContact::none;
}

QString nameOf(const WrittenObject& object) { return QString::fromStdString(object.label.name); }

PolishOptions optionsFor(const WrittenObject& object, const TriangleSoup& mesh, const Grid& grid) {
  const MeshSnapshot& shown = *object.surface->shown();
  return polishOptions({grid, object.walls, shown.edgeLength, shown.pinned}, mesh);
}

}  // namespace

std::vector<WrittenMesh> writtenMeshes(const std::vector<WrittenObject>& objects, const Grid& grid,
                                       bool polishes,
                                       const std::function<void(const std::string&)>& polishing) {
  std::vector<WrittenMesh> meshes;
  std::size_t end = 0;  // behind the last that is wanted
  for (const WrittenObject& object : objects) {
    giveUpIfCancelled();
    meshes.push_back({object.surface->get(), {}});
    if (object.isWanted) end = meshes.size();
  }
  for (std::size_t i = 0; polishes && i < end; ++i) {
    if (objects[i].isAsItIs) continue;
    if (polishing) polishing(objects[i].label.name);
    PolishOptions options = optionsFor(objects[i], meshes[i].made.mesh, grid);
    std::vector<const TriangleSoup*> others;
    for (std::size_t j = 0; j < meshes.size(); ++j)  // one that it meets already is no obstacle
      if (j != i && !meet(meshes[i], meshes[j])) others.push_back(&meshes[j].made.mesh);
    options.bounds.obstacles = others;
    meshes[i].polish = polish(meshes[i].made, options);
  }
  return meshes;
}

void requireApart(const std::vector<WrittenObject>& objects, const std::vector<WrittenMesh>& meshes) {
  for (std::size_t j = 1; j < objects.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (objects[i].isWanted && objects[j].isWanted && meet(meshes[i], meshes[j]))
        throw OutputError(
            Document::tr("“%1” meets “%2”, and nothing was written: grow it anew, so that it keeps clear.")
                .arg(nameOf(objects[j]), nameOf(objects[i]))
                .toStdString());
}

namespace {

//! As polishSentence, but for its first letter.
QString withoutCapital(const PolishReport& report) {
  if (report.before.faces + report.before.edges == 0) return {};
  const auto counted = [](const PolishCount& c) { return QString::number(c.faces + c.edges); };
  const auto degrees = [](double angle) { return QLocale().toString(angle, 'f', 1); };
  return Document::tr("polished: %1 bad places, now %2; least angle %3°, was %4°.")
      .arg(counted(report.before), counted(report.after), degrees(report.after.leastAngle),
           degrees(report.before.leastAngle));
}

}  // namespace

QString polishSentence(const PolishReport& report) {
  const QString text = withoutCapital(report);
  return text.left(1).toUpper() + text.mid(1);
}

QString polishTexts(const std::vector<WrittenObject>& objects, const std::vector<WrittenMesh>& meshes) {
  QString all;
  const auto add = [&](const QString& sentence) {
    if (!all.isEmpty()) all += QLatin1Char(' ');
    all += sentence;
  };
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto& done = meshes[i].polish;
    if (!done || !objects[i].isWanted || polishSentence(*done).isEmpty()) continue;
    add(objects.size() > 1 ? Document::tr("“%1” %2").arg(nameOf(objects[i]), withoutCapital(*done))
                           : polishSentence(*done));
  }
  return all;
}

QString leftOutTexts(const std::vector<WrittenObject>& objects, const std::vector<WrittenMesh>& meshes,
                     const ExportContext& context, const QStringList& paths) {
  std::vector<std::string> names;
  for (const QString& path : paths) names.push_back(fileName(path));
  std::vector<Finding> all;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    giveUpIfCancelled();
    if (!objects[i].isWanted) continue;
    for (Finding& left : labelMapWarnings(meshes[i].made.mesh, context.grid, names))
      all.push_back(objects.size() > 1
                        ? Finding(FindingKind::ofObject, {{"object", objects[i].label.name}}, std::move(left))
                        : std::move(left));
  }
  return findingSentences(all);
}

QString leftOutTexts(const OverTimeReport& over, const Grid& grid, const QString& path) {
  QMap<QString, QStringList> framesOf;
  for (const auto& [frame, warnings] : frameLabelWarnings(over, grid, {fileName(path)}))
    framesOf[findingSentences(warnings)] += QString::number(frame);
  QStringList all;
  for (auto it = framesOf.cbegin(); it != framesOf.cend(); ++it)
    all += Document::tr("Frames %1: %2").arg(it.value().join(QStringLiteral(", ")), it.key());
  return all.join(QLatin1Char(' '));
}

}  // namespace handlebody::ui
