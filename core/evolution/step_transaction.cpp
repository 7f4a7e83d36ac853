#include "core/evolution/step_transaction.h"

#include <functional>
#include <iterator>
#include <utility>

#include "core/cancellation.h"
#include "core/evolution/pinned_check.h"

namespace handlebody {

namespace {

// Of surgery in an attempt after those that have spent what a step has (units of WorkBudget).
constexpr std::size_t kMinWork = 10'000'000;
// Edges so many times as long as the longest that is not split are split in a place that is stuck, too.
constexpr double kStretched = 1.05;

//! `topology`: of the mesh, which it leaves as it is.
Event rolledBack(const Vec3& place, Finding reason, const TopologyNumbers& topology, int iteration) {
  Event event;
  event.kind = EventKind::rolledBack;
  event.iteration = iteration;
  event.location = place;
  event.before = event.after = topology;
  event.reasons = {std::move(reason)};
  return event;
}

//! Places that have changed too often are locked for good, each with an event.
void lockRepeated(const StepScene& scene, std::vector<Event>& events) {
  if (events.empty()) return;
  const TopologyNumbers topology = events.back().after;
  for (std::size_t i = 0, n = events.size(); i < n; ++i) {
    const Event& e = events[i];
    if (e.kind != EventKind::rolledBack &&
        scene.locked.regions.repeats(e.location, scene.longestAt(e.location)))
      events.push_back(rolledBack(e.location, FindingKind::changesAgain, topology, scene.iteration));
  }
}

}  // namespace

StepOutcome StepTransaction::move(Mesh& mesh, const StepScene& scene) {
  work_ = WorkBudget(kStepWork);
  std::vector<Event> events;
  bool isFirst = true;
  const auto attemptOnce = [&] {
    if (!isFirst) collapsed_.forgetPlaces();
    return attempt(mesh, scene, std::exchange(isFirst, false));
  };
  const auto judgeKept = [&](const Attempt& a) { return judge(mesh, scene, a, events); };
  const auto rollBack = [&](const Conflict& t) {
    events.push_back(rolledBack(t.centre, t.reason, scene.topology, scene.iteration));
    events.back().faces = t.faces;
    scene.locked.lock(t, mesh, scene.limits.longest, scene.sizeAt(t.centre), scene.iteration);
  };
  Attempt last = transaction_.run({mesh, scene.topology, scene.limits.longest, scene.longest(),
                                   std::ref(attemptOnce), std::ref(judgeKept), std::ref(rollBack)});
  if (last.isKept()) {
    events.insert(events.end(), std::make_move_iterator(last.events.begin()),
                  std::make_move_iterator(last.events.end()));
    lockRepeated(scene, events);
  } else {
    collapsed_.forgetPlaces();
    rollBack({last.place(), 1e3 * scene.motion.edgeLength, FindingKind::nothingKept});
  }
  return {std::move(last), std::move(events)};
}

Attempt StepTransaction::attempt(Mesh& mesh, const StepScene& scene, bool isFirst) {
  giveUpIfCancelled();
  work_.allowAtLeast(kMinWork);
  Attempt a;
  displace(mesh, scene, a);
  if (isFirst) touchStretched(mesh, scene, a);
  regulate(mesh, scene.limits, a.touched);
  giveUpIfCancelled();
  adapt(mesh, scene, a);
  giveUpIfCancelled();
  if (a.conflicts.empty()) deleteCollapsed(mesh, scene, a);
  findFaults(mesh, scene, a);
  return a;
}

void StepTransaction::displace(Mesh& mesh, const StepScene& scene, Attempt& a) const {
  a.moving = scene.active.list(mesh, scene.locked, scene.iteration);
  std::vector<Vec3> moves = computeMotion(mesh, scene.image, scene.motion, a.moving);
  for (std::size_t i = 0; i < moves.size(); ++i)
    moves[i] *= scene.locked.regions.speedFactor(mesh.position(a.moving[i]));
  giveUpIfCancelled();
  a.touched.assign(mesh.vertexSlots(), 0);
  scene.walls.bound(mesh, a.moving, scene.motion.largestStep, moves);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    mesh.setPosition(a.moving[i], mesh.position(a.moving[i]) + moves[i]);
    a.touched[a.moving[i]] = 1;
  }
  scene.walls.holdBack(mesh, before(), a.moving, moves);
  for (const Vec3& m : moves) a.distances.push_back(m.norm());
}

//! Where surgery has left edges that are too long, and the place was locked before they were split, nothing
//! fits between faces that reach across it. If it is stuck they are split while it rests.
void StepTransaction::touchStretched(const Mesh& mesh, const StepScene& scene, Attempt& a) {
  const StuckPlaces stuck = scene.locked.regions.stuck(scene.iteration);
  if (stuck.isEmpty()) return;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (!mesh.isVertex(v) || a.touched[v] != 0) continue;
    const Vec3& p = mesh.position(v);
    if (!stuck.hold(p)) continue;
    const double most = kStretched * scene.longestAt(p);
    bool isStretched = false;
    mesh.forEachOutgoing(v, [&](int h) {
      isStretched = isStretched || (mesh.position(mesh.target(h)) - p).squaredNorm() > most * most;
    });
    if (isStretched && !scene.locked.isHeld(mesh, v)) a.touched[v] = 1;
  }
}

void StepTransaction::adapt(Mesh& mesh, const StepScene& scene, Attempt& a) {
  AdaptationSettings settings{!scene.mayShrink,       scene.traces, scene.iteration, scene.topology, {},
                              scene.limits.forbidden, &work_};
  settings.cameBack = [&scene](const Vec3& p) {
    return scene.locked.regions.cameBack(p, scene.longestAt(p));
  };
  detector_.use(scene.broadPhase);
  detector_.useThreads(scene.motion.threads);
  rounds_.run(mesh, detector_, std::move(settings), scene.limits.longest, a);
}

void StepTransaction::deleteCollapsed(Mesh& mesh, const StepScene& scene, Attempt& a) {
  const Restraints& locked = scene.locked;
  const auto isKept = [&locked](const Vec3& p) { return locked.held.isLocked(p); };
  std::function<bool(int)> isPinned;
  if (locked.pins.any()) isPinned = [&locked](int v) { return locked.pins.holds(v); };
  const TopologyNumbers& now = a.events.empty() ? scene.topology : a.events.back().after;
  ErasedComponents erased = collapsed_.erase(mesh, {{before(), mesh, a.touched, scene.longest()},
                                                    scene.motion.edgeLength,
                                                    scene.mayShrink,
                                                    !a.events.empty(),
                                                    hasSurgery(a.events),
                                                    scene.iteration,
                                                    now,
                                                    isKept,
                                                    isPinned});
  a.events.insert(a.events.end(), std::make_move_iterator(erased.events.begin()),
                  std::make_move_iterator(erased.events.end()));
  a.parts = std::move(erased.parts);
}

//! What of the attempt walls and pins do not allow; nothing if something was wrong already.
void StepTransaction::findFaults(const Mesh& mesh, const StepScene& scene, Attempt& a) const {
  if (!a.conflicts.empty()) return;
  const double around = 2 * scene.limits.longest;
  if (const auto place = scene.walls.broken(mesh, a.touched, a.events))
    a.conflicts.push_back({*place, around, FindingKind::entersWall});
  const TopologyNumbers& now = a.events.empty() ? scene.topology : a.events.back().after;
  const PinnedParts& pins = scene.locked.pins;
  if (a.conflicts.empty() && now.components > 1)
    a.conflicts = pressedFlat(mesh, pins, a.touched, scene.motion.edgeLength);
  if (a.conflicts.empty()) a.conflicts = changesOfPinned(before(), mesh, pins, a.events, around);
}

//! The changes that may not happen, each with an event.
std::vector<HeldChange> StepTransaction::judge(const Mesh& mesh, const StepScene& scene, const Attempt& a,
                                               std::vector<Event>& events) const {
  const double longest = scene.limits.longest;
  const auto measure = [&](const Event& e) { return heldSize(e, before(), mesh, longest); };
  std::vector<HeldChange> changes =
      scene.locked.held.judge(a.events, scene.iteration, longest, std::ref(measure));
  for (const HeldChange& h : changes) {
    events.push_back(rolledBack(h.place, h.reason, scene.topology, scene.iteration));
    events.back().held = h.kind;
  }
  return changes;
}

}  // namespace handlebody
