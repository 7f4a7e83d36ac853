// What the Document writes: meshes, label maps, reports, sessions, the journal.

#include <QFile>
#include <chrono>

#include "core/io/atomic_file.h"
#include "core/io/result.h"
#include "ui/model/document_private.h"
#include "ui/model/error_sentence.h"

namespace handlebody::ui {

namespace {

std::string fileName(const QString& path) { return QFile::encodeName(path).toStdString(); }

//! Does `job`; its error as a sentence, or nothing.
template <typename Job>
QString sentenceOf(Job&& job) try {
  job();
  return {};
} catch (...) {
  return errorSentence();
}

//! On the files' thread: the hash is there, or worked out now. Throws InputError.
void complete(Session& session, std::string& hash) {
  if (hash.empty()) hash = sha256OfPath(session.volume.path);
  session.volume.sha256 = hash;
}

}  // namespace

Session Document::Private::session() const {
  Session s;
  s.version = HANDLEBODY_VERSION;
  s.volume = work->reference;
  s.seeds = edits.seeds;
  s.requested = edits.parameters;
  s.constraints = edits.constraints;
  s.view = view.toStdString();
  const int shown = growth.iteration();
  if (shown < 0) return s;
  s.seeds = growth.beginning().requestedSeeds();
  s.requested = growth.beginning().requested();
  s.constraints = growth.beginning().constraints();
  s.resolved = growth.beginning().parameters();
  s.stopAt = shown;
  for (const ParameterChange& change : growth.changes())
    if (change.iteration < shown) s.changes.push_back(change);
  Request last{s.seeds, s.requested, s.constraints};
  for (const ParameterChange& change : s.changes) last = changed(last, change);
  if (last == edits.request()) return s;
  s.changes.push_back({shown, edits.parameters, {}});
  if (last.seeds != edits.seeds) s.changes.back().seeds = edits.seeds;
  if (last.constraints != edits.constraints) s.changes.back().constraints = edits.constraints;
  return s;
}

RunReport Document::Private::report() const {
  RunReport r;
  r.session = session();
  r.volume = work->info;
  r.volume.grid = work->volume.grid;
  r.iterations = growth.iteration();
  r.stopped = growth.stopReason();
  r.seconds.load = work->seconds;
  r.seconds.prepare = prepareSeconds;
  r.seconds.evolve = growth.seconds();
  for (const Event& event : growth.events())
    if (event.iteration <= r.iterations) r.events.push_back(event);
  for (const RecordedCorrection& correction : growth.corrections())
    if (correction.iteration < r.iterations) r.corrections.push_back(correction);
  if (const auto shown = growth.snapshot()) r.held = shown->held;
  if (growth.exists()) {
    r.candidates = growth.beginning().candidates();
    r.isCloseChoice = growth.beginning().isCloseChoice();
  }
  return r;
}

void Document::exportResult(const QString& path, CoordinateSpace space) {
  const auto shown = snapshot();
  if (!shown) {
    Q_EMIT exportFailed(tr("There is no surface to export yet: grow one first."));
    return;
  }
  if (shown->mesh.triangles.empty()) {
    Q_EMIT exportFailed(
        tr("Nothing is left of the surface at this iteration: step back to one that has some."));
    return;
  }
  d_->files.post(
      [this, path, shown, context = ExportContext{d_->work->volume.grid, space, d_->work->info.dicom, {}}] {
        const QString failed = sentenceOf([&] {
          writeResults({{ObjectLabel{}, certifiedForExport(shown->mesh).mesh}}, context, {fileName(path)});
        });
        QMetaObject::invokeMethod(
            this,
            [this, path, failed] { failed.isEmpty() ? Q_EMIT exported(path) : Q_EMIT exportFailed(failed); },
            Qt::QueuedConnection);
      });
}

void Document::exportReport(const QString& path) {
  if (snapshot())
    d_->exportReport(path);
  else
    Q_EMIT exportFailed(tr("There is no surface to report on yet: grow one first."));
}

void Document::Private::exportReport(const QString& path) {
  files.post([this, path, shown = growth.snapshot(), made = report(), known = hash]() mutable {
    const QString failed = sentenceOf([&] {
      const auto start = std::chrono::steady_clock::now();
      complete(made.session, *known);
      const CertifiedMesh mesh = certifiedForExport(shown->mesh);
      made.mesh = mesh.certificate;
      made.doubts = doubts(made, mesh.mesh);
      made.doubts.insert(made.doubts.end(), shown->doubts.begin(), shown->doubts.end());
      made.unsupportedSurface = shown->support.withoutEdge;
      Timings& s = made.seconds;
      s.exported = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      s.total = s.load + s.prepare + s.evolve + s.exported;
      writeTextAtomically(fileName(path), reportText(made));
    });
    QMetaObject::invokeMethod(
        &q,
        [this, path, failed] { failed.isEmpty() ? Q_EMIT q.exported(path) : Q_EMIT q.exportFailed(failed); },
        Qt::QueuedConnection);
  });
}

void Document::saveSession(const QString& path) {
  if (!hasVolume())
    Q_EMIT saveFailed(tr("There is nothing to save yet: open a volume first."));
  else if (!isSeeded())
    Q_EMIT saveFailed(tr("A session needs a seed: place one inside the object first."));
  else
    d_->saveSession(path);
}

void Document::Private::saveSession(const QString& path) {
  const int edit = undo.index(), iteration = growth.iteration(), opening = openings;
  files.post([this, path, made = session(), known = hash, edit, iteration, opening]() mutable {
    const QString failed = sentenceOf([&] {
      complete(made, *known);
      writeSession(made, fileName(path));
    });
    QMetaObject::invokeMethod(
        &q,
        [this, path, failed, edit, iteration, opening] {
          if (!failed.isEmpty()) {
            Q_EMIT q.saveFailed(failed);
            return;
          }
          if (opening == openings) {  // else other work is open by now
            sessionPath = path;
            savedIteration = iteration;
            if (edit == undo.index()) undo.setClean();
            updateModified();
          }
          Q_EMIT q.sessionSaved(path);
        },
        Qt::QueuedConnection);
  });
}

QString Document::sessionPath() const { return d_->sessionPath; }

void Document::Private::journalNow() {
  if (work && q.isSeeded())
    journal.write(session());
  else
    journal.clear();
}

QStringList Document::recoverable() { return Journal::recoverable(); }
void Document::discardRecoverable(const QString& path) { Journal::discard(path); }

}  // namespace handlebody::ui
