#include "core/evolution/history.h"

#include <algorithm>
#include <cassert>
#include <chrono>

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
bool sameResult(Parameters a, const Parameters& b) {
  a.threads = b.threads;
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

StopReason History::stopReason() const {
  const Change* change = changeAt(iteration());
  return change ? change->after.stopReason() : shown_.stopReason();
}

const Parameters& History::parameters() const {
  const Change* change = changeAt(iteration());
  return change ? change->what.parameters : shown_.requested();
}

const ResolvedParameters& History::resolved() const {
  const Change* change = changeAt(iteration());
  return change ? change->after.parameters() : shown_.parameters();
}

StepReport History::stepFrom(ActiveContour& contour) const {
  if (const Change* change = changeAt(contour.iteration())) contour = change->after;
  return contour.step();
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
  if (!keyframes_.emplace(contour.iteration(), contour).second) return;
  sinceKeyframe_ = 0;
  memory_ += contour.memory();
  if (memory_ > limits_.memory) thinOut();
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
  for (const auto& [iteration, contour] : keyframes_) memory_ += contour.memory();
  for (const Change& change : changes_) memory_ += change.after.memory();
}

ActiveContour History::restored(int iteration) const {
  const ActiveContour* nearest = &std::prev(keyframes_.upper_bound(iteration))->second;
  if (shown_.iteration() <= iteration && shown_.iteration() > nearest->iteration()) nearest = &shown_;
  // At its own iteration a change has no effect yet.
  for (const Change& change : changes_)
    if (change.what.iteration < iteration && change.what.iteration >= nearest->iteration())
      nearest = &change.after;
  ActiveContour contour = *nearest;
  while (contour.iteration() < iteration) stepFrom(contour);
  return contour;
}

void History::goTo(int iteration) {
  assert(iteration >= firstIteration() && iteration <= lastIteration());
  if (iteration == this->iteration()) return;
  if (this->iteration() == lastIteration()) keep(shown_);  // coming back to the end is quick then
  shown_ = restored(iteration);
}

void History::changeParameters(const Parameters& parameters, const ActiveContour* prepared) {
  if (sameResult(parameters, this->parameters())) return;
  const bool isOther = !sameResult(parameters, shown_.requested());
  ActiveContour after = shown_;
  if (isOther && prepared && prepared->requested() == parameters)
    after.changeParameters(*prepared);
  else if (isOther)
    after.changeParameters(parameters);
  dropAfter(iteration());
  if (isOther) changes_.push_back({{iteration(), parameters}, std::move(after)});
  countMemory();
}

void History::dropAfter(int iteration) {
  keyframes_.erase(keyframes_.upper_bound(iteration), keyframes_.end());
  std::erase_if(changes_, [&](const Change& c) { return c.what.iteration >= iteration; });
  std::erase_if(events_, [&](const Event& e) { return e.iteration > iteration; });
  std::erase_if(steps_, [&](const StepReport& s) { return s.iteration > iteration; });
  sinceKeyframe_ = 0;
}

std::vector<ParameterChange> History::changes() const {
  std::vector<ParameterChange> out;
  for (const Change& change : changes_) out.push_back(change.what);
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
