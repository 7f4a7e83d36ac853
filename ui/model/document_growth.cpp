// The Document's preparation and growth.

#include "ui/model/document_private.h"

namespace handlebody::ui {

// --- automatic parameters ---

void Document::Private::forgetPreparation() {
  preparation.cancel();
  isPreparing = false;
  ++preparations;
  prepared.reset();
  resolved.reset();
  resolveError.clear();
}

void Document::Private::forgetCandidates() {
  candidates.clear();
  isCloseChoice = false;
}

//! Seeds or parameters have been at rest for a moment.
void Document::Private::preparationDue() {
  if (work && q.isSeeded() && !prepared && !isPreparing) requestPreparation(edits.request());
}

void Document::Private::requestPreparation(const Request& request) {
  settle.stop();
  isPreparing = true;
  const int number = ++preparations;
  preparation.request(work->volume, request, [this, number](const Prepared& result) {
    QMetaObject::invokeMethod(
        &q, [this, number, result] { preparationDone(number, result); }, Qt::QueuedConnection);
  });
}

void Document::Private::preparationDone(int number, const Prepared& result) {
  if (number != preparations) return;  // out of date
  isPreparing = false;
  prepareSeconds = result.seconds;
  if (wanted != Wanted::nothing) error = result.error;
  prepared = result.contour;
  if (prepared && prepared->request() != edits.request()) {  // for the beginning of a replay
    startPrepared();
    prepared.reset();
    preparationDue();
    return;
  }
  resolveError = result.error;
  if (prepared) {
    resolved = prepared->parameters();
    candidates = prepared->candidates();
    isCloseChoice = prepared->isCloseChoice();
  }
  Q_EMIT q.resolvedChanged();
  // Also if it came to its end meanwhile: it would have gone on with these.
  if (std::exchange(changedOnTheWay, false) && prepared && growth.exists())
    growth.run(edits.request(), prepared);
  startPrepared();
}

// --- growth ---

void Document::Private::goOn(Wanted what) {
  if (!work) return;
  error.clear();
  const bool restart =
      growth.iteration() == 0 && !growth.isRunning() && growth.beginning().request() != edits.request();
  if (!growth.exists() || restart) {
    beginGrowth(what);
    return;
  }
  const Request& known = growth.request();
  const bool sameImage = edits.seeds == known.seeds && chooseSameImage(edits.parameters, known.parameters);
  if (!prepared && !sameImage) {
    await(what);
    return;
  }
  switch (what) {
    case Wanted::run:
      growth.run(edits.request(), prepared);
      break;
    case Wanted::step:
      growth.step(edits.request(), prepared);
      break;
    case Wanted::toEvent:
      growth.runToEvent(edits.request(), prepared);
      break;
    default:
      break;
  }
}

//! Goes on when the contour with the present parameters is prepared.
void Document::Private::await(Wanted what) {
  wanted = what;
  if (growth.isRunning()) growth.pause();
  if (what == Wanted::replay)
    requestPreparation(replayed);
  else if (!isPreparing)
    requestPreparation(edits.request());
  updateState();
}

void Document::Private::beginGrowth(Wanted what) {
  growth.clear();
  if (!q.isSeeded()) {
    error = tr("There is no seed yet: place one inside the object first.");
    updateState();
  } else if (prepared && what != Wanted::replay) {
    wanted = what;
    startPrepared();
  } else {
    await(what);
  }
}

void Document::Private::startPrepared() {
  const Wanted what = std::exchange(wanted, Wanted::nothing);
  if (what == Wanted::nothing) return;
  if (prepared && !growth.exists())
    growth.start(prepared, what == Wanted::replay ? std::optional(replay) : std::nullopt);
  if (prepared) goOn(what);
  updateState();
}

void Document::Private::dropGrowth() {
  changedOnTheWay = false;
  wanted = Wanted::nothing;
  error.clear();
  growth.clear();
}

GrowthState Document::Private::state() const {
  if (wanted != Wanted::nothing) return GrowthState::preparing;
  if (!growth.exists()) return GrowthState::none;
  if (growth.isRunning()) return GrowthState::running;
  const bool others = growth.request() != edits.request();
  return growth.stopReason() == StopReason::running || others ? GrowthState::paused : GrowthState::finished;
}

void Document::Private::growthStateChanged() {
  updateState();
  updateModified();
}

void Document::Private::updateState() {
  const GrowthState now = state();
  const StopReason stop = q.stopReason();
  const QString failed = q.growthError();
  if (now == shownState && stop == shownStop && failed == shownError) return;
  const bool cameToRest = shownState == GrowthState::running && now != GrowthState::running;
  shownState = now;
  shownStop = stop;
  shownError = failed;
  if (cameToRest) journalNow();
  Q_EMIT q.stateChanged();
}

GrowthState Document::state() const { return d_->state(); }
StopReason Document::stopReason() const { return d_->growth.stopReason(); }
QString Document::growthError() const { return d_->error.isEmpty() ? d_->growth.error() : d_->error; }

void Document::run() { d_->goOn(Private::Wanted::run); }
void Document::stepForward() { d_->goOn(Private::Wanted::step); }
void Document::goToNextEvent() { d_->goOn(Private::Wanted::toEvent); }

void Document::pause() {
  d_->changedOnTheWay = false;
  if (d_->wanted != Private::Wanted::nothing) {
    d_->wanted = Private::Wanted::nothing;
    d_->updateState();
  }
  if (d_->growth.exists()) d_->growth.pause();
}

void Document::goTo(int iteration) {
  d_->changedOnTheWay = false;
  if (d_->growth.exists()) d_->growth.goTo(iteration);
}
void Document::stepBack() {
  d_->changedOnTheWay = false;
  if (d_->growth.exists()) d_->growth.stepBack();
}
void Document::goToPreviousEvent() {
  d_->changedOnTheWay = false;
  if (d_->growth.exists()) d_->growth.goToPreviousEvent();
}
void Document::goToStart() { goTo(0); }

void Document::setStepsPerFrame(int steps) {
  d_->stepsPerFrame = std::max(1, steps);
  d_->growth.setStepsPerFrame(d_->stepsPerFrame);
}
int Document::stepsPerFrame() const { return d_->stepsPerFrame; }

int Document::iteration() const { return d_->growth.iteration(); }
int Document::lastIteration() const { return static_cast<int>(d_->growth.summaries().size()) - 1; }
std::shared_ptr<const MeshSnapshot> Document::snapshot() const { return d_->growth.snapshot(); }
const std::vector<IterationSummary>& Document::summaries() const { return d_->growth.summaries(); }
const std::vector<RecordedCorrection>& Document::corrections() const { return d_->growth.corrections(); }
const std::vector<Event>& Document::events() const { return d_->growth.events(); }
void Document::requestTrace(int index) {
  if (d_->growth.exists()) d_->growth.trace(index);
}

}  // namespace handlebody::ui
