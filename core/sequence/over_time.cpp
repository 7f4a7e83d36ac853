#include "core/sequence/over_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
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

bool FrameCorrection::operator==(const FrameCorrection& o) const {
  const auto areAlike = [](const ParameterChange& a, const ParameterChange& b) {
    return a.iteration == b.iteration && a.parameters == b.parameters && a.seeds == b.seeds &&
           a.constraints == b.constraints;
  };
  return frame == o.frame && request == o.request && stopAt == o.stopAt &&
         std::equal(changes.begin(), changes.end(), o.changes.begin(), o.changes.end(), areAlike);
}

Request finalRequest(const FrameCorrection& correction) {
  Request request = correction.request;
  for (const ParameterChange& change : correction.changes) request = changed(request, change);
  return request;
}

Request carriedRequest(const OverTimeSettings& settings, int frame) {
  const FrameCorrection* nearest = nullptr;  // between the grown frame and this one
  const int home = settings.grownFrame;
  for (const FrameCorrection& c : settings.corrections) {
    const bool isBetween =
        frame > home ? c.frame > home && c.frame <= frame : c.frame < home && c.frame >= frame;
    if (isBetween && (!nearest || std::abs(c.frame - home) > std::abs(nearest->frame - home))) nearest = &c;
  }
  Request r = settings.request;
  if (nearest) {
    const Request last = finalRequest(*nearest);
    r.seeds = last.seeds;
    r.constraints = last.constraints;
    r.parameters.candidate = last.parameters.candidate;
  }
  r.parameters.edgeLength = settings.edgeLength;
  r.parameters.smoothing = settings.smoothing;
  r.parameters.direction = Direction::both;
  r.constraints.start.reset();  // it begins with the surface that is carried
  r.constraints.vetoes.clear();
  r.constraints.pins.clear();
  r.constraints.edits.clear();
  return r;
}

FrameCarrier::FrameCarrier(OverTimeSettings settings, Hooks hooks)
    : settings_(std::move(settings)), hooks_(std::move(hooks)) {}

//! Only on the way out: what comes back from the ends starts from other surfaces.
const FrameCorrection* FrameCarrier::correctionOf(int from, int frame) const {
  const int home = settings_.grownFrame;
  const bool isOut = (frame > from) == (frame > home) && (frame > from ? from >= home : from <= home);
  for (const FrameCorrection& c : settings_.corrections)
    if (isOut && c.frame == frame) return &c;
  return nullptr;
}

FrameResult FrameCarrier::corrected(const FrameCorrection& correction, const FrameResult& from) const {
  FrameResult result;
  result.frame = correction.frame;
  result.from = from.frame;
  const Volume volume = hooks_.load(correction.frame);
  const Request& r = correction.request;
  try {
    ActiveContour contour(volume, r.seeds, r.parameters, r.constraints);
    contour.startFrom(Mesh(from.mesh), settings_.holdTopology);
    auto change = correction.changes.begin();
    while (contour.iteration() < correction.stopAt.value_or(std::numeric_limits<int>::max())) {
      if (change != correction.changes.end() && change->iteration == contour.iteration()) {
        contour.change(changed(contour.request(), *change));
        ++change;
      }
      if (contour.stopReason() != StopReason::running) break;
      for (const Leak& leak : contour.step().leaks)
        result.faults.push_back({FrameFault::leaked, "the surface leaked: " + sentence(leak)});
    }
    judge(from, contour, result);
    // Where it was stopped by hand that is what was meant.
    if (correction.stopAt)
      std::erase_if(result.faults, [](const ToldFault& f) { return f.fault == FrameFault::unfinished; });
  } catch (const SeedError& error) {
    result.faults.push_back({FrameFault::noObject, error.what()});
  } catch (const UsageError& error) {
    result.faults.push_back({FrameFault::noObject, error.what()});
  }
  return result;
}

FrameResult FrameCarrier::attempt(const FrameResult& from, int frame, const Volume& volume, int candidate,
                                  std::vector<ObjectCandidate>& candidates) const {
  FrameResult result;
  result.frame = frame;
  result.from = from.frame;
  const Request r = carriedRequest(settings_, frame);
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
  const int asked = carriedRequest(settings_, frame).parameters.candidate;
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
    const FrameCorrection* correction = correctionOf(from.frame, frame);
    result = correction ? corrected(*correction, from) : tried(from, frame);
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
