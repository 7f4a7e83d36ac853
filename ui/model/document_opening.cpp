// How the Document comes to its volume and objects.

#include <QSignalBlocker>

#include "core/cancellation.h"
#include "ui/model/document_private.h"

namespace handlebody::ui {

void Document::open(const QString& path, const VolumeSelection& selection, const QStringList& files) {
  d_->open({path, selection, files});
}

void Document::Private::open(const OpeningRequest& asked) {
  const QString path = asked.path;
  dropOpening();
  editsAtOpen = edits;
  wasModifiedAtOpen = wasModified;
  const StopFlag flag = opening.begin();
  time.store().rest();
  stopHashing();
  const int number = opening.number();
  Q_EMIT q.opening(path, 0);
  files.post([this, number, path, asked, stop = flag] {
    if (*stop) return;
    const auto progress = [&](double part) {
      QMetaObject::invokeMethod(
          &q,
          [this, number, path, part] {
            if (opening.isAwaited(number)) Q_EMIT q.opening(path, part);
          },
          Qt::QueuedConnection);
    };
    auto result = std::make_shared<OpeningResult>(openWork(asked, progress, *stop));
    QMetaObject::invokeMethod(
        &q, [this, number, path, result] { finishOpening(number, path, std::move(*result)); },
        Qt::QueuedConnection);
  });
}

void Document::Private::finishOpening(int number, const QString& path, OpeningResult result) {
  if (!opening.isAwaited(number)) return;  // cancelled, or a newer one is under way
  if (auto* opened = std::get_if<OpenedWork>(&result)) {
    read = ReadWork{path, std::move(*opened)};
    openingWaits ? Q_EMIT q.openingWaits() : q.finishOpening();
    return;
  }
  opening.end();
  if (const auto* choice = std::get_if<SeriesChoice>(&result)) {
    Q_EMIT q.seriesChoiceNeeded(path, choice->series);
  } else if (const auto* needed = std::get_if<FileNeeded>(&result)) {
    Q_EMIT q.fileNeeded(path, needed->missing, needed->refused, needed->taken);
  } else {
    const auto& failed = std::get<OpeningFailed>(result);
    Q_EMIT q.openFailed(failed.sentence, failed.needsSpacing);
  }
}

void Document::finishOpening() {
  if (!d_->read) return;
  ReadWork read = std::move(*d_->read);
  d_->read.reset();
  d_->opening.end();
  d_->adopt(read.path, std::move(read.work));
}

void Document::Private::dropOpening() {
  opening.cancel();
  read.reset();
}

void Document::cancelOpening() {
  const bool wasOpening = isOpening();
  d_->dropOpening();
  if (wasOpening) Q_EMIT openingCancelled();
}

void Document::setOpeningWaits(bool on) { d_->openingWaits = on; }
bool Document::isOpeningWaiting() const { return d_->read.has_value(); }

// What was unsaved before has been asked about when it was opened.
bool Document::isChangedSinceOpen() const {
  return isModified() && (!d_->wasModifiedAtOpen || d_->edits != d_->editsAtOpen);
}

void Document::Private::adopt(const QString& path, OpenedWork opened) {
  const std::vector<Session> sessions = std::move(opened.sessions);
  for (const auto& object : objects) object->pause();
  const auto first = objects[0];
  objects.hold({first}, first);
  first->reset();
  undo.clear();
  journal.startWith(path);
  work = std::move(opened);
  sessionPath.clear();
  view.clear();
  hashInBackground();
  growsIn = -1;
  corrected = {};
  isCorrectionSaved = false;
  carriesLater = false;
  output = {};
  if (!sessions.empty()) output = {sessions.front().polish, sessions.front().space};
  measurements.startWith(sessions.empty() ? std::vector<Measurement>() : sessions.front().measurements);
  if (!sessions.empty()) adoptObjects(path, sessions);
  {
    const QSignalBlocker quiet(time);  // opened() says it
    time.start(*work);
    if (!sessions.empty())
      time.setRequest(sessions.front().overTime.value_or(OverTimeRequest{}),
                      sessions.front().overTime.has_value());
  }
  if (Journal::isJournal(path)) journalNow();  // which will not be kept: only now all of it is taken over
  Q_EMIT q.polishesChanged();
  Q_EMIT q.opened();
  tellAll();
  for (const auto& object : objects) object->begin();
  active().beShown();
  carriesLater = time.isAsked() && objects.size() == 1 && active().isReplaying();
  updateModified();
}

void Document::Private::adoptObjects(const QString& path, const std::vector<Session>& sessions) {
  view = QByteArray::fromStdString(sessions.front().view);
  for (const Session& session : sessions) {
    if (&session != &sessions.front()) objects.add(newObject());
    objects.all().back()->adopt(session);
  }
  readView();
  if (Journal::isJournal(path)) {
    undo.resetClean();
  } else if (!work->isAnonymous) {  // what is saved names the volume, and is not to take its place unasked
    sessionPath = path;
    sessionStamp = work->stamp;
  }
}

void Document::Private::hashInBackground() {
  hash = std::make_shared<std::string>(work->reference.sha256);
  if (!hash->empty()) return;
  hashing = std::make_shared<std::atomic<bool>>(false);
  files.post([known = hash, path = work->reference.path, stop = hashing] {
    const CancelScope scope(*stop);
    try {
      *known = sha256OfPath(path);
    } catch (const Cancelled&) {
    } catch (const std::exception&) {  // tried again, and told, when a session is saved
    }
  });
}

//! What comes next waits for it: a session that is saved makes it anew.
void Document::Private::stopHashing() {
  if (hashing) *hashing = true;
}

bool Document::isOpening() const { return d_->opening.isUnderWay(); }
bool Document::hasVolume() const { return d_->work.has_value(); }
const Volume& Document::volume() const {
  return d_->time.showsWorkFrame() ? d_->work->volume : d_->time.volume();
}
const VolumeInfo& Document::info() const { return d_->work->info; }
QString Document::path() const {
  return d_->work ? QString::fromStdString(d_->work->reference.path) : QString();
}
const VolumeSelection& Document::selection() const { return d_->work->reference.selection; }
QByteArray Document::view() const { return d_->view; }
void Document::setView(const QByteArray& json) { d_->view = json; }

}  // namespace handlebody::ui
