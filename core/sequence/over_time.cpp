#include "core/sequence/over_time.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "core/errors.h"
#include "core/mesh/validity.h"
#include "core/sequence/carried_seeds.h"

namespace handlebody {

namespace {

std::string counted(int n, const char* one, const char* several) {
  return std::to_string(n) + " " + (n == 1 ? one : several);
}

std::string topologyText(int components, int genus) {
  return counted(components, "component", "components") + " of genus " + std::to_string(genus);
}

std::string millilitres(double volume) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g ml", volume / 1000);
  return text;
}

void measure(FrameResult& result) {
  const Certificate c = examine(result.mesh);
  result.volume = c.volume;
  result.components = c.components;
  result.genus = std::accumulate(c.genus.begin(), c.genus.end(), 0);
}

//! Of the candidates but the one that was asked for (from 1) that whose volume is nearest, if it is no jump.
std::optional<int> nearestOther(const std::vector<ObjectCandidate>& candidates, int asked, double volume) {
  std::optional<int> nearest;
  double least = std::log(kJump);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double apart = std::abs(std::log(candidates[i].volume / volume));
    if (static_cast<int>(i) + 1 == asked || !(apart < least)) continue;
    least = apart;
    nearest = static_cast<int>(i) + 1;
  }
  return nearest;
}

bool isJump(double before, double now, int frames) {
  const double ratio = now > before ? now / before : before / now;
  return !(ratio <= std::pow(kJump, frames));
}

}  // namespace

const char* frameFaultName(FrameFault fault) {
  switch (fault) {
    case FrameFault::unreadable:
      return "unreadable";
    case FrameFault::noObject:
      return "no-object";
    case FrameFault::vanished:
      return "vanished";
    case FrameFault::leaked:
      return "leaked";
    case FrameFault::jumped:
      return "jumped";
    case FrameFault::changed:
      return "topology-changed";
    case FrameFault::otherObject:
      return "other-object";
    case FrameFault::held:
      return "topology-held";
    default:
      return "unfinished";
  }
}

bool isFailure(FrameFault fault) {
  return fault == FrameFault::unreadable || fault == FrameFault::noObject || fault == FrameFault::vanished ||
         fault == FrameFault::leaked || fault == FrameFault::jumped;
}

bool FrameResult::isTrusted() const {
  for (const ToldFault& f : faults)
    if (isFailure(f.fault)) return false;
  return !mesh.triangles.empty();
}

FrameCarrier::FrameCarrier(OverTimeSettings settings, Hooks hooks)
    : settings_(std::move(settings)), hooks_(std::move(hooks)) {
  Request& r = settings_.request;
  r.parameters.edgeLength = settings_.edgeLength;
  r.parameters.smoothing = settings_.smoothing;
  r.parameters.direction = Direction::both;
  r.constraints.vetoes.clear();
  r.constraints.pins.clear();
  r.constraints.edits.clear();
}

FrameResult FrameCarrier::attempt(const FrameResult& from, int frame, const Volume& volume, int candidate,
                                  std::vector<ObjectCandidate>& candidates) const {
  FrameResult result;
  result.frame = frame;
  result.from = from.frame;
  const Request& r = settings_.request;
  Parameters parameters = r.parameters;
  parameters.candidate = candidate;
  std::optional<ActiveContour> made;
  try {
    ActiveContour& contour = made.emplace(volume, carriedSeeds(r.seeds, from.mesh, settings_.edgeLength),
                                          parameters, r.constraints);
    contour.startFrom(Mesh(from.mesh), settings_.holdTopology);
    while (contour.stopReason() == StopReason::running) {
      const StepReport step = contour.step();
      for (const Leak& leak : step.leaks)
        result.faults.push_back({FrameFault::leaked, "the surface leaked: " + sentence(leak)});
    }
    judge(from, contour, result);
  } catch (const SeedError& error) {
    result.faults.push_back({FrameFault::noObject, error.what()});
  } catch (const UsageError& error) {  // a wall or a range that does not go with this frame
    result.faults.push_back({FrameFault::noObject, error.what()});
  }
  if (made && !result.isTrusted()) candidates = made->candidates();
  return result;
}

FrameResult FrameCarrier::tried(const FrameResult& from, int frame) const {
  const int asked = settings_.request.parameters.candidate;
  const Volume volume = hooks_.load(frame);
  std::vector<ObjectCandidate> candidates;
  FrameResult result = attempt(from, frame, volume, asked, candidates);
  if (result.isTrusted()) return result;
  const std::optional<int> other = nearestOther(candidates, asked, from.volume);
  if (!other) return result;
  FrameResult second = attempt(from, frame, volume, *other, candidates);
  if (!second.isTrusted()) return result;
  second.faults.push_back({FrameFault::otherObject, "another object is likelier there, but it fails (" +
                                                        result.faults.front().sentence + "); candidate " +
                                                        std::to_string(*other) + " was taken"});
  return second;
}

FrameResult FrameCarrier::carry(const FrameResult& from, int frame) const {
  const auto begin = std::chrono::steady_clock::now();
  FrameResult result;
  try {
    result = tried(from, frame);
  } catch (const InputError& error) {
    result.frame = frame;
    result.from = from.frame;
    result.faults.push_back({FrameFault::unreadable, error.what()});
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

void FrameCarrier::judge(const FrameResult& from, const ActiveContour& contour, FrameResult& result) const {
  const auto tell = [&](FrameFault fault, const std::string& sentence) {
    result.faults.push_back({fault, sentence});
  };
  result.iterations = contour.iteration();
  result.stopped = contour.stopReason();
  if (result.stopped == StopReason::empty) return tell(FrameFault::vanished, "the surface vanished");
  result.mesh = hooks_.finish(contour.mesh().compact());
  measure(result);
  if (isJump(from.volume, result.volume, std::abs(result.frame - from.frame)))
    tell(FrameFault::jumped, "the volume jumps from " + millilitres(from.volume) + " in frame " +
                                 std::to_string(from.frame) + " to " + millilitres(result.volume));
  if (result.components != from.components || result.genus != from.genus)
    tell(FrameFault::changed, "the topology changes from " + topologyText(from.components, from.genus) +
                                  " to " + topologyText(result.components, result.genus));
  if (const auto held = contour.held(); !held.empty())
    tell(FrameFault::held, "the topology was held at " +
                               counted(static_cast<int>(held.size()), "place", "places") + ", the first at " +
                               written(held.front().place) + " mm");
  if (result.stopped != StopReason::converged)
    tell(FrameFault::unfinished, std::string("the surface was not at rest of its own accord (") +
                                     stopReasonName(result.stopped) + ")");
}

std::vector<FrameResult> carryThrough(const FrameCarrier& carrier, const FrameResult& start, int last,
                                      const std::function<void(const FrameResult&)>& told) {
  std::vector<FrameResult> results;
  const int step = last < start.frame ? -1 : 1;
  FrameResult from = start;
  for (int frame = start.frame; frame != last;) {
    frame += step;
    results.push_back(carrier.carry(from, frame));
    if (told) told(results.back());
    if (results.back().isTrusted()) from = results.back();
  }
  return results;
}

}  // namespace handlebody
