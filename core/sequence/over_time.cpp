#include "core/sequence/over_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/evolution/clicked_object.h"
#include "core/mesh/validity.h"
#include "core/sequence/carried_seeds.h"
#include "core/solid/overlap.h"
#include "core/told_error.h"
#include "core/units.h"

namespace handlebody {

namespace {

using K = FindingKind;

//! With what an error says as its cause.
template <typename Error>
Finding causedBy(FindingKind kind, const Error& error) {
  return {kind, {}, saidBy(error)};
}

Finding topologyChange(const FrameResult& from, const FrameResult& to) {
  const K kind = from.components == 1 ? (to.components == 1 ? K::frameGenusChanged : K::frameCameApart)
                                      : (to.components == 1 ? K::frameCameTogether : K::frameTopologyChanged);
  return {kind,
          {{"components_before", from.components},
           {"genus_before", from.genus},
           {"components", to.components},
           {"genus", to.genus}}};
}

Finding holding(const std::vector<HeldPlace>& held) {
  return {held.size() == 1 ? K::frameHeldAtPlace : K::frameHeldAtPlaces,
          {{"places", held.size()}, {"place", placeValue(held.front().place)}}};
}

Finding unfinished(StopReason stopped) {
  const K kind = stopped == StopReason::maxIterations ? K::frameAtLimit
                 : stopped == StopReason::stuck       ? K::frameStuck
                                                      : K::frameFrozen;
  return {kind, {{"stopped", std::string(stopReasonName(stopped))}}};
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

// Chosen on ten sequences made of labelled images (docs/time.md): with 0.9 to 2 (always moved) mean Dice is
// the same to 0.002, and the higher the more often a frame rests on those before it.
constexpr double kAgrees = 0.95;

// Where nothing but the frame before says that there is something, most of it must be seen.
constexpr double kMaxUnshown = 0.5;

constexpr double kSteps = 48;  // along a cube of the same volume: where it is looked how far two agree

//! Dice of what the two surfaces enclose. Precondition: neither is empty.
double agreement(const TriangleSoup& a, const TriangleSoup& b) {
  const Solid first = solidOf(a), second = solidOf(b);
  const Overlap o = overlapOf(first, second, std::cbrt(std::abs(first.volume())) / kSteps);
  return o.a + o.b > 0 ? 2 * o.both / (o.a + o.b) : 0;
}

//! That `grow` finds no object is a fault of the frame; so is a wall or a range that does not go with it.
template <typename F>
void orNoObject(FrameResult& result, F&& grow) {
  try {
    grow();
  } catch (const SeedError& error) {
    result.faults.push_back({FrameFault::noObject, causedBy(K::frameNoObject, error)});
  } catch (const UsageError& error) {
    result.faults.push_back({FrameFault::noObject, causedBy(K::frameNoObject, error)});
  }
}

//! It was asked for at this iteration; or later, and the surface is at rest already: it starts from another
//! one than it did then.
bool isDue(const ParameterChange& change, const ActiveContour& contour) {
  const bool isAtRest =
      contour.stopReason() != StopReason::running && contour.stopReason() != StopReason::empty;
  return change.iteration == contour.iteration() || isAtRest;
}

//! Between the grown frame and this one, this one among them, in the order in which they are carried.
std::vector<const FrameCorrection*> correctionsUpTo(int frame, const OverTimeSettings& settings) {
  const int home = settings.grownFrame;
  std::vector<const FrameCorrection*> those;
  for (const FrameCorrection& c : settings.corrections)
    if (frame > home ? c.frame > home && c.frame <= frame : c.frame < home && c.frame >= frame)
      those.push_back(&c);
  const auto distance = [home](const FrameCorrection* c) { return std::abs(c->frame - home); };
  std::ranges::sort(those, {}, distance);
  return those;
}

//! Whether the object of the frame beside it is asked for. A range says by itself what it is in every frame,
//! and where the image shows nothing at all it does not show that either.
bool asksForMoved(const FrameResult& anew, bool isCloseChoice, const Parameters& asked) {
  if (anew.isTrusted()) return isCloseChoice;
  const auto isNone = [](const ToldFault& f) { return f.fault == FrameFault::noObject; };
  return !asked.range && std::none_of(anew.faults.begin(), anew.faults.end(), isNone);
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
    case FrameFault::fromFailed:
      return "from-failed";
    case FrameFault::otherObject:
      return "other-object";
    case FrameFault::movedObject:
      return "moved-object";
    case FrameFault::held:
      return "topology-held";
    default:
      return "unfinished";
  }
}

ToldFault leakFault(const Leak& leak) { return {FrameFault::leaked, {K::frameLeaked, {}, findingOf(leak)}}; }

bool isFailure(FrameFault fault) {
  return fault == FrameFault::unreadable || fault == FrameFault::noObject || fault == FrameFault::vanished ||
         fault == FrameFault::leaked || fault == FrameFault::jumped || fault == FrameFault::fromFailed;
}

std::vector<ToldFault> faultsAtEnd(StopReason stopped, const std::vector<HeldPlace>& held) {
  std::vector<ToldFault> faults;
  if (!held.empty()) faults.push_back({FrameFault::held, holding(held)});
  if (stopped == StopReason::maxIterations || stopped == StopReason::stuck || stopped == StopReason::frozen)
    faults.push_back({FrameFault::unfinished, unfinished(stopped)});
  return faults;
}

bool FrameResult::isTrusted() const {
  const auto isFromFailed = [](const ToldFault& f) { return f.fault == FrameFault::fromFailed; };
  return startsNext() && std::none_of(faults.begin(), faults.end(), isFromFailed);
}

bool FrameResult::startsNext() const {
  for (const ToldFault& f : faults)
    if (isFailure(f.fault) && f.fault != FrameFault::fromFailed) return false;
  return !mesh.triangles.empty();
}

bool FrameCorrection::operator==(const FrameCorrection& o) const {
  const auto areAlike = [](const ParameterChange& a, const ParameterChange& b) {
    return a.iteration == b.iteration && a.parameters == b.parameters && a.seeds == b.seeds &&
           a.constraints == b.constraints;
  };
  return frame == o.frame && request == o.request && stopAt == o.stopAt && isOfMoved == o.isOfMoved &&
         std::equal(changes.begin(), changes.end(), o.changes.begin(), o.changes.end(), areAlike);
}

Request finalRequest(const FrameCorrection& correction) {
  Request request = correction.request;
  for (const ParameterChange& change : correction.changes) request = changed(request, change);
  return request;
}

FrameCorrection withObject(FrameCorrection correction, const StartSurface& object) {
  correction.request.constraints.start = object;
  for (ParameterChange& change : correction.changes)
    if (change.constraints) change.constraints->start = object;
  return correction;
}

Request carriedRequest(const OverTimeSettings& settings, int frame, const std::optional<MovedObject>& moved) {
  Request r = settings.request;
  for (const FrameCorrection* c : correctionsUpTo(frame, settings)) {
    const Request last = finalRequest(*c);
    r.seeds = last.seeds;
    r.constraints = last.constraints;
    if (!c->isOfMoved) r.parameters.candidate = last.parameters.candidate;  // there it is no choice
  }
  r.parameters.edgeLength = settings.edgeLength;
  r.parameters.smoothing = settings.smoothing;
  r.parameters.direction = Direction::both;
  r.constraints.start.reset();  // it begins with the surface that is carried
  if (moved) {
    r.constraints.start = moved->given();
    r.parameters.candidate = 1;
  }
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

MovedObject FrameCarrier::movedFrom(const FrameResult& from, const Volume& volume) const {
  return movedObject(hooks_.load(from.shownIn.value_or(from.frame)), volume, from.mesh);
}

FrameResult FrameCarrier::corrected(const FrameCorrection& asked, const FrameResult& from) const {
  FrameResult result;
  result.frame = asked.frame;
  result.from = from.frame;
  result.isCorrected = true;
  const Volume volume = hooks_.load(asked.frame);
  if (asked.isOfMoved) result.moved = movedFrom(from, volume);
  const FrameCorrection correction = asked.isOfMoved ? withObject(asked, result.moved->given()) : asked;
  const Request& r = correction.request;
  orNoObject(result, [&] {
    ActiveContour contour(volume, r.seeds, r.parameters, r.constraints);
    const TriangleSoup& beginning = result.moved ? result.moved->beginning(from.mesh) : from.mesh;
    contour.startFrom(Mesh(beginning), settings_.holdTopology);
    auto change = correction.changes.begin();
    while (contour.iteration() < correction.stopAt.value_or(std::numeric_limits<int>::max())) {
      if (change != correction.changes.end() && isDue(*change, contour)) {
        contour.change(changed(contour.request(), *change++));
        continue;
      }
      if (contour.stopReason() != StopReason::running) break;
      for (const Leak& leak : contour.step().leaks) result.faults.push_back(leakFault(leak));
    }
    judge(from, contour, result);
    // Where it was stopped by hand that is what was meant.
    if (correction.stopAt)
      std::erase_if(result.faults, [](const ToldFault& f) { return f.fault == FrameFault::unfinished; });
  });
  return result;
}

FrameResult FrameCarrier::attempt(const FrameResult& from, int frame, const Volume& volume, int candidate,
                                  Meant& meant) const {
  FrameResult result;
  result.frame = frame;
  result.from = from.frame;
  const Request r = carriedRequest(settings_, frame);
  Parameters parameters = r.parameters;
  parameters.candidate = candidate;
  std::optional<ActiveContour> made;
  orNoObject(result, [&] {
    ActiveContour& contour = made.emplace(volume, carriedSeeds(r.seeds, from.mesh, settings_.edgeLength),
                                          parameters, r.constraints);
    contour.startFrom(Mesh(from.mesh), settings_.holdTopology);
    grow(contour, from, result);
  });
  if (!made) return result;
  // Not known yet: it is beyond doubt, and to look for it would take long.
  meant.isCloseChoice = made->choices()->areKnown() && made->isCloseChoice();
  if (!result.isTrusted()) meant.candidates = made->candidates();
  return result;
}

void FrameCarrier::grow(ActiveContour& contour, const FrameResult& from, FrameResult& result) const {
  while (contour.stopReason() == StopReason::running) {
    const StepReport step = contour.step();
    for (const Leak& leak : step.leaks) result.faults.push_back(leakFault(leak));
  }
  judge(from, contour, result);
}

FrameResult FrameCarrier::attemptMoved(const FrameResult& from, int frame, const Volume& volume,
                                       const MovedObject& moved, bool mustBeShown) const {
  FrameResult result;
  result.frame = frame;
  result.from = from.frame;
  result.moved = moved;
  const Request r = carriedRequest(settings_, frame, moved);
  const auto isShown = [&](const ActiveContour& contour) {
    return !mustBeShown || contour.support().withoutEdge <= kMaxUnshown;
  };
  orNoObject(result, [&] {
    ActiveContour contour(volume, carriedSeeds(r.seeds, *moved.surface, settings_.edgeLength), r.parameters,
                          r.constraints);
    contour.startFrom(Mesh(moved.beginning(from.mesh)), settings_.holdTopology);
    // Not grown where nothing is shown: there it would go on to the limit of the iterations.
    if (isShown(contour)) grow(contour, from, result);
    if (!isShown(contour)) result.mesh = {};
  });
  return result;
}

FrameResult FrameCarrier::foundAnew(const FrameResult& from, int frame, const Volume& volume,
                                    Meant& meant) const {
  const int asked = carriedRequest(settings_, frame).parameters.candidate;
  FrameResult result = attempt(from, frame, volume, asked, meant);
  if (result.isTrusted()) return result;
  const std::optional<int> other = nearestOther(meant.candidates, asked, from.volume);
  if (!other) return result;
  FrameResult second = attempt(from, frame, volume, *other, meant);
  if (!second.isTrusted()) return result;
  second.faults.push_back(
      {FrameFault::otherObject,
       {K::frameOtherObject, {{"candidate", *other}}, std::move(result.faults.front().finding)}});
  return second;
}

//! Clicks do not know what was decided in the frame beside it: where they mean nothing that can be, and where
//! the image leaves open what they mean. In the former case what has moved there may be shown by nothing.
FrameResult FrameCarrier::tried(const FrameResult& from, int frame) const {
  const Volume volume = hooks_.load(frame);
  Meant meant;
  FrameResult anew = foundAnew(from, frame, volume, meant);
  if (!asksForMoved(anew, meant.isCloseChoice, settings_.request.parameters)) return anew;
  const bool fails = !anew.isTrusted();
  const MovedObject object = movedFrom(from, volume);
  const double agreed = fails ? 0 : agreement(anew.mesh, *object.surface);
  if (agreed >= kAgrees) return anew;
  FrameResult moved = attemptMoved(from, frame, volume, object, fails);
  if (!moved.isTrusted()) return anew;
  Finding told =
      fails ? Finding{K::frameMovedInstead, {{"from_frame", from.frame}}, anew.faults.front().finding}
            : Finding{K::frameMovedObject, {{"percent", 100 * agreed}, {"from_frame", from.frame}}};
  moved.faults.push_back({FrameFault::movedObject, std::move(told)});
  return moved;
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
    result.faults.push_back({FrameFault::unreadable, causedBy(K::frameUnreadable, error)});
  }
  if (!from.isTrusted())
    result.faults.push_back({FrameFault::fromFailed, {K::frameFromFailed, {{"from_frame", from.frame}}}});
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

void FrameCarrier::judge(const FrameResult& from, const ActiveContour& contour, FrameResult& result) const {
  const auto tell = [&](FrameFault fault, Finding finding) {
    result.faults.push_back({fault, std::move(finding)});
  };
  result.iterations = contour.iteration();
  result.stopped = contour.stopReason();
  if (result.stopped == StopReason::empty) return tell(FrameFault::vanished, K::frameVanished);
  result.mesh = hooks_.finish(contour.mesh().compact());
  result.under = grownUnder(contour);
  measure(result);
  if (isJump(from.volume, result.volume, std::abs(result.frame - from.frame)))
    tell(FrameFault::jumped, {K::frameJumped,
                              {{"from_ml", from.volume / kMillilitre},
                               {"from_frame", from.frame},
                               {"to_ml", result.volume / kMillilitre}}});
  if (result.components != from.components || result.genus != from.genus)
    tell(FrameFault::changed, topologyChange(from, result));
  for (ToldFault& f : faultsAtEnd(result.stopped, contour.held())) result.faults.push_back(std::move(f));
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
    if (results.back().startsNext()) from = results.back();
  }
  return results;
}

}  // namespace handlebody
