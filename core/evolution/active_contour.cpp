#include "core/evolution/active_contour.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

#include "core/cancellation.h"
#include "core/collision/self_intersection.h"
#include "core/errors.h"
#include "core/evolution/adaptation_rounds.h"
#include "core/evolution/clicked_object.h"
#include "core/evolution/collapsed_components.h"
#include "core/evolution/edit_step.h"
#include "core/evolution/image_doubts.h"
#include "core/evolution/leak_alarm.h"
#include "core/evolution/motion.h"
#include "core/evolution/object_image.h"
#include "core/evolution/quiet_vertices.h"
#include "core/evolution/resting_places.h"
#include "core/evolution/scratch.h"
#include "core/evolution/seeds.h"
#include "core/evolution/stillness.h"
#include "core/evolution/transaction.h"
#include "core/evolution/wall_guard.h"
#include "core/mesh/morton_order.h"
#include "core/mesh/remesh.h"
#include "core/mesh/topology.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

namespace {

// Lengths as parts of the target edge length.
constexpr double kLongest = 1.4;  // the paper's bound s
constexpr double kShortest = 0.55;
constexpr double kStep =
    0.28;  // largest move along the normal: two fronts come closer by little more than s / 3
constexpr double kStepVoxels = 0.9;  // and never further than this many voxels of the finest axis
constexpr double kAgrees = 0.5;      // voxels between a boundary and a surface that agree

// Of surgery in one step, and in an attempt after those that have spent it (units of WorkBudget).
constexpr std::size_t kStepWork = 120'000'000;
constexpr std::size_t kLeastWork = 10'000'000;

constexpr double kFlat = 0.01;  // cubes of the edge length: a component of less volume has been pressed flat

constexpr double kGrowthToReorder = 1.5;  // of the mesh, until its vertices are put into order again
constexpr int kFitsIntoCache = 3000;      // vertices: any order will do

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! More components or tunnels than there were, and than may be.
const char* limitBroken(const TopologyLimits& limits, const TopologyNumbers& before,
                        const TopologyNumbers& after) {
  const auto isBroken = [](const std::optional<int>& limit, int was, int is) {
    return limit && is > *limit && is > was;
  };
  if (isBroken(limits.components, before.components, after.components))
    return "there would be more components than may be";
  if (isBroken(limits.genus, before.genus, after.genus)) return "there would be more tunnels than may be";
  return nullptr;
}

}  // namespace

struct ActiveContour::State {
  Mesh mesh;
  Scratch<Transaction> transaction;
  std::vector<unsigned char> quiet;  // iterations per vertex without motion, up to kQuietToSleep
  Volume volume;
  std::vector<Seed> seeds;  // as asked for
  Parameters requested;
  Constraints constraints;
  WallGuard walls;
  ClickedObject object;
  ResolvedParameters parameters;
  MotionSettings motion;
  RemeshLimits limits;
  Scratch<CollisionDetector> detector;
  RestingPlaces resting;
  HeldChanges held;  // what the constraints forbid
  PinnedParts pins;
  EditSchedule edits;
  CollapsedComponents collapsed;
  Stillness stillness;
  LeakAlarm alarm;
  std::optional<Correction> correction;
  double automaticEdge = 0;  // mm; what the edge length is if none is asked for
  TopologyNumbers topology;
  StopReason stop = StopReason::running;
  int iteration = 0;
  int orderedVertices = kFitsIntoCache;  // vertices when they were last put into order
  bool traces = false;
  WorkBudget work{kStepWork};

  //! True if parts of the surface may give ground: where that was asked for, or after other clicks.
  bool mayShrink() const { return !motion.outwardOnly || (correction && correction->givesGround); }
  bool sleeps(int v) const { return quiet[idx(v)] >= kQuietToSleep; }

  void chooseEdge();
  void resolve(const Parameters& p);
  void start(const Parameters& p, const Constraints& c);
  void begin();
  void change(const Request& to, const State* prepared);
  void chooseWalls();
  void chooseForbidden();
  void forgetRest();
  void correct();
  void beginAnew();
  void resolveSeeds(const std::vector<Seed>& inside);
  void keepOrder();
  Attempt attempt();
  std::vector<int> verticesToMove() const;
  void stopBeforeFlat(Attempt& a) const;
  void lookAtPins(Attempt& a) const;
  void takePins();
  void adapt(Attempt& a);
  void deleteCollapsed(Attempt& a);
  void accept(Attempt& a, StepReport& report);
  std::vector<HeldChange> judge(const Attempt& a, StepReport& report);
  void restRepeated(StepReport& report);
  Event rolledBack(const Vec3& place, const char* reason) const;
  void watch(const Attempt& kept, StepReport& report);
  void decideStop(const StepReport& report);
  StopReason restReason() const;
  bool leadsToEdit() const;
  Attempt editAttempt(const MeshEdit& edit);
  StepReport editStep(const MeshEdit& edit);
  void letSleep(const Attempt& edited);
  StepReport step();
  StepReport stepOrNothing();
};

//! Two voxels, but finer in thin structures.
void ActiveContour::State::chooseEdge() {
  const double voxel = volume.grid.meanSpacing();
  const auto image = object.image->behind(nullptr);
  double fit = 0;
  for (const Seed& s : seedsOfSide(seeds, false))
    fit = std::max(fit, fittingRadius(*image, s.centre, 8 * voxel));
  automaticEdge = std::clamp(0.6 * fit / voxel, 1.0, 2.0) * voxel;
}

//! Everything but the seeds' radii. Precondition: object and automatic edge length are chosen.
void ActiveContour::State::resolve(const Parameters& p) {
  const double edge = p.edgeLength.value_or(automaticEdge);
  requested = p;
  parameters.object = object.kind;
  parameters.range = object.range;
  parameters.smoothing = object.smoothing;
  parameters.candidate = object.candidate;
  parameters.edgeLength = edge;
  parameters.direction = p.direction;
  parameters.balloon = p.balloon;
  parameters.curvature = p.curvature;
  parameters.maxIterations = p.maxIterations;
  parameters.threads = p.threads;
  parameters.broadPhase = p.broadPhase;

  motion.balloon = p.balloon;
  motion.curvature = p.curvature;
  motion.edgeLength = edge;
  motion.largestStep = std::min(kStep * edge, kStepVoxels * volume.grid.spacing.minCoeff());
  motion.outwardOnly = p.direction == Direction::outward;
  motion.threads = p.threads;
  limits = {kLongest * edge, kShortest * edge};
  chooseWalls();
}

void ActiveContour::State::chooseWalls() {
  walls.choose(constraints.walls, volume.grid, parameters.edgeLength, motion.largestStep);
  object.image = object.image->behind(walls.all());
  chooseForbidden();
}

void ActiveContour::State::chooseForbidden() {
  limits.forbidden = walls.forbidden();
  limits.forbidden.pinned = pins.mask();
}

//! Precondition: volume, seeds and object are chosen.
void ActiveContour::State::start(const Parameters& p, const Constraints& c) {
  held.choose(c, 0);
  pins.choose(c.pins, 0);
  edits.choose(c.edits, 0);
  constraints = c;
  chooseEdge();
  resolve(p);
  begin();
  takePins();
}

void ActiveContour::State::begin() {
  const std::vector<Seed> asked = seedsOfSide(seeds, false);
  std::vector<Seed> inside =
      fitSeeds(*object.image, asked, parameters.edgeLength, parameters.direction == Direction::both);
  if (walls.all()) inside = clearOfWalls(inside, asked, *walls.all(), limits.shortest);
  mesh = seedMesh(inside, parameters.edgeLength);
  resolveSeeds(inside);
  quiet.assign(idx(mesh.vertexSlots()), 0);
  topology = topologyNumbers(mesh);
  if (parameters.maxIterations == 0 && !leadsToEdit()) stop = StopReason::maxIterations;
}

void ActiveContour::State::resolveSeeds(const std::vector<Seed>& inside) {
  parameters.seeds = inside;
  for (Seed s : seedsOfSide(seeds, true)) {
    s.radius = s.radius.value_or(volume.grid.meanSpacing());
    parameters.seeds.push_back(s);
  }
}

void ActiveContour::State::change(const Request& to, const State* prepared) {
  requireSensible(to.parameters);
  requireSensible(to.constraints, volume.grid);
  const WallList known = constraints.walls;
  const bool otherWalls = to.constraints.walls != known;
  const bool otherClicks = to.seeds != seeds;
  const bool otherImage = prepared || otherClicks || !chooseSameImage(to.parameters, requested);
  const bool freed = held.choose(to.constraints, iteration);
  const bool unpinned = pins.choose(to.constraints.pins, iteration);
  takePins();
  edits.choose(to.constraints.edits, iteration);
  const bool wake = otherClicks || otherWalls || freed || unpinned || !moveAlike(to.parameters, requested);
  const bool sleepsOn = otherClicks && haveSameForces(to.parameters, requested);
  seeds = to.seeds;
  constraints = to.constraints;
  if (prepared)
    object = prepared->object;
  else if (otherImage)
    object = findClickedObject(volume, seeds, to.parameters);
  if (otherImage && !otherClicks) chooseEdge();
  resolve(to.parameters);
  if (wake) forgetRest();
  if (wake && !sleepsOn) quiet.assign(idx(mesh.vertexSlots()), 0);
  if (otherClicks) correct();
  if (otherClicks || otherImage || otherWalls) alarm.forget();
  walls.putUp(mesh, known, mayShrink());
  chooseForbidden();
  if (stop == StopReason::maxIterations || (wake && mesh.faceCount() > 0)) stop = StopReason::running;
  if (stop == StopReason::running && iteration >= to.parameters.maxIterations)
    stop = StopReason::maxIterations;
  if (leadsToEdit()) stop = StopReason::running;
}

void ActiveContour::State::forgetRest() {
  resting = {};
  stillness = {};
  collapsed.forget();
  pins.forgetStops();
}

//! After a change of the clicks. What had settled and agrees with the new image sleeps on.
void ActiveContour::State::correct() {
  std::vector<Seed> fronts;
  const auto isPinned = [this](int v) { return pins.holds(v); };
  correction = correctComponents(mesh, *object.image, seeds, parameters.edgeLength, limits.longest, fronts,
                                 pins.any() ? isPinned : std::function<bool(int)>());
  if (correction->beganAnew) {
    if (pins.any())
      throw UsageError(
          "The clicks have so little in common with the surface that it would begin anew, but a part of it "
          "is "
          "pinned: take the pins away first.");
    beginAnew();
    return;
  }
  std::vector<Seed> inside = seedsOfSide(parameters.seeds, false);
  inside.insert(inside.end(), fronts.begin(), fronts.end());
  resolveSeeds(inside);
  const Disagreement differs = findDisagreement(mesh, *object.image, kAgrees * volume.grid.meanSpacing());
  correction->givesGround = differs.isOutside;
  quiet.resize(idx(mesh.vertexSlots()), 0);
  for (std::size_t v = 0; v < quiet.size(); ++v)
    if (differs.vertices[v]) quiet[v] = 0;
  topology = topologyNumbers(mesh);
}

void ActiveContour::State::beginAnew() {
  chooseEdge();
  resolve(requested);
  orderedVertices = kFitsIntoCache;
  begin();
}

//! A ring of a mesh that has grown lies anywhere in memory. At 150,000 vertices it costs five times as much
//! to look at as one in order.
void ActiveContour::State::keepOrder() {
  if (mesh.vertexSlots() < kGrowthToReorder * orderedVertices) return;
  const std::vector<int> order = mortonOrder(mesh, parameters.edgeLength);
  mesh.reorder(order);
  pins.reorder(order);
  chooseForbidden();
  std::vector<unsigned char> quietInOrder;
  for (const int v : order) quietInOrder.push_back(quiet[idx(v)]);
  quiet = std::move(quietInOrder);
  orderedVertices = mesh.vertexSlots();
}

std::vector<int> ActiveContour::State::verticesToMove() const {
  std::vector<int> out;
  const bool anyRest = resting.any(iteration);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && !sleeps(v) && !(anyRest && resting.rests(mesh.position(v), iteration)) &&
        !held.rests(mesh.position(v)) && !pins.holds(v) && !pins.rests(mesh.position(v)))
      out.push_back(v);
  return out;
}

Attempt ActiveContour::State::attempt() {
  giveUpIfCancelled();
  work.allowAtLeast(kLeastWork);
  Attempt a;
  a.moving = verticesToMove();
  std::vector<Vec3> moves = computeMotion(mesh, *object.image, motion, a.moving);
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] *= resting.pace(mesh.position(a.moving[i]));
  giveUpIfCancelled();
  a.touched.assign(idx(mesh.vertexSlots()), 0);
  walls.bound(mesh, a.moving, motion.largestStep, moves);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    mesh.setPosition(a.moving[i], mesh.position(a.moving[i]) + moves[i]);
    a.touched[idx(a.moving[i])] = 1;
  }
  walls.holdBack(mesh, transaction.before(), a.moving, moves);
  for (const Vec3& move : moves) a.distances.push_back(move.norm());
  regulate(mesh, limits, a.touched);
  giveUpIfCancelled();
  adapt(a);
  giveUpIfCancelled();
  if (a.troubles.empty()) deleteCollapsed(a);
  if (const auto place = walls.broken(mesh, a.touched, a.events); a.troubles.empty() && place)
    a.troubles.push_back({*place, 2 * limits.longest, "the surface would have entered a wall"});
  if (a.troubles.empty()) stopBeforeFlat(a);
  if (a.troubles.empty()) lookAtPins(a);
  return a;
}

//! A cavity over a pinned part, or a body under one, cannot go: what would press it flat stops.
void ActiveContour::State::stopBeforeFlat(Attempt& a) const {
  const TopologyNumbers& now = a.events.empty() ? topology : a.events.back().after;
  if (!pins.any() || now.components < 2) return;
  const Components parts = findComponents(mesh);
  const double least = kFlat * std::pow(parameters.edgeLength, 3);
  std::vector<unsigned char> isPinned(idx(parts.count()), 0);
  std::vector<int> moving(idx(parts.count()), -1);  // a vertex
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    const int c = parts.ofVertex[idx(v)];
    if (c < 0) continue;
    if (pins.holds(v))
      isPinned[idx(c)] = 1;
    else if (idx(v) < a.touched.size() && a.touched[idx(v)] != 0)
      moving[idx(c)] = v;
  }
  for (int c = 0; c < parts.count(); ++c) {
    const bool isFlat = std::abs(parts.volume[idx(c)]) < least;
    if (!isFlat || isPinned[idx(c)] == 0 || moving[idx(c)] < 0) continue;
    a.troubles.push_back({mesh.position(moving[idx(c)]), parts.extent[idx(c)],
                          "the surface would close over a pinned part, and stops before it"});
    a.troubles.back().atPin = true;
  }
}

//! What no look ahead has kept from changing what is pinned, is taken back.
void ActiveContour::State::lookAtPins(Attempt& a) const {
  const auto place = pins.broken(transaction.before(), mesh);
  if (!place) return;
  constexpr const char* kReason = "a pinned part would have changed";
  a.troubles.push_back({*place, 2 * limits.longest, kReason});
  for (const Event& e : a.events) a.troubles.push_back({e.location, 2 * limits.longest, kReason});
}

void ActiveContour::State::takePins() {
  pins.take(mesh, iteration);
  chooseForbidden();
}

void ActiveContour::State::adapt(Attempt& a) {
  AdaptationSettings settings{!mayShrink(), traces, iteration, topology, {}, limits.forbidden, &work};
  settings.cameBack = [this](const Vec3& p) { return resting.cameBack(p, limits.longest); };
  detector.use(parameters.broadPhase);
  adaptInRounds(mesh, detector, std::move(settings), limits.longest, a);
}

void ActiveContour::State::deleteCollapsed(Attempt& a) {
  const auto isKept = [this](const Vec3& p) { return held.rests(p); };
  std::function<bool(int)> isPinned;
  if (pins.any()) isPinned = [this](int v) { return pins.holds(v); };
  const TopologyNumbers& now = a.events.empty() ? topology : a.events.back().after;
  for (Event& e : collapsed.erase(
           mesh, {parameters.edgeLength, mayShrink(), !a.events.empty(), iteration, now, isKept, isPinned}))
    a.events.push_back(std::move(e));
}

//! The changes that may not happen, each with an event.
std::vector<HeldChange> ActiveContour::State::judge(const Attempt& a, StepReport& report) {
  std::vector<HeldChange> changes = held.judge(a.events, iteration, limits.longest);
  for (const HeldChange& h : changes) {
    report.events.push_back(rolledBack(h.place, h.reason));
    report.events.back().held = h.kind;
  }
  return changes;
}

void ActiveContour::State::accept(Attempt& a, StepReport& report) {
  countQuiet(mesh, {a.moving, a.distances, a.touched}, parameters.edgeLength, quiet);
  for (double d : a.distances) {
    report.movedVertices += d >= kQuiet * parameters.edgeLength;
    report.largestMove = std::max(report.largestMove, d);
  }
  report.events.insert(report.events.end(), std::make_move_iterator(a.events.begin()),
                       std::make_move_iterator(a.events.end()));
  if (!report.events.empty()) topology = report.events.back().after;
  restRepeated(report);
}

void ActiveContour::State::restRepeated(StepReport& report) {
  for (std::size_t i = 0, n = report.events.size(); i < n; ++i) {
    const Event& e = report.events[i];
    if (e.kind != EventKind::rolledBack && resting.repeats(e.location, limits.longest))
      report.events.push_back(
          rolledBack(e.location, "the same place changed again and again, and rests from now on"));
  }
}

Event ActiveContour::State::rolledBack(const Vec3& place, const char* reason) const {
  Event event;
  event.kind = EventKind::rolledBack;
  event.iteration = iteration;
  event.location = place;
  event.before = event.after = topology;
  event.reason = reason;
  return event;
}

//! For leaks. The step has been made: it is not to be cancelled any more.
void ActiveContour::State::watch(const Attempt& kept, StepReport& report) {
  static const std::atomic<bool> never{false};
  const CancelScope scope(never);
  std::vector<Vec3> starts;
  for (const Seed& s : seedsOfSide(parameters.seeds, false)) starts.push_back(s.centre);
  report.leaks = alarm.look(mesh, kept.moving, {*object.image, walls.all().get(), starts, iteration});
}

void ActiveContour::State::decideStop(const StepReport& report) {
  const bool isEdit = !report.events.empty() && report.events.front().edit;
  const bool calm = report.events.empty() && !resting.anyWillWake(iteration);
  // What was at rest before an edit is so after it: nothing that it made stirs.
  if (!isEdit) stillness.count(calm, report.movedVertices, mesh.vertexCount());
  if (mesh.faceCount() == 0)
    stop = StopReason::empty;
  else if (leadsToEdit())
    stop = StopReason::running;
  else if (stillness.isAtRest())
    stop = restReason();
  else if (iteration >= parameters.maxIterations)
    stop = StopReason::maxIterations;
}

//! Why nothing moves: of its own accord, or because it rests for good and would move if it did not.
StopReason ActiveContour::State::restReason() const {
  std::vector<int> resters;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && resting.rests(mesh.position(v), iteration)) resters.push_back(v);
  const std::vector<Vec3> moves = computeMotion(mesh, *object.image, motion, resters);
  const bool wouldMove = std::any_of(
      moves.begin(), moves.end(), [&](const Vec3& m) { return m.norm() >= kQuiet * parameters.edgeLength; });
  if (!wouldMove) return StopReason::converged;
  return static_cast<int>(resters.size()) == mesh.vertexCount() ? StopReason::stuck : StopReason::frozen;
}

//! As if it had never begun, if it is cancelled: Transaction takes the mesh back, and this all that an
//! attempt leaves besides. Whatever else is thrown may come after the mesh was accepted: the iteration then
//! says so, and the history restores what was before.
StepReport ActiveContour::State::stepOrNothing() {
  const auto before = std::make_tuple(iteration, resting, held, collapsed);
  const PinnedParts pinsBefore = pins;
  try {
    return step();
  } catch (const Cancelled&) {
    std::tie(iteration, resting, held, collapsed) = before;
    pins.takeStopsBack(pinsBefore);
    throw;
  }
}

//! Steps from here come to an edit that waits.
bool ActiveContour::State::leadsToEdit() const {
  const std::optional<MeshEdit> next = edits.waiting();
  return next && mesh.faceCount() > 0 &&
         (iteration < parameters.maxIterations || next->iteration == iteration + 1);
}

Attempt ActiveContour::State::editAttempt(const MeshEdit& edit) {
  EditOutcome done = makeEdit(mesh, edit);
  Attempt a;
  a.events = std::move(done.events);
  for (Event& e : a.events) e.iteration = edit.iteration;
  a.touched.assign(idx(mesh.vertexSlots()), 0);
  for (const int v : done.touched)
    if (v < mesh.vertexSlots()) a.touched[idx(v)] = 1;
  if (const auto place = walls.brokenAnywhere(mesh))
    a.troubles.push_back({*place, 0, "the surface would come into a wall or around it"});
  else if (const auto pinned = pins.broken(transaction.before(), mesh))
    a.troubles.push_back({*pinned, 0, "a pinned part would change"});
  else if (const char* broken = limitBroken(constraints.topology, topology, a.events.back().after))
    a.troubles.push_back({edit.place, 0, broken});
  return a;
}

//! What an edit made stays as it was made, until something near it moves.
void ActiveContour::State::letSleep(const Attempt& edited) {
  const Mesh& before = transaction.before();
  quiet.resize(idx(mesh.vertexSlots()), 0);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (edited.touched[idx(v)] != 0 &&
        (v >= before.vertexSlots() || !before.isVertex(v) || before.position(v) != mesh.position(v)))
      quiet[idx(v)] = kQuietToSleep;
}

//! All or nothing: what throws has changed nothing.
StepReport ActiveContour::State::editStep(const MeshEdit& edit) {
  const auto anything = [](const Attempt&) { return std::vector<HeldChange>(); };
  Attempt made =
      transaction.runOnce({mesh, topology, limits.longest, [&] { return editAttempt(edit); }, anything, {}});
  if (!made.isKept())
    throw UsageError("The edit of iteration " + std::to_string(edit.iteration) +
                     " cannot be made: " + made.troubles[0].reason + ".");
  StepReport report;
  report.iteration = ++iteration;
  edits.setMade(edit);
  letSleep(made);
  topology = made.events.back().after;
  report.events = std::move(made.events);
  collapsed.forget();
  if (walls.isPushing()) {
    walls.release(mesh);
    chooseForbidden();
  }
  report.settledVertices = mesh.vertexCount();
  report.volume = transaction.volume();
  decideStop(report);
  takePins();
  return report;
}

StepReport ActiveContour::State::step() {
  if (const MeshEdit* edit = edits.dueAt(iteration + 1)) return editStep(MeshEdit(*edit));
  StepReport report;
  report.iteration = ++iteration;
  work = WorkBudget(kStepWork);
  keepOrder();
  const auto rollBack = [&](const Trouble& t) {
    report.events.push_back(rolledBack(t.centre, t.reason));
    if (t.atPin)
      pins.stop(mesh, t.centre, t.radius, limits.longest);
    else
      resting.add(t.centre, t.radius + 0.5 * limits.longest, iteration, t.waits);
  };
  Attempt last = transaction.run({mesh, topology, limits.longest, [this] { return attempt(); },
                                  [&](const Attempt& a) { return judge(a, report); }, rollBack});
  if (last.isKept())
    accept(last, report);
  else
    rollBack({last.place(), 1e3 * parameters.edgeLength, "no part of the step could be kept"});
  if (walls.isPushing()) {
    walls.release(mesh);
    chooseForbidden();
  }
  // Of the mesh that is left, also when all of the step was rolled back.
  report.settledVertices = std::max(0, mesh.vertexCount() - report.movedVertices);
  report.volume = transaction.volume();
  watch(last, report);
  decideStop(report);
  takePins();
  return report;
}

ActiveContour::ActiveContour(Volume volume, std::vector<Seed> seeds, Parameters parameters,
                             Constraints constraints)
    : state_(std::make_unique<State>()) {
  requireSensible(parameters);
  requireSensible(constraints, volume.grid);
  state_->volume = std::move(volume);
  state_->seeds = std::move(seeds);
  state_->object = findClickedObject(state_->volume, state_->seeds, parameters);
  state_->start(parameters, constraints);
}
ActiveContour::ActiveContour(std::unique_ptr<State> state) : state_(std::move(state)) {}
ActiveContour::~ActiveContour() = default;
ActiveContour::ActiveContour(ActiveContour&&) noexcept = default;
ActiveContour& ActiveContour::operator=(ActiveContour&&) noexcept = default;
ActiveContour::ActiveContour(const ActiveContour& other) : state_(std::make_unique<State>(*other.state_)) {}
ActiveContour& ActiveContour::operator=(const ActiveContour& other) { return *this = ActiveContour(other); }

StepReport ActiveContour::step() { return state_->stepOrNothing(); }
void ActiveContour::change(const Request& request) {
  auto changed = std::make_unique<State>(*state_);
  changed->change(request, nullptr);
  state_ = std::move(changed);
}
void ActiveContour::change(const ActiveContour& prepared) {
  auto changed = std::make_unique<State>(*state_);
  changed->change(prepared.request(), prepared.state_.get());
  state_ = std::move(changed);
}
const std::optional<Correction>& ActiveContour::correction() const { return state_->correction; }
ActiveContour ActiveContour::restarted(const Parameters& parameters, const Constraints& constraints) const {
  if (!chooseSameImage(parameters, requested()))
    return {state_->volume, state_->seeds, parameters, constraints};
  requireSensible(parameters);
  requireSensible(constraints, grid());
  auto fresh = std::make_unique<State>();
  fresh->volume = state_->volume;
  fresh->seeds = state_->seeds;
  fresh->object = state_->object;
  fresh->start(parameters, constraints);
  return ActiveContour(std::move(fresh));
}
StopReason ActiveContour::stopReason() const { return state_->stop; }
int ActiveContour::iteration() const { return state_->iteration; }
const Mesh& ActiveContour::mesh() const { return state_->mesh; }
const Grid& ActiveContour::grid() const { return state_->volume.grid; }
const ResolvedParameters& ActiveContour::parameters() const { return state_->parameters; }
const Parameters& ActiveContour::requested() const { return state_->requested; }
const std::vector<Seed>& ActiveContour::requestedSeeds() const { return state_->seeds; }
const Constraints& ActiveContour::constraints() const { return state_->constraints; }
std::optional<Veto> ActiveContour::waitingVeto() const { return state_->held.waiting(); }
std::vector<PinnedPart> ActiveContour::pinned() const { return state_->pins.list(); }
std::optional<Pin> ActiveContour::waitingPin() const { return state_->pins.waiting(); }
std::optional<MeshEdit> ActiveContour::waitingEdit() const { return state_->edits.waiting(); }
std::vector<HeldPlace> ActiveContour::held() const { return state_->held.list(); }
const std::vector<ObjectCandidate>& ActiveContour::candidates() const { return state_->object.candidates; }
bool ActiveContour::isCloseChoice() const { return state_->object.isCloseChoice; }
bool ActiveContour::isSettled(int vertex) const { return state_->sleeps(vertex); }
std::size_t ActiveContour::memory() const {
  return sizeof(State) + state_->mesh.memory() + state_->quiet.size();
}
SurfaceSupport ActiveContour::support() const { return surfaceSupport(state_->mesh, *state_->object.image); }
std::vector<std::string> ActiveContour::doubts(const SurfaceSupport& support) const {
  std::vector<std::string> doubts = imageDoubts(state_->mesh, *state_->object.image, support);
  if (state_->walls.isPushing()) doubts.push_back("the surface still lies in a wall that was put over it");
  for (std::string& d : state_->held.doubts()) doubts.push_back(std::move(d));
  if (state_->object.neckRadius > 0) doubts.push_back(heldAtPassages(state_->object.neckRadius));
  return doubts;
}
void ActiveContour::recordTraces(bool on) { state_->traces = on; }

}  // namespace handlebody
