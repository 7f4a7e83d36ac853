#include "ui/model/surface_growth.h"

#include <QMetaObject>

namespace handlebody::ui {

SurfaceGrowth::SurfaceGrowth(QObject* context, Listener listener)
    : listener_(std::move(listener)), worker_([this, context] {
        QMetaObject::invokeMethod(
            context, [this] { collect(); }, Qt::QueuedConnection);
      }) {}

//! What the state is from now on, until the worker has done the commands given so far.
void SurfaceGrowth::expect(bool running) {
  expected_ = worker_.sent();
  error_.clear();
  if (running_ == running) return;
  running_ = running;
  listener_.stateChanged();
}

void SurfaceGrowth::start(std::shared_ptr<const ActiveContour> contour, const std::optional<Replay>& replay) {
  clear();
  start_ = contour;
  request_ = contour->request();
  worker_.start(std::move(contour));
  started_ = worker_.sent();
  if (replay) worker_.replay(*replay);
  expect(replay.has_value());
}

void SurfaceGrowth::clear() {
  if (!exists()) return;
  worker_.clear();
  start_.reset();
  started_ = expected_ = worker_.sent();
  running_ = false;
  stopReason_ = StopReason::running;
  error_.clear();
  snapshot_.reset();
  summaries_.clear();
  events_.clear();
  leaks_.clear();
  questions_.clear();
  changes_.clear();
  corrections_.clear();
  seconds_ = 0;
  resolved_.reset();
  listener_.summariesChanged();
  listener_.snapshotChanged();
  listener_.stateChanged();
}

void SurfaceGrowth::run(const Request& request, PreparedContour prepared) {
  worker_.run(request, std::move(prepared));
  expect(true);
}

void SurfaceGrowth::runToEvent(const Request& request, PreparedContour prepared) {
  worker_.runToEvent(request, std::move(prepared));
  expect(true);
}

void SurfaceGrowth::step(const Request& request, PreparedContour prepared) {
  worker_.step(request, std::move(prepared));
  expect(false);
}

void SurfaceGrowth::replay(const Replay& replay) {
  worker_.replay(replay);
  expect(replay.to != Replay::To::step);
}

void SurfaceGrowth::pause() {
  worker_.pause();
  expect(false);
}

void SurfaceGrowth::goTo(int iteration) {
  worker_.goTo(iteration);
  expect(false);
}

void SurfaceGrowth::stepBack() {
  worker_.stepBack();
  expect(false);
}

void SurfaceGrowth::goToPreviousEvent() {
  worker_.goToPreviousEvent();
  expect(false);
}

void SurfaceGrowth::goBefore(const WallList& walls) {
  worker_.goBefore(walls);
  expect(false);
}

bool SurfaceGrowth::takeLists(GrowthUpdate& update) {
  const bool changed = update.summariesFrom != summaries_.size() || !update.summaries.empty();
  summaries_.resize(update.summariesFrom);
  summaries_.insert(summaries_.end(), update.summaries.begin(), update.summaries.end());
  events_.resize(update.eventsFrom);
  std::move(update.events.begin(), update.events.end(), std::back_inserter(events_));
  return changed;
}

void SurfaceGrowth::collect() {
  GrowthUpdate update = worker_.collect();
  if (!exists() || update.processed < started_) return;  // of an earlier growth
  const bool listsChanged = takeLists(update);
  const bool shownChanged = update.snapshot != nullptr;
  if (shownChanged) snapshot_ = std::move(update.snapshot);
  request_ = std::move(update.request);
  changes_ = std::move(update.changes);
  corrections_ = std::move(update.corrections);
  resolved_ = std::move(update.resolved);
  leaks_ = std::move(update.leaks);
  questions_ = std::move(update.questions);
  const bool leaked = update.leaked && !leaks_.empty();
  seconds_ = update.seconds;
  stopReason_ = update.stopReason;
  processed_ = update.processed;
  if (update.processed >= expected_) {
    running_ = update.running;
    replayLeft_ = update.replayLeft;
    error_ = update.error;
  }
  if (listsChanged) listener_.summariesChanged();
  if (shownChanged) listener_.snapshotChanged();
  for (const auto& [index, trace] : update.traces) listener_.traced(index, trace);
  listener_.stateChanged();
  if (update.asked) listener_.asked();
  if (leaked) listener_.leaked(static_cast<int>(leaks_.size()) - 1);
}

}  // namespace handlebody::ui
