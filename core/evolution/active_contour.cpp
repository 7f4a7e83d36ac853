#include "core/evolution/active_contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/collision/self_intersection.h"
#include "core/errors.h"
#include "core/evolution/clicked_object.h"
#include "core/evolution/image_doubts.h"
#include "core/evolution/motion.h"
#include "core/evolution/object_image.h"
#include "core/evolution/resting_places.h"
#include "core/evolution/seeds.h"
#include "core/evolution/transaction.h"
#include "core/mesh/morton_order.h"
#include "core/mesh/nesting.h"
#include "core/mesh/remesh.h"
#include "core/mesh/topology.h"
#include "core/surgery/predicted_change.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

namespace {

// Lengths as parts of the target edge length.
constexpr double kLongest = 1.4;  // the paper's bound s
constexpr double kShortest = 0.55;
constexpr double kStep =
    0.28;  // largest move along the normal: two fronts come closer by little more than s / 3
constexpr double kStepVoxels = 0.9;  // and never further than this many voxels of the finest axis
constexpr double kQuiet = 0.015;     // a vertex that moves less than this is quiet
constexpr double kStirring = 0.1;    // a neighbour that moves more than this wakes a sleeper
constexpr double kCollapsed = 1.0;   // a component of less extent than this is gone
constexpr double kAgrees = 0.5;      // voxels between a boundary and a surface that agree
constexpr double kShrinks = 4;       // more than a component loses of its extent in one step
constexpr double kSweeps = 0.5;  // more than a face moves along its normal in one step: kStep, and remeshing

constexpr int kQuietToSleep = 3;  // iterations
constexpr int kQuietToStop = 3;   // iterations without motion or event
constexpr int kStillToStop = 40;  // iterations in which next to nothing moves and nothing happens
constexpr double kNextToNothing =
    0.001;  // part of the vertices: single ones may tremble between two faces of a noisy voxel
constexpr int kRounds = 5;                // of detection and surgery in one step
constexpr double kGrowthToReorder = 1.5;  // of the mesh, until its vertices are put into order again
constexpr int kFitsIntoCache = 3000;      // vertices: any order will do

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! What only saves work and decides nothing: a copy starts without it.
template <typename T>
struct Scratch : T {
  Scratch() = default;
  Scratch(const Scratch&) : T() {}
  Scratch& operator=(const Scratch&) = delete;
  using T::operator=;
};

}  // namespace

struct ActiveContour::State {
  Mesh mesh;
  Scratch<Transaction> transaction;
  std::vector<unsigned char> quiet;  // iterations per vertex without motion, up to kQuietToSleep
  Volume volume;
  std::vector<Seed> seeds;  // as asked for
  Parameters requested;
  ClickedObject object;
  ResolvedParameters parameters;
  MotionSettings motion;
  RemeshLimits limits;
  Scratch<CollisionDetector> detector;
  RestingPlaces resting;
  std::optional<Correction> correction;
  double automaticEdge = 0;  // mm; what the edge length is if none is asked for
  TopologyNumbers topology;
  StopReason stop = StopReason::running;
  int iteration = 0;
  int quietIterations = 0;
  int nearlyStillIterations = 0;
  int orderedVertices = kFitsIntoCache;  // vertices when they were last put into order
  std::ptrdiff_t knownCavities = 0;      // components of negative volume, when last looked at
  int lookAtComponents = 0;              // iteration before which none can collapse
  double enclosed = 0;                   // mm³ that the last step left; 0 if not known
  bool traces = false;

  //! True if parts of the surface may give ground: where that was asked for, or after other clicks.
  bool mayShrink() const { return !motion.outwardOnly || (correction && correction->givesGround); }
  bool sleeps(int v) const { return quiet[idx(v)] >= kQuietToSleep; }

  void chooseEdge();
  void resolve(const Parameters& p);
  void begin();
  void change(const Request& to, const State* prepared);
  void forgetRest();
  void correct();
  void beginAnew();
  void resolveSeeds(const std::vector<Seed>& inside);
  void keepOrder();
  Attempt attempt();
  std::vector<int> verticesToMove() const;
  void adapt(Attempt& a);
  bool mayTurn() const;
  void deleteCollapsed(Attempt& a);
  void accept(Attempt& a, StepReport& report);
  void restRepeated(StepReport& report);
  Event rolledBack(const Vec3& place, const char* reason) const;
  void updateQuiet(const Attempt& a);
  void decideStop(const StepReport& report);
  StopReason restReason() const;
  StepReport step();
};

//! Two voxels, but finer in thin structures.
void ActiveContour::State::chooseEdge() {
  const double voxel = volume.grid.meanSpacing();
  double fit = 0;
  for (const Seed& s : seedsOfSide(seeds, false))
    fit = std::max(fit, fittingRadius(*object.image, s.centre, 8 * voxel));
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

  motion.balloon = p.balloon;
  motion.curvature = p.curvature;
  motion.edgeLength = edge;
  motion.largestStep = std::min(kStep * edge, kStepVoxels * volume.grid.spacing.minCoeff());
  motion.outwardOnly = p.direction == Direction::outward;
  motion.threads = p.threads;
  limits = {kLongest * edge, kShortest * edge};
}

void ActiveContour::State::begin() {
  const std::vector<Seed> inside = fitSeeds(*object.image, seedsOfSide(seeds, false), parameters.edgeLength,
                                            parameters.direction == Direction::both);
  mesh = seedMesh(inside, parameters.edgeLength);
  resolveSeeds(inside);
  quiet.assign(idx(mesh.vertexSlots()), 0);
  topology = topologyNumbers(mesh);
  if (parameters.maxIterations == 0) stop = StopReason::maxIterations;
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
  const bool otherClicks = to.seeds != seeds;
  const bool otherImage = prepared || otherClicks || !chooseSameImage(to.parameters, requested);
  const bool wake = otherClicks || !moveAlike(to.parameters, requested);
  const bool sleepsOn = otherClicks && haveSameForces(to.parameters, requested);
  seeds = to.seeds;
  if (prepared)
    object = prepared->object;
  else if (otherImage)
    object = findClickedObject(volume, seeds, to.parameters);
  if (otherImage && !otherClicks) chooseEdge();
  resolve(to.parameters);
  if (wake) forgetRest();
  if (wake && !sleepsOn) quiet.assign(idx(mesh.vertexSlots()), 0);
  if (otherClicks) correct();
  if (stop == StopReason::maxIterations || (wake && mesh.faceCount() > 0)) stop = StopReason::running;
  if (stop == StopReason::running && iteration >= to.parameters.maxIterations)
    stop = StopReason::maxIterations;
}

void ActiveContour::State::forgetRest() {
  resting = {};
  quietIterations = nearlyStillIterations = 0;
  lookAtComponents = 0;
  enclosed = 0;
}

//! After a change of the clicks. What had settled and agrees with the new image sleeps on.
void ActiveContour::State::correct() {
  std::vector<Seed> fronts;
  correction = correctComponents(mesh, *object.image, seeds, parameters.edgeLength, limits.longest, fronts);
  if (correction->beganAnew) {
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
  std::vector<unsigned char> quietInOrder;
  for (const int v : order) quietInOrder.push_back(quiet[idx(v)]);
  quiet = std::move(quietInOrder);
  orderedVertices = mesh.vertexSlots();
}

std::vector<int> ActiveContour::State::verticesToMove() const {
  std::vector<int> out;
  const bool anyRest = resting.any(iteration);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && !sleeps(v) && !(anyRest && resting.rests(mesh.position(v), iteration)))
      out.push_back(v);
  return out;
}

Attempt ActiveContour::State::attempt() {
  Attempt a;
  a.moving = verticesToMove();
  std::vector<Vec3> moves = computeMotion(mesh, *object.image, motion, a.moving);
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] *= resting.pace(mesh.position(a.moving[i]));
  a.touched.assign(idx(mesh.vertexSlots()), 0);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    mesh.setPosition(a.moving[i], mesh.position(a.moving[i]) + moves[i]);
    a.distances.push_back(moves[i].norm());
    a.touched[idx(a.moving[i])] = 1;
  }
  regulate(mesh, limits, a.touched);
  adapt(a);
  if (a.troubles.empty()) deleteCollapsed(a);
  return a;
}

//! Detection and surgery until nothing intersects, or until a place has to be rolled back.
void ActiveContour::State::adapt(Attempt& a) {
  AdaptationSettings settings{!mayShrink(), traces, iteration, topology, {}};
  settings.cameBack = [this](const Vec3& p) { return resting.cameBack(p, limits.longest); };
  std::vector<unsigned char> changed = a.touched;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<FacePair>& pairs = detector.detectMoved(mesh, changed);
    if (pairs.empty()) return;
    changed.assign(idx(mesh.vertexSlots()), 0);
    for (const auto& [f, g] : pairs)
      for (int face : {f, g})
        for (int v : mesh.face(face)) changed[idx(v)] = 1;
    AdaptationResult result = adaptTopology(mesh, pairs, settings, changed);
    if (!result.events.empty()) settings.topology = result.events.back().after;
    a.events.insert(a.events.end(), std::make_move_iterator(result.events.begin()),
                    std::make_move_iterator(result.events.end()));
    a.touched.resize(idx(mesh.vertexSlots()), 0);
    changed.resize(idx(mesh.vertexSlots()), 0);
    for (std::size_t v = 0; v < changed.size(); ++v) a.touched[v] = a.touched[v] | changed[v];
    if (!result.troubles.empty()) {
      a.troubles = std::move(result.troubles);
      return;
    }
  }
  for (const auto& [f, g] : detector.detectMoved(mesh, changed)) {
    const Vec3 centre = mesh.position(mesh.face(f)[0]);
    a.troubles.push_back(
        {centre, 2 * limits.longest, "the surface still intersected itself after several changes"});
  }
}

//! False only if no component can have turned inside out in this step: a single one would have to sweep all
//! that it enclosed. No face is larger than the equilateral one of the longest edge.
bool ActiveContour::State::mayTurn() const {
  if (topology.components != 1) return true;
  const double area = mesh.faceCount() * std::numbers::sqrt3 / 4 * limits.longest * limits.longest;
  return enclosed <= area * kSweeps * parameters.edgeLength;
}

//! Components that have collapsed, and those that have turned inside out while they did: a cavity would grow
//! on as a body in the body, a body as a cavity of all space, without end.
void ActiveContour::State::deleteCollapsed(Attempt& a) {
  if (a.events.empty() && iteration < lookAtComponents && !(mayShrink() && mayTurn())) return;
  const Components parts = findComponents(mesh);
  const double smallest =
      parts.count() == 0 ? 0 : *std::min_element(parts.extent.begin(), parts.extent.end());
  lookAtComponents = iteration + static_cast<int>(smallest / (kShrinks * parameters.edgeLength));
  const auto cavities =
      std::count_if(parts.volume.begin(), parts.volume.end(), [](double v) { return v < 0; });
  const bool mayHaveTurned = knownCavities != cavities || (mayShrink() && !a.events.empty());
  knownCavities = cavities;
  std::vector<int> first(parts.vertices.size(), -1);
  for (int v = mesh.vertexSlots() - 1; v >= 0; --v)
    if (mesh.isVertex(v)) first[idx(parts.ofVertex[idx(v)])] = v;
  for (std::size_t c = 0; c < first.size(); ++c) {
    const bool isTurned = mayHaveTurned && isMisplaced(mesh, parts, static_cast<int>(c));
    if (parts.extent[c] >= kCollapsed * parameters.edgeLength && !isTurned) continue;
    Event event;
    event.kind = EventKind::componentDeleted;
    event.iteration = iteration;
    event.location = mesh.position(first[c]);
    event.before = a.events.empty() ? topology : a.events.back().after;
    event.after = predictDeletion(event.before, parts, static_cast<int>(c));
    deleteComponent(mesh, first[c]);
    a.events.push_back(std::move(event));
  }
}

void ActiveContour::State::updateQuiet(const Attempt& a) {
  const std::size_t known = quiet.size();
  quiet.resize(idx(mesh.vertexSlots()), 0);
  // Vertices that surgery made, moved or gave new faces are awake.
  std::vector<unsigned char> wasMoved(quiet.size(), 0);
  for (int v : a.moving) wasMoved[idx(v)] = 1;
  for (std::size_t v = 0; v < quiet.size(); ++v)
    if (v >= known || (a.touched[v] != 0 && wasMoved[v] == 0)) quiet[v] = 0;
  const double quietMove = kQuiet * parameters.edgeLength, stirringMove = kStirring * parameters.edgeLength;
  for (std::size_t i = 0; i < a.moving.size(); ++i) {
    unsigned char& q = quiet[idx(a.moving[i])];
    if (idx(a.moving[i]) >= known || !mesh.isVertex(a.moving[i])) continue;
    q = a.distances[i] < quietMove ? static_cast<unsigned char>(std::min(q + 1, kQuietToSleep))
                                   : static_cast<unsigned char>(0);
  }
  // Those that stir wake their neighbours. Face by face, in the order of memory: far quicker than a walk from
  // neighbour to neighbour.
  std::fill(wasMoved.begin(), wasMoved.end(), static_cast<unsigned char>(0));
  for (std::size_t i = 0; i < a.moving.size(); ++i)
    wasMoved[idx(a.moving[i])] = a.distances[i] > stirringMove;
  for (const Triangle& t : mesh.faces())
    if (t[0] >= 0 && (wasMoved[idx(t[0])] | wasMoved[idx(t[1])] | wasMoved[idx(t[2])]) != 0)
      for (const int v : t) quiet[idx(v)] = 0;
}

void ActiveContour::State::accept(Attempt& a, StepReport& report) {
  updateQuiet(a);
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

void ActiveContour::State::decideStop(const StepReport& report) {
  const bool calm = report.events.empty() && !resting.anyWillWake(iteration);
  quietIterations = calm && report.movedVertices == 0 ? quietIterations + 1 : 0;
  const bool nearlyStill = report.movedVertices <= std::max(1.0, kNextToNothing * mesh.vertexCount());
  nearlyStillIterations = calm && nearlyStill ? nearlyStillIterations + 1 : 0;
  if (mesh.faceCount() == 0)
    stop = StopReason::empty;
  else if (quietIterations >= kQuietToStop || nearlyStillIterations >= kStillToStop)
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
  const bool held = std::any_of(moves.begin(), moves.end(),
                                [&](const Vec3& m) { return m.norm() >= kQuiet * parameters.edgeLength; });
  if (!held) return StopReason::converged;
  return static_cast<int>(resters.size()) == mesh.vertexCount() ? StopReason::stuck : StopReason::frozen;
}

StepReport ActiveContour::State::step() {
  StepReport report;
  report.iteration = ++iteration;
  keepOrder();
  const auto rollBack = [&](const Trouble& t) {
    report.events.push_back(rolledBack(t.centre, t.reason));
    resting.add(t.centre, t.radius + 0.5 * limits.longest, iteration);
  };
  Attempt last = transaction.run({mesh, topology, limits.longest, [this] { return attempt(); }, rollBack});
  if (last.troubles.empty())
    accept(last, report);
  else
    rollBack({last.troubles[0].centre, 1e3 * parameters.edgeLength, "no part of the step could be kept"});
  // Of the mesh that is left, also when all of the step was rolled back.
  report.settledVertices = std::max(0, mesh.vertexCount() - report.movedVertices);
  report.volume = enclosed = transaction.volume();
  decideStop(report);
  return report;
}

ActiveContour::ActiveContour(Volume volume, std::vector<Seed> seeds, Parameters parameters)
    : state_(std::make_unique<State>()) {
  requireSensible(parameters);
  state_->volume = std::move(volume);
  state_->seeds = std::move(seeds);
  state_->object = findClickedObject(state_->volume, state_->seeds, parameters);
  state_->chooseEdge();
  state_->resolve(parameters);
  state_->begin();
}
ActiveContour::ActiveContour(std::unique_ptr<State> state) : state_(std::move(state)) {}
ActiveContour::~ActiveContour() = default;
ActiveContour::ActiveContour(ActiveContour&&) noexcept = default;
ActiveContour& ActiveContour::operator=(ActiveContour&&) noexcept = default;
ActiveContour::ActiveContour(const ActiveContour& other) : state_(std::make_unique<State>(*other.state_)) {}
ActiveContour& ActiveContour::operator=(const ActiveContour& other) { return *this = ActiveContour(other); }

StepReport ActiveContour::step() { return state_->step(); }
void ActiveContour::change(const Request& request) {
  auto changed = std::make_unique<State>(*state_);
  changed->change(request, nullptr);
  state_ = std::move(changed);
}
void ActiveContour::change(const ActiveContour& prepared) {
  auto changed = std::make_unique<State>(*state_);
  changed->change({prepared.requestedSeeds(), prepared.requested()}, prepared.state_.get());
  state_ = std::move(changed);
}
const std::optional<Correction>& ActiveContour::correction() const { return state_->correction; }
ActiveContour ActiveContour::restarted(const Parameters& parameters) const {
  if (!chooseSameImage(parameters, requested())) return {state_->volume, state_->seeds, parameters};
  requireSensible(parameters);
  auto fresh = std::make_unique<State>();
  fresh->volume = state_->volume;
  fresh->seeds = state_->seeds;
  fresh->object = state_->object;
  fresh->chooseEdge();
  fresh->resolve(parameters);
  fresh->begin();
  return ActiveContour(std::move(fresh));
}
StopReason ActiveContour::stopReason() const { return state_->stop; }
int ActiveContour::iteration() const { return state_->iteration; }
const Mesh& ActiveContour::mesh() const { return state_->mesh; }
const ResolvedParameters& ActiveContour::parameters() const { return state_->parameters; }
const Parameters& ActiveContour::requested() const { return state_->requested; }
const std::vector<Seed>& ActiveContour::requestedSeeds() const { return state_->seeds; }
const std::vector<ObjectCandidate>& ActiveContour::candidates() const { return state_->object.candidates; }
bool ActiveContour::isCloseChoice() const { return state_->object.isCloseChoice; }
bool ActiveContour::isSettled(int vertex) const { return state_->sleeps(vertex); }
std::size_t ActiveContour::memory() const {
  return sizeof(State) + state_->mesh.memory() + state_->quiet.size();
}
SurfaceSupport ActiveContour::support() const { return surfaceSupport(state_->mesh, *state_->object.image); }
std::vector<std::string> ActiveContour::doubts(const SurfaceSupport& support) const {
  std::vector<std::string> doubts = imageDoubts(state_->mesh, *state_->object.image, support);
  if (state_->object.neckRadius > 0) doubts.push_back(heldAtPassages(state_->object.neckRadius));
  return doubts;
}
void ActiveContour::recordTraces(bool on) { state_->traces = on; }

}  // namespace handlebody
