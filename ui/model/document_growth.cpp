// The Document's preparation and growth.

#include "ui/model/document_private.h"

namespace handlebody::ui {

// --- automatic parameters ---

//! Seeds or parameters have been at rest for a moment.
void Document::Private::preparationDue() {
  if (std::exchange(changedOnTheWay, false) && growth.isRunning()) growth.run(edits.parameters);
  if (!work || edits.seeds.empty() || isPreparing) return;  // when it is done, it looks again
  if (!prepared) requestPreparation(edits.parameters);
}

void Document::Private::requestPreparation(const Parameters& parameters) {
  settle.stop();
  isPreparing = true;
  isOutdated = false;
  const int number = ++preparations;
  preparation.request(
      work->volume, edits.seeds, parameters, [this, number, parameters](const Prepared& result) {
        QMetaObject::invokeMethod(
            &q, [this, number, parameters, result] { preparationDone(number, parameters, result); },
            Qt::QueuedConnection);
      });
}

void Document::Private::preparationDone(int number, const Parameters& parameters, Prepared result) {
  if (number != preparations) return;  // a newer one is under way
  isPreparing = false;
  if (isOutdated) {
    preparationDue();
    return;
  }
  prepareSeconds = result.seconds;
  if (!(parameters == edits.parameters)) {  // the beginning of a replay
    prepared = std::move(result.contour);
    error = result.error;
    startPrepared();
    prepared.reset();
    preparationDue();
    return;
  }
  prepared = std::move(result.contour);
  resolved.reset();
  if (prepared) resolved = prepared->parameters();
  resolveError = result.error;
  if (wanted != Wanted::nothing) error = result.error;
  Q_EMIT q.resolvedChanged();
  startPrepared();
}

// --- growth ---

void Document::Private::goOn(Wanted what) {
  if (!work) return;
  error.clear();
  const bool restart =
      growth.iteration() == 0 && !growth.isRunning() && !(growth.beginning().requested() == edits.parameters);
  if (!growth.exists() || restart) {
    beginGrowth(what);
    return;
  }
  switch (what) {
    case Wanted::run:
      growth.run(edits.parameters);
      break;
    case Wanted::step:
      growth.step(edits.parameters);
      break;
    case Wanted::toEvent:
      growth.runToEvent(edits.parameters);
      break;
    default:
      break;
  }
}

void Document::Private::beginGrowth(Wanted what) {
  growth.clear();
  if (edits.seeds.empty()) {
    error = tr("There is no seed yet: place one inside the object first.");
    updateState();
    return;
  }
  wanted = what;
  const Parameters& first = what == Wanted::replay ? replayed : edits.parameters;
  if (prepared && prepared->requested() == first) {
    startPrepared();
  } else if (!isPreparing || what == Wanted::replay) {
    requestPreparation(first);
  } else {
    settle.stop();  // looked at again as soon as what is under way is done
  }
  updateState();
}

void Document::Private::startPrepared() {
  const Wanted what = std::exchange(wanted, Wanted::nothing);
  if (what == Wanted::nothing) return;
  if (prepared) {
    growth.start(prepared, what == Wanted::replay ? std::optional(replay) : std::nullopt);
    goOn(what);
  }
  updateState();
}

void Document::Private::dropGrowth() {
  wanted = Wanted::nothing;
  error.clear();
  growth.clear();
}

GrowthState Document::Private::state() const {
  if (wanted != Wanted::nothing) return GrowthState::preparing;
  if (!growth.exists()) return GrowthState::none;
  if (growth.isRunning()) return GrowthState::running;
  const bool others = !(growth.parameters() == edits.parameters);
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
  if (d_->wanted != Private::Wanted::nothing) {
    d_->wanted = Private::Wanted::nothing;
    d_->updateState();
  }
  if (d_->growth.exists()) d_->growth.pause();
}

void Document::goTo(int iteration) {
  if (d_->growth.exists()) d_->growth.goTo(iteration);
}
void Document::stepBack() {
  if (d_->growth.exists()) d_->growth.stepBack();
}
void Document::goToPreviousEvent() {
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
const std::vector<Event>& Document::events() const { return d_->growth.events(); }
void Document::requestTrace(int index) {
  if (d_->growth.exists()) d_->growth.trace(index);
}

}  // namespace handlebody::ui
