#include "ui/model/growth_worker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/cancellation.h"
#include "core/errors.h"
#include "ui/model/error_sentence.h"
#include "ui/model/snapshot.h"

namespace handlebody::ui {

GrowthWorker::GrowthWorker(std::function<void()> notify)
    : notify_(std::move(notify)), thread_([this](const std::stop_token& stop) { loop(stop); }) {}
GrowthWorker::~GrowthWorker() {
  thread_.request_stop();
  const std::lock_guard lock(mutex_);  // next() sets it as well
  endsStep_ = true;
}

void GrowthWorker::send(Command command, Urgency urgency) {
  {
    const std::lock_guard lock(mutex_);
    // A slider that is dragged asks for many iterations; only the newest counts.
    int count = 1;
    if (urgency == Urgency::goesTo && !commands_.empty() && commands_.back().urgency == urgency) {
      count += commands_.back().count;
      commands_.pop_back();
    }
    commands_.push_back({std::move(command), urgency, count});
    if (urgency != Urgency::normal) endsStep_ = true;
  }
  ++sent_;
  changed_.notify_all();
}

void GrowthWorker::start(std::shared_ptr<const ActiveContour> contour) {
  send(
      [this, contour = std::move(contour)] {
        mode_ = Mode::idle;
        seconds_ = 0;
        framed_ = kept_ = -1;
        leaks_.clear();
        questions_.clear();
        replayLeft_ = false;
        history_.emplace(*contour);
      },
      Urgency::endsStep);
}

void GrowthWorker::clear() {
  send(
      [this] {
        mode_ = Mode::idle;
        history_.reset();
      },
      Urgency::endsStep);
}

void GrowthWorker::run(const Request& request, PreparedContour prepared) {
  send([this, request, prepared = std::move(prepared)] { goOn(request, prepared.get(), Mode::run); });
}

void GrowthWorker::runToEvent(const Request& request, PreparedContour prepared) {
  send([this, request, prepared = std::move(prepared)] { goOn(request, prepared.get(), Mode::toEvent); });
}

void GrowthWorker::step(const Request& request, PreparedContour prepared) {
  send([this, request, prepared = std::move(prepared)] {
    const std::optional<Request> before = history_ ? std::optional(nextRequest()) : std::nullopt;
    tryEdit(request, prepared.get());
    goOn(request, prepared.get(), Mode::run);
    const bool canGoOn = mode_ == Mode::run;
    mode_ = Mode::idle;
    try {
      if (canGoOn) stepOnce();
    } catch (const UsageError&) {
      change(*before);
      throw;
    }
  });
}

void GrowthWorker::replay(const Replay& replay) {
  send([this, replay] {
    replay_ = replay;
    replayLeft_ = true;
    mode_ = Mode::replay;
  });
}

void GrowthWorker::pause() {
  send([this] { mode_ = Mode::idle; }, Urgency::endsStep);
}

void GrowthWorker::goTo(int iteration) {
  send([this, iteration] { show(iteration); }, Urgency::goesTo);
}

void GrowthWorker::stepBack() {
  send([this] { show(history_ ? history_->iteration() - 1 : 0); }, Urgency::endsStep);
}

void GrowthWorker::goToPreviousEvent() {
  send(
      [this] {
        if (!history_) return;
        int at = history_->iteration() - 1;
        while (at > history_->firstIteration() && !isEventIteration(at)) --at;
        show(at);
      },
      Urgency::endsStep);
}

void GrowthWorker::goBefore(const WallList& walls) {
  send([this, walls] { showBefore(walls); }, Urgency::endsStep);
}

void GrowthWorker::trace(int index) {
  send([this, index] { traceEvent(index); });
}

void GrowthWorker::setStepsPerFrame(int steps) {
  const std::lock_guard lock(mutex_);
  stepsPerFrame_ = std::max(1, steps);
}

void GrowthWorker::setPausesAtLeaks(bool on) {
  const std::lock_guard lock(mutex_);
  pausesAtLeaks_ = on;
}

GrowthUpdate GrowthWorker::collect() {
  const std::lock_guard lock(mutex_);
  GrowthUpdate out = update_;
  out.summariesFrom = knownSummaries_;
  out.summaries.assign(summaries_.begin() + static_cast<std::ptrdiff_t>(knownSummaries_), summaries_.end());
  out.eventsFrom = knownEvents_;
  out.events.assign(events_.begin() + static_cast<std::ptrdiff_t>(knownEvents_), events_.end());
  knownSummaries_ = summaries_.size();
  knownEvents_ = events_.size();
  update_.snapshot.reset();
  update_.traces.clear();
  update_.leaked = update_.asked = false;
  notified_ = false;
  return out;
}

// --- on the worker's thread ---

void GrowthWorker::loop(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (const std::optional<Command> command = next(stop))
      perform(*command);
    else if (mode_ != Mode::idle)
      perform([this] { stepOnce(); });
  }
}

std::optional<GrowthWorker::Command> GrowthWorker::next(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, stop, [this] { return !commands_.empty() || mode_ != Mode::idle; });
  if (commands_.empty() || stop.stop_requested()) return std::nullopt;
  Sent sent = std::move(commands_.front());
  commands_.pop_front();
  endsStep_ = std::any_of(commands_.begin(), commands_.end(),
                          [](const auto& c) { return c.urgency != Urgency::normal; });
  done_ += sent.count;
  error_.clear();
  return std::move(sent.command);
}

void GrowthWorker::perform(const Command& command) {
  const int before = history_ ? history_->iteration() : -1;
  std::shared_ptr<const MeshSnapshot> frame;
  try {
    command();
    if (history_ && history_->iteration() != before) ++sinceFrame_;
    frame = nextFrame();
  } catch (const Cancelled&) {  // the next command says what is wanted instead
  } catch (...) {
    error_ = errorSentence();
    mode_ = Mode::idle;
    replayLeft_ = false;
  }
  publish(std::move(frame));
}

//! At rest the iteration is always shown, and checked in full; on the way a frame is left out while the last
//! one was not fetched.
std::shared_ptr<const MeshSnapshot> GrowthWorker::nextFrame() {
  const bool atRest = mode_ == Mode::idle;
  if (!history_ || (framed_ == history_->iteration() && (framedInFull_ || !atRest))) return nullptr;
  if (!atRest) {
    const std::lock_guard lock(mutex_);
    if (sinceFrame_ < stepsPerFrame_ || update_.snapshot) return nullptr;
  }
  auto frame = makeSnapshot(*history_, atRest ? Checking::everything : Checking::structure);
  framed_ = frame->iteration;
  framedInFull_ = atRest;
  sinceFrame_ = 0;
  return frame;
}

void GrowthWorker::change(const Request& request, const ActiveContour* prepared) {
  history_->change(request, prepared);
  kept_ = std::min(kept_, history_->lastIteration());
  std::erase_if(leaks_, [&](const FoundLeak& f) { return f.leak.iteration > history_->lastIteration(); });
  std::erase_if(questions_, [&](const HeldPlace& h) { return h.iteration > history_->lastIteration(); });
}

void GrowthWorker::goOn(const Request& request, const ActiveContour* prepared, Mode mode) {
  mode_ = Mode::idle;
  replayLeft_ = false;
  if (!history_) return;
  {
    const CancelScope scope(endsStep_);  // other clicks may take seconds
    change(request, prepared);
  }
  if (mode == Mode::toEvent && goToRecordedEvent()) return;
  if (history_->stopReason() == StopReason::running) mode_ = mode;
}

//! On a copy, where iterations are recorded after the shown one: a refusal must not have dropped them. Throws
//! as the step does.
void GrowthWorker::tryEdit(const Request& request, const ActiveContour* prepared) {
  if (!history_ || history_->iteration() == history_->lastIteration() || request == nextRequest()) return;
  const auto isNext = [this](const MeshEdit& e) { return e.iteration == history_->iteration() + 1; };
  const std::vector<MeshEdit>& edits = request.constraints.edits;
  if (std::none_of(edits.begin(), edits.end(), isNext)) return;
  const CancelScope scope(endsStep_);
  ActiveContour trial = history_->shown();
  if (prepared && prepared->request() == request)
    trial.change(*prepared);
  else
    trial.change(request);
  if (trial.stopReason() == StopReason::running) trial.step();
}

//! What the next step from the shown iteration is done with.
Request GrowthWorker::nextRequest() const {
  return {history_->seeds(), history_->parameters(), history_->constraints()};
}

//! False, and at the last iteration, if no event is recorded after the shown one.
bool GrowthWorker::goToRecordedEvent() {
  const int last = history_->lastIteration();
  int at = history_->iteration() + 1;
  while (at <= last && !isEventIteration(at)) ++at;
  history_->goTo(std::min(at, last));
  return at <= last;
}

void GrowthWorker::stepOnce() {
  const CancelScope scope(endsStep_);
  if (mode_ == Mode::replay && !replayChange()) return;
  const int last = history_->lastIteration();
  const auto start = std::chrono::steady_clock::now();
  history_->advance();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  const bool isNew = history_->lastIteration() > last;
  if (isNew) seconds_ += spent.count();
  if (mode_ == Mode::replay && history_->iteration() == replay_.stopAt) replayLeft_ = false;
  if ((isNew && isToPause() && mode_ != Mode::replay) || hasReached()) mode_ = Mode::idle;
}

//! For what the step just made has told.
bool GrowthWorker::isToPause() {
  const bool atLeak = noticeLeaks(), atQuestion = noticeQuestions();
  return atLeak || atQuestion;
}

//! Of the step just made. True if the growth is to pause at them.
bool GrowthWorker::noticeLeaks() {
  const std::vector<Leak>& found = history_->steps().back().leaks;
  for (const Leak& leak : found) leaks_.push_back({leak, history_->lastBefore(leak)});
  hasLeaked_ = hasLeaked_ || !found.empty();
  const std::lock_guard lock(mutex_);
  return pausesAtLeaks_ && !found.empty();
}

//! The same of what a limit that asks has begun to hold.
bool GrowthWorker::noticeQuestions() {
  const std::vector<HeldPlace>& found = history_->steps().back().questions;
  questions_.insert(questions_.end(), found.begin(), found.end());
  hasAsked_ = hasAsked_ || !found.empty();
  return !found.empty();
}

//! The change that the session recorded here, if any. False if the replay ends here.
bool GrowthWorker::replayChange() {
  const int now = history_->iteration();
  for (const ParameterChange& recorded : replay_.changes)
    if (recorded.iteration == now && now < replay_.stopAt.value_or(now + 1))
      change(changed(nextRequest(), recorded));
  const bool goesOn = history_->stopReason() == StopReason::running && now < replay_.stopAt.value_or(now + 1);
  if (!goesOn) {
    mode_ = Mode::idle;
    replayLeft_ = false;
  }
  return goesOn;
}

bool GrowthWorker::hasReached() const {
  const auto isEvent = [this] { return isEventIteration(history_->iteration()); };
  if (mode_ == Mode::replay)  // the next change may let it go on
    return replay_.to == Replay::To::step || (replay_.to == Replay::To::event && isEvent());
  if (history_->stopReason() != StopReason::running) return true;
  return mode_ == Mode::toEvent && isEvent();
}

bool GrowthWorker::isEventIteration(int iteration) const {
  const std::vector<Event>& events = history_->events();
  return std::any_of(events.begin(), events.end(),
                     [&](const Event& e) { return e.iteration == iteration && changesTopology(e.kind); });
}

void GrowthWorker::show(int iteration) {
  mode_ = Mode::idle;
  if (history_) history_->goTo(std::clamp(iteration, history_->firstIteration(), history_->lastIteration()));
}

void GrowthWorker::showBefore(const WallList& walls) {
  mode_ = Mode::idle;
  if (!history_) return;
  const CancelScope scope(endsStep_);
  show(history_->lastFree(walls).value_or(history_->firstIteration()));
}

void GrowthWorker::traceEvent(int index) {
  if (!history_ || index < 0 || index >= static_cast<int>(history_->events().size())) return;
  const std::vector<Event>& events = history_->events();
  const int iteration = events[index].iteration;
  int nth = index;  // among those of its iteration
  while (nth > 0 && events[nth - 1].iteration == iteration) --nth;
  std::vector<Event> traced = history_->traced(iteration);
  const auto at = static_cast<std::size_t>(index - nth);
  if (at >= traced.size()) return;
  const std::lock_guard lock(mutex_);
  update_.traces.emplace_back(index, std::move(traced[at].trace));
}

void GrowthWorker::publish(std::shared_ptr<const MeshSnapshot> frame) {
  {
    const std::lock_guard lock(mutex_);
    publishLists();
    update_.processed = done_;
    update_.running = mode_ != Mode::idle;
    update_.error = error_;
    update_.seconds = seconds_;
    update_.replayLeft = replayLeft_;
    if (frame || !history_) update_.snapshot = std::move(frame);
    if (history_) {
      update_.stopReason = history_->stopReason();
      update_.request = nextRequest();
      update_.resolved = history_->resolved();
      update_.changes = history_->changes();
      update_.leaks = leaks_;
      update_.questions = questions_;
      update_.corrections = history_->corrections();
      update_.leaked = std::exchange(hasLeaked_, false) || update_.leaked;
      update_.asked = std::exchange(hasAsked_, false) || update_.asked;
    }
  }
  notifyOnce();
}

//! Replaces what no longer holds and adds what is new.
void GrowthWorker::publishLists() {
  const int kept = history_ ? kept_ : -1;
  std::erase_if(summaries_, [&](const IterationSummary& s) { return s.iteration > kept; });
  std::erase_if(events_, [&](const Event& e) { return e.iteration > kept; });
  knownSummaries_ = std::min(knownSummaries_, summaries_.size());
  knownEvents_ = std::min(knownEvents_, events_.size());
  if (!history_) return;
  const std::vector<IterationSummary> more = summariesFrom(*history_, summaries_.size());
  summaries_.insert(summaries_.end(), more.begin(), more.end());
  const std::vector<Event>& all = history_->events();
  events_.insert(events_.end(), all.begin() + static_cast<std::ptrdiff_t>(events_.size()), all.end());
  kept_ = history_->lastIteration();
}

void GrowthWorker::notifyOnce() {
  {
    const std::lock_guard lock(mutex_);
    if (notified_) return;
    notified_ = true;
  }
  notify_();
}

}  // namespace handlebody::ui
