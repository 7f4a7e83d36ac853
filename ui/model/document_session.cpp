// What the Document keeps: sessions, the journal.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/io/formats/volume_io.h"
#include "core/io/report/anonymous_names.h"
#include "core/io/report/voxel_fingerprint.h"
#include "core/version.h"
#include "ui/model/document_private.h"
#include "ui/model/error_sentence.h"
#include "ui/model/file_name.h"

namespace handlebody::ui {

namespace {

const QString kObjectsKey = QStringLiteral("objects"), kActiveKey = QStringLiteral("activeObject"),
              kVisibleKey = QStringLiteral("visible"), kLockedKey = QStringLiteral("locked");

}  // namespace

void complete(Session& session, std::string& hash) {
  if (hash.empty()) hash = sha256OfPath(session.volume.path);
  session.volume.sha256 = hash;
}

std::vector<Session> Document::Private::sessions() const {
  std::vector<Session> all;
  const auto grown = corrected.isOpen() ? std::vector{corrected.home()} : objects.all();
  for (const auto& object : grown) {
    all.push_back(object->session());
    all.back().version = HANDLEBODY_VERSION;
    all.back().volume = work->reference;
    all.back().polish = output.polishes;
    all.back().space = output.space;
  }
  all.front().view = viewWithObjects(view).toStdString();
  all.front().measurements = measurements.all();
  if (all.size() == 1 && hasOverTime()) {  // several are not carried (addFault)
    all.front().overTime = time.request();
    all.front().overTime->corrections = corrections();
  }
  return all;
}

//! What a session of the command line has no place for stands among what the window keeps for itself.
QByteArray Document::Private::viewWithObjects(const QByteArray& window) const {
  QJsonObject json = QJsonDocument::fromJson(window).object();
  const bool isPlain = objects.size() == 1 && active().traits.visible && !active().traits.locked;
  if (isPlain && !json.contains(kObjectsKey)) return window;
  json.remove(kObjectsKey);
  json.remove(kActiveKey);
  if (isPlain) return json.isEmpty() ? QByteArray() : QJsonDocument(json).toJson(QJsonDocument::Compact);
  QJsonArray rows;
  for (const auto& object : objects)
    rows.append(QJsonObject{{kVisibleKey, object->traits.visible}, {kLockedKey, object->traits.locked}});
  json[kObjectsKey] = rows;
  json[kActiveKey] = objects.indexOf(active());
  return QJsonDocument(json).toJson(QJsonDocument::Compact);
}

// A session may come from anywhere: what makes no sense is left as it is.
void Document::Private::readView() {
  const QJsonObject json = QJsonDocument::fromJson(view).object();
  const QJsonArray rows = json[kObjectsKey].toArray();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const QJsonObject row = rows[static_cast<qsizetype>(i)].toObject();
    objects[i]->traits.visible = row[kVisibleKey].toBool(true);
    objects[i]->traits.locked = row[kLockedKey].toBool(false);
  }
  const int index = json[kActiveKey].toInt(0);
  if (index >= 0 && index < static_cast<int>(objects.size())) objects.activate(objects[index]);
}

// --- session ---

QString Document::sessionFault() const {
  if (!hasVolume()) return tr("There is nothing to save yet: open a volume first.");
  if (!d_->objects.isSeeded()) return tr("A session needs a seed: place one inside the object first.");
  return {};
}

void Document::saveSession(const QString& path) {
  if (const QString fault = sessionFault(); !fault.isEmpty())
    Q_EMIT saveFailed(fault);
  else
    d_->saveSession(path);
}

void Document::exportAnonymousSession(const QString& path) {
  if (const QString fault = sessionFault(); !fault.isEmpty())
    Q_EMIT exportRefused(fault);
  else
    d_->exportAnonymousSession(path);
}

void Document::Private::exportAnonymousSession(const QString& path) {
  // Which objects are shown and locked names nobody; what the window keeps may have come with a file.
  write(path,
        [path, made = sessions(), known = hash, own = viewWithObjects({}).toStdString(),
         volume = corrected.grownVolume(work->volume)]() mutable -> Written {
          for (Session& session : made) complete(session, *known);
          keepVoxels(made.front().volume, volume);  // the others have the same
          hideFileNames(made);
          for (Session& session : made) session = anonymous(std::move(session));
          made.front().view = own;
          writeSessions(made, fileName(path));
          return {};
        });
}

void Document::Private::saveSession(const QString& path) {
  if (const QString fault = q.outputFault(path); !fault.isEmpty()) {
    Q_EMIT q.saveFailed(fault);
    return;
  }
  files.post([this, path, made = sessions(), known = hash, state = stateToWrite()]() mutable {
    const QString failed = whyNot([&] {
      for (Session& session : made) complete(session, *known);
      writeSessions(made, fileName(path));
      state.stamp = stampOf(path);
    });
    QMetaObject::invokeMethod(
        &q,
        [this, path, failed, state, known] {
          if (!failed.isEmpty()) {
            Q_EMIT q.saveFailed(failed);
            return;
          }
          if (known == hash) saved(path, state);  // else other work is open by now
          Q_EMIT q.sessionSaved(path);
        },
        Qt::QueuedConnection);
  });
}

//! The job that writes may be the last that has it: it must not keep the objects, which live on this thread.
WrittenState Document::Private::stateToWrite() const {
  WrittenState state;
  state.edit = edits;
  for (const auto& object : objects) state.iterations.emplace_back(object, object->growth().iteration());
  if (!corrected.isOpen()) return state;
  state.iterations.emplace_back(corrected.home(), corrected.home()->growth().iteration());
  if (active().growth().exists()) state.correction = objects.active();
  return state;
}

void Document::Private::saved(const QString& path, const WrittenState& state) {
  sessionPath = path;
  sessionStamp = state.stamp;
  for (const auto& [object, iteration] : state.iterations)
    if (const auto there = object.lock()) there->setSavedIteration(iteration);
  const bool isLeft = state.correction && state.correction->lock() != objects.active();
  isCorrectionSaved = state.correction && !isLeft;
  if (state.edit == edits && !isLeft)
    undo.setClean();
  else
    undo.resetClean();  // what was clean before is not in the file either
  updateModified();
}

QString Document::sessionPath() const { return d_->sessionPath; }

bool Document::isSessionChangedElsewhere() const {
  if (d_->sessionPath.isEmpty()) return false;
  const FileStamp now = stampOf(d_->sessionPath);
  return now.isThere() && now != d_->sessionStamp;
}

//! No object can be added then, but undo brings one back that was there before.
QString Document::leftOut() const {
  if (objectCount() < 2 || !d_->hasOverTime()) return {};
  return tr("Work over time is left out while there are several objects: delete all but one to keep it.");
}

QStringList Document::notReplayed() const {
  QStringList names;
  if (objectCount() < 2) return names;
  for (const auto& object : d_->objects) {
    const bool isAsShown = object->growth().exists() && !object->isOutOfDate() && names.isEmpty();
    if (object->isSeeded() && !object->isReplaying() && !isAsShown)
      names.append(QString::fromStdString(object->traits.label.name));
  }
  return names;
}

void Document::Private::journalNow() {
  const bool isWorthIt = objects.size() > 1 || active().isSeeded();
  if (work && isWorthIt && objects.isSeeded())
    journal.write(sessions());
  else
    journal.clear();
}

void Document::Private::tellOfJournal(const QString& why) {
  Q_EMIT q.journalFailed(
      tr("Nothing is kept for the case that the program ends unexpectedly: save the session. %1").arg(why));
}

QStringList Document::recoverable() { return Journal::recoverable(); }
void Document::discardRecoverable(const QString& path) { Journal::discard(path); }

}  // namespace handlebody::ui
