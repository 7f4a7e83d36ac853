#include "core/evolution/history.h"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "core/evolution/wall_guard.h"
#include "core/evolution/wall_pieces.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

StepReport beginning(const ActiveContour& contour) {
  StepReport report;
  report.iteration = contour.iteration();
  report.movedVertices = contour.mesh().vertexCount();
  report.volume = signedVolume(contour.mesh());
  return report;
}

//! The number of threads changes no mesh.
bool sameResult(Request a, const Request& b) {
  a.parameters.threads = b.parameters.threads;
  return a == b;
}

}  // namespace

History::History(ActiveContour start, const HistoryLimits& limits)
    : limits_(limits), shown_(std::move(start)) {
  steps_.push_back(beginning(shown_));
  keep(shown_);
}

const History::Change* History::changeAt(int iteration) const {
  const auto at = std::find_if(changes_.begin(), changes_.end(),
                               [&](const Change& c) { return c.what.iteration == iteration; });
  return at == changes_.end() ? nullptr : &*at;
}

const ActiveContour& History::next() const {
  const Change* change = changeAt(iteration());
  return change ? change->after : shown_;
}

StopReason History::stopReason() const { return next().stopReason(); }

StepReport History::stepFrom(ActiveContour& contour) const {
  const Change* change = changeAt(contour.iteration());
  if (!change) return contour.step();
  ActiveContour changed = change->after;  // a step that throws leaves the contour without the change
  StepReport report = changed.step();
  contour = std::move(changed);
  return report;
}

void History::advance() {
  assert(stopReason() == StopReason::running);
  const int before = iteration();
  const auto start = std::chrono::steady_clock::now();
  try {
    StepReport report = stepFrom(shown_);
    if (before < lastIteration()) return;
    sinceKeyframe_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    record(std::move(report));
  } catch (...) {  // not enough memory, say: a step that was broken off leaves no mesh to go on with
    if (shown_.iteration() > before) shown_ = restored(before);
    throw;
  }
}

void History::record(StepReport report) {
  std::move(report.events.begin(), report.events.end(), std::back_inserter(events_));
  report.events.clear();
  steps_.push_back(std::move(report));
  if (sinceKeyframe_ >= limits_.redoSeconds) keep(shown_);
}

void History::keep(const ActiveContour& contour) {
  const Keyframe* before = keyframes_.empty() ? nullptr : &keyframes_.rbegin()->second;
  if (before && before->iteration() == contour.iteration()) return;
  const Keyframe& kept = keyframes_.try_emplace(contour.iteration(), contour, before).first->second;
  sinceKeyframe_ = 0;
  memory_ += kept.memoryBeside(before);
  while (memory_ > limits_.memory && keyframes_.size() > 2) thinOut();
}

//! Every second keyframe goes, and new ones come half as often; the first and the last stay.
void History::thinOut() {
  limits_.redoSeconds *= 2;
  for (auto at = std::next(keyframes_.begin());
       at != keyframes_.end() && std::next(at) != keyframes_.end();) {
    at = keyframes_.erase(at);
    if (at != keyframes_.end()) ++at;
  }
  countMemory();
}

void History::countMemory() {
  memory_ = 0;
  const Keyframe* before = nullptr;
  for (const auto& [iteration, keyframe] : keyframes_) {
    memory_ += keyframe.memoryBeside(before);
    before = &keyframe;
  }
  for (const Change& change : changes_) memory_ += change.after.memory();
}

ActiveContour History::restored(int iteration) const {
  const Keyframe& keyframe = std::prev(keyframes_.upper_bound(iteration))->second;
  const ActiveContour* nearest = nullptr;  // nearer than the keyframe
  int from = keyframe.iteration();
  if (shown_.iteration() <= iteration && shown_.iteration() > from) {
    nearest = &shown_;
    from = shown_.iteration();
  }
  // At its own iteration a change has no effect yet.
  for (const Change& change : changes_)
    if (change.what.iteration < iteration && change.what.iteration >= from) {
      nearest = &change.after;
      from = change.what.iteration;
    }
  ActiveContour contour = nearest ? *nearest : keyframe.contour();
  while (contour.iteration() < iteration) stepFrom(contour);
  return contour;
}

void History::goTo(int iteration) {
  assert(iteration >= firstIteration() && iteration <= lastIteration());
  if (iteration == this->iteration()) return;
  if (this->iteration() == lastIteration()) keep(shown_);  // coming back to the end is quick then
  shown_ = restored(iteration);
}

void History::change(const Request& request, const ActiveContour* prepared) {
  if (sameResult(request, next().request())) return;
  const bool isOther = !sameResult(request, shown_.request());
  ActiveContour after = shown_;
  if (isOther && prepared && prepared->request() == request)
    after.change(*prepared);
  else if (isOther)
    after.change(request);
  dropAfter(iteration());
  if (isOther) {
    ParameterChange what{iteration(), request.parameters, {}, {}};
    if (request.seeds != shown_.requestedSeeds()) what.seeds = request.seeds;
    if (request.constraints != shown_.constraints()) what.constraints = request.constraints;
    changes_.push_back({std::move(what), std::move(after)});
  }
  countMemory();
}

void History::dropAfter(int iteration) {
  keyframes_.erase(keyframes_.upper_bound(iteration), keyframes_.end());
  std::erase_if(changes_, [&](const Change& c) { return c.what.iteration >= iteration; });
  std::erase_if(events_, [&](const Event& e) { return e.iteration > iteration; });
  std::erase_if(steps_, [&](const StepReport& s) { return s.iteration > iteration; });
  sinceKeyframe_ = 0;
}

int History::lastBefore(const Leak& leak) const {
  return lastFree({{}, {}, {}, {leak.disc}}).value_or(std::max(firstIteration(), leak.iteration - 1));
}

std::optional<int> History::lastFree(const WallList& walls) const {
  const WallList fresh = without(walls, constraints().walls);
  const auto freeAt = [&](const ActiveContour& c) { return isFree(c.mesh(), fresh, c.grid()); };
  if (freeAt(shown_)) return iteration();
  // From keyframe to keyframe backwards; between two of them every step is done again.
  for (int end = iteration(); end > firstIteration();) {
    const int begin = std::prev(keyframes_.lower_bound(end))->first;
    std::optional<int> last;
    ActiveContour contour = restored(begin);
    for (; contour.iteration() < end; stepFrom(contour))
      if (freeAt(contour)) last = contour.iteration();
    if (last) return last;
    end = begin;
  }
  return std::nullopt;
}

std::vector<ParameterChange> History::changes() const {
  std::vector<ParameterChange> out;
  for (const Change& change : changes_) out.push_back(change.what);
  return out;
}

std::vector<RecordedCorrection> History::corrections() const {
  std::vector<RecordedCorrection> out;
  for (const Change& change : changes_)
    if (change.what.seeds) out.push_back({change.what.iteration, change.after.correction().value()});
  return out;
}

std::vector<Event> History::traced(int iteration) const {
  assert(iteration > firstIteration() && iteration <= lastIteration());
  ActiveContour contour = restored(iteration - 1);
  if (const Change* change = changeAt(contour.iteration())) contour = change->after;
  contour.recordTraces(true);
  return contour.step().events;
}

}  // namespace handlebody
