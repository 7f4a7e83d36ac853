// What the Document writes: meshes, label maps, reports.

#include <QFile>
#include <algorithm>
#include <chrono>
#include <numeric>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/formats/volume_files.h"
#include "core/io/report/anonymous_names.h"
#include "core/io/report/object_paths.h"
#include "core/io/report/result.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/voxel_fingerprint.h"
#include "core/told_error.h"
#include "core/version.h"
#include "ui/model/document_private.h"
#include "ui/model/error_sentence.h"
#include "ui/model/file_name.h"

namespace handlebody::ui {

namespace {

//! What takes time: measures, and warnings.
RunReport completed(PendingReport pending, const WrittenMesh& mesh, const Volume& volume) {
  const auto start = std::chrono::steady_clock::now();
  RunReport made = std::move(pending.report);
  const std::vector<Finding> known = std::move(made.warnings);
  const MeshSnapshot& shown = *pending.object.surface->shown();
  made.mesh = mesh.made.certificate;
  made.measures = objectMeasures(mesh.made.mesh, &volume);
  made.polish = mesh.polish;
  made.warnings = resultWarnings(made, mesh.made.mesh);
  if (mesh.polish)
    if (Finding warning = polishWarning(*mesh.polish); warning.any())
      made.warnings.push_back(std::move(warning));
  made.warnings.insert(made.warnings.end(), shown.warnings.begin(), shown.warnings.end());
  made.warnings.insert(made.warnings.end(), known.begin(), known.end());
  for (Finding& d : pinWarnings(made)) made.warnings.push_back(std::move(d));
  if (shown.support.covers(shown.mesh.triangles.size())) made.unsupportedSurface = shown.support.withoutEdge;
  Timings& s = made.seconds;
  s.exported = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  s.total = s.load + s.prepare + s.evolve + s.exported;
  return made;
}

std::vector<PairGap> gapsOf(const std::vector<WrittenMesh>& meshes) {
  std::vector<const TriangleSoup*> bodies;
  for (const WrittenMesh& mesh : meshes) bodies.push_back(&mesh.made.mesh);
  return pairGaps(bodies);
}

std::string textOf(const std::vector<RunReport>& reports, const std::vector<WrittenMesh>& meshes) {
  if (reports.size() == 1) return reportText(reports.front());
  Timings sum;
  for (const RunReport& report : reports) {
    sum.load += report.seconds.load;
    sum.prepare += report.seconds.prepare;
    sum.evolve += report.seconds.evolve;
    sum.exported += report.seconds.exported;
    sum.total += report.seconds.total;
  }
  return reportText(reports, sum, gapsOf(meshes));
}

}  // namespace

// --- results ---

void Document::exportResult(const QString& path, CoordinateSpace space, const DicomContent& content) {
  const auto shown = snapshot();
  if (!shown)
    Q_EMIT exportRefused(tr("There is no surface to export yet: grow one first."));
  else if (!finishedMesh(activeObject()) &&
           !d_->time.showsWorkFrame())  // of another surface than there is now
    Q_EMIT exportRefused(
        tr("There are no surfaces over time of what is shown: carry it through the frames first."));
  else if (shown->mesh.triangles.empty())
    Q_EMIT exportRefused(
        tr("Nothing is left of the surface at this iteration: step back to one that has some."));
  else
    d_->exportFiles(path, space, content, {activeObject()});
}

QString Document::allFault() const {
  for (const auto& object : d_->objects)
    if (object->isBusy())
      return tr("“%1” still grows: wait until it is at rest, or pause it.")
          .arg(QString::fromStdString(object->traits.label.name));
  return {};
}

void Document::exportObjects(const QString& path, CoordinateSpace space, const DicomContent& content) {
  std::vector<int> which;
  for (int i = 0; i < objectCount(); ++i)
    if (finishedMesh(i)) which.push_back(i);
  if (const QString fault = allFault(); !fault.isEmpty())
    Q_EMIT exportRefused(fault);
  else if (which.empty())
    Q_EMIT exportRefused(tr("There is no surface to export yet: grow one first."));
  else
    d_->exportFiles(path, space, content, which);
}

QStringList Document::objectPaths(const QString& path, const QString& extension, bool anonymous) const {
  QStringList paths;
  for (const std::string& p :
       handlebody::objectPaths(fileName(path), fileName(extension), d_->namesInFiles(anonymous)))
    paths << QFile::decodeName(QByteArray::fromStdString(p));
  return paths;
}

void Document::exportEachObject(const QString& path, const QString& extension, CoordinateSpace space,
                                const DicomContent& content) {
  if (const QString fault = allFault(); !fault.isEmpty())
    Q_EMIT exportRefused(fault);
  else if (objectPaths(path, extension, content.anonymous).isEmpty())
    Q_EMIT exportRefused(tr("There is no surface to export yet: grow one first."));
  else
    d_->exportEach(path, extension, space, content);
}

QString Document::exportFault(const QString& extension) const {
  if (!hasVolume()) return {};
  return whyNot([&] {
    // It begins with the path, which is none here.
    try {
      checkResult("x" + extension.toStdString(), {volume().grid, {}, info().dicom, {}});
    } catch (const UsageError& error) {
      throw Told<UsageError>(findingOf(error).causes.at(0));
    }
  });
}

void Document::cancelExport() { d_->exporting.cancel(); }

bool Document::polishes() const { return d_->output.polishes; }
CoordinateSpace Document::space() const { return d_->output.space; }

void Document::setPolishes(bool on) {
  if (on == d_->output.polishes) return;
  d_->setOutput({on, d_->output.space});
  Q_EMIT polishesChanged();
}

//! No entry of the undo list: what is in the session now cannot be undone to.
void Document::Private::setOutput(const OutputChoices& choices) {
  if (choices == output) return;
  output = choices;
  ++edits;  // a session that is being written has the choices of before
  if (q.sessionFault().isEmpty()) undo.resetClean();
  journalNow();
}

WrittenObject Document::Private::objectToWrite(const ObjectWork& object,
                                               std::shared_ptr<const FinishedMesh> surface) const {
  const ObjectLabel& label = object.traits.label;
  return {label,
          label.name,
          std::move(surface),
          object.request().constraints.walls,
          true,
          isMeshAsItIs(object.edits().constraints)};
}

std::string Document::Private::nameInFiles(const std::string& name, bool isAnonymous) const {
  if (!isAnonymous) return name;
  const std::vector<std::string> names = q.anonymousNames();
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i]->traits.label.name == name) return names[i];
  return ObjectLabel{}.name;
}

//! All that have a surface; those that are not among `which` are not wanted.
std::vector<WrittenObject> Document::Private::writtenObjects(const std::vector<int>& which,
                                                             bool isAnonymous) const {
  std::vector<WrittenObject> all;
  for (int i = 0; i < q.objectCount(); ++i) {
    auto surface = q.finishedMesh(i);  // of the frame that is shown
    if (!surface) continue;
    all.push_back(objectToWrite(objects.at(i), surface));
    SegmentSource& source = all.back().label.source;
    source = sourceInFiles(std::move(source), objects.at(i).request().constraints,
                           surface->shown()->iteration, isAnonymous);
    if (const CarriedFrame* carried = time.carriedTo(time.shownFrame());
        carried && carried->finished == surface)
      all.back().walls = carried->result.under.walls;  // of a corrected frame its own
    all.back().nameInFiles = nameInFiles(all.back().label.name, isAnonymous);
    all.back().isWanted = std::find(which.begin(), which.end(), i) != which.end();
  }
  return all;
}

QString Document::outputFault(const QString& path) const {
  if (!hasVolume()) return {};
  const std::string file = fileName(path);
  if (belongsToVolume(file, d_->work->reference.path))
    return tr("%1 cannot be written: it would be a part of the volume that is open. Choose another folder or "
              "name.")
        .arg(path);
  for (const Session& session : d_->sessions())
    for (const std::string& input : inputsOf(session))
      if (!input.empty() && belongsToVolume(file, input))
        return tr("%1 cannot be written: the open work is read from it. Choose another folder or name.")
            .arg(path);
  return {};
}

void Document::Private::write(const QString& path, std::function<Written()> job) {
  write(path, {path}, std::move(job));
}

void Document::Private::write(const QString& path, const QStringList& all, std::function<Written()> job) {
  for (const QString& file : all)
    if (const QString fault = q.outputFault(file); !fault.isEmpty()) return Q_EMIT q.exportRefused(fault);
  files.post([this, path, stop = exporting.begin(), job = std::move(job)] {
    bool gaveUp = false;
    Written told;
    const QString failed = whyNot([&] {
      try {
        const CancelScope scope(*stop);
        giveUpIfCancelled();  // while it waited
        told = job();
      } catch (const Cancelled&) {
        gaveUp = true;
      }
    });
    QMetaObject::invokeMethod(
        &q,
        [this, path, stop, failed, gaveUp, told] {
          exporting.end(stop);
          if (gaveUp) {
            Q_EMIT q.exportCancelled(path);
            return;
          }
          if (failed.isEmpty() && !told.polished.isEmpty()) Q_EMIT q.polished(told.polished);
          if (failed.isEmpty() && !told.leftOut.isEmpty()) Q_EMIT q.leftOutOfLabelMap(told.leftOut);
          failed.isEmpty() ? Q_EMIT q.exported(path) : Q_EMIT q.exportFailed(failed);
        },
        Qt::QueuedConnection);
  });
  Q_EMIT q.exporting(path);
}

void Document::Private::exportFiles(const QString& path, CoordinateSpace coordinates,
                                    const DicomContent& content, const std::vector<int>& which) {
  exportAs(path, {path}, coordinates, content, which, [path](const auto& made, const ExportContext& context) {
    writeResults(made, context, {fileName(path)});
  });
}

void Document::Private::exportEach(const QString& path, const QString& extension, CoordinateSpace coordinates,
                                   const DicomContent& content) {
  std::vector<int> all(objects.size());
  std::iota(all.begin(), all.end(), 0);
  const QString told = path.chopped(extension.size()) + QStringLiteral("_*") + extension;
  exportAs(told, q.objectPaths(path, extension, content.anonymous), coordinates, content, all,
           [path, extension](const auto& made, const ExportContext& context) {
             std::vector<std::string> names;
             for (const ExportedObject& object : made) names.push_back(object.label.name);
             writeEachResult(made, context,
                             handlebody::objectPaths(fileName(path), fileName(extension), names));
           });
}

std::vector<std::string> Document::Private::namesInFiles(bool isAnonymous) const {
  std::vector<std::string> names;
  for (int i = 0; i < q.objectCount(); ++i)
    if (q.finishedMesh(i)) names.push_back(nameInFiles(objects.at(i).traits.label.name, isAnonymous));
  return names;
}

void Document::Private::exportAs(const QString& told, const QStringList& paths, CoordinateSpace coordinates,
                                 const DicomContent& content, const std::vector<int>& which,
                                 WriteObjects writeThem) {
  setOutput({output.polishes, coordinates});
  write(told, paths,
        [this, paths, betters = output.polishes, toWrite = writtenObjects(which, content.anonymous),
         context =
             ExportContext{work->volume.grid, coordinates, time.store().origin(time.shownFrame()), content},
         writeThem = std::move(writeThem)]() -> Written {
          const auto meshes = writtenMeshes(toWrite, context.grid, betters, polishing());
          requireApart(toWrite, meshes);
          std::vector<ExportedObject> made;
          for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (!toWrite[i].isWanted) continue;
            made.push_back({toWrite[i].label, meshes[i].made.mesh});
            made.back().label.name = toWrite[i].nameInFiles;
          }
          giveUpIfCancelled();
          const QString leftOut = leftOutTexts(toWrite, meshes, context, paths);
          writeThem(made, context);
          return {polishTexts(toWrite, meshes), leftOut};
        });
}

std::function<void(const std::string&)> Document::Private::polishing() {
  return [this](const std::string& name) {
    QMetaObject::invokeMethod(
        &q, [this, name] { Q_EMIT q.exportPolishes(QString::fromStdString(name)); }, Qt::QueuedConnection);
  };
}

// --- report ---

void Document::exportReport(const QString& path, bool isAnonymous) {
  if (d_->corrected.isOpen()) {
    Q_EMIT exportRefused(tr("A frame is being corrected: end that first."));
    return;
  }
  if (const QString fault = allFault(); !fault.isEmpty()) {
    Q_EMIT exportRefused(fault);
    return;
  }
  const auto made = hasVolume() ? d_->pendingReports(isAnonymous) : std::vector<PendingReport>();
  if (made.empty())
    Q_EMIT exportRefused(tr("There is no surface to report on yet: grow one first."));
  else
    d_->exportReport(path, made, isAnonymous);
}

//! Of what is known on this thread; the rest is added on the files'.
std::vector<PendingReport> Document::Private::pendingReports(bool isAnonymous) const {
  std::vector<PendingReport> all;
  for (const auto& object : objects) {
    const auto shown = object->growth().snapshot();
    if (!shown || !object->finished()) continue;
    RunReport r = object->report();
    r.session.label.name = nameInFiles(r.session.label.name, isAnonymous);
    r.session.version = HANDLEBODY_VERSION;
    r.session.volume = work->reference;
    r.session.polish = output.polishes;
    r.session.space = output.space;
    r.volume = work->info;
    r.volume.grid = work->volume.grid;
    if (all.empty()) {
      r.session.view = viewWithObjects(view).toStdString();
      r.session.measurements = measurements.all();
      r.seconds.load = work->seconds;
    }
    if (const QString earlier = objects.madeWithEarlier(*object); !earlier.isEmpty())
      r.warnings.push_back(
          {FindingKind::madeWithEarlier, {{"object", nameInFiles(earlier.toStdString(), isAnonymous)}}});
    if (objects.size() == 1 && q.isCarriedCurrent()) r.overTime = overTimeReport();
    all.push_back({std::move(r), objectToWrite(*object, object->finished())});
  }
  return all;
}

void Document::Private::exportReport(const QString& path, const std::vector<PendingReport>& reports,
                                     bool isAnonymous) {
  write(path,
        [this, path, made = reports, known = hash, isAnonymous, betters = output.polishes,
         volume = work->volume, grown = corrected.grownVolume(work->volume)]() mutable -> Written {
          std::vector<WrittenObject> told;
          for (const PendingReport& pending : made) told.push_back(pending.object);
          const auto meshes = writtenMeshes(told, volume.grid, betters, polishing());
          std::vector<RunReport> all;
          for (std::size_t i = 0; i < made.size(); ++i) {
            complete(made[i].report.session, *known);
            if (isAnonymous) keepVoxels(made[i].report.session.volume, grown);
            all.push_back(completed(std::move(made[i]), meshes[i], volume));
            if (isAnonymous) all.back() = anonymous(std::move(all.back()));
            giveUpIfCancelled();
          }
          writeTextAtomically(fileName(path), textOf(all, meshes));
          return {polishTexts(told, meshes), {}};
        });
}

}  // namespace handlebody::ui
