#include "core/evolution/active_contour.h"

#include <algorithm>
#include <tuple>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/evolution/adaptation_rounds.h"
#include "core/evolution/contour_state.h"
#include "core/evolution/image_doubts.h"
#include "core/indices.h"
#include "core/mesh/morton_order.h"

namespace handlebody {

namespace {

// Of surgery in an attempt after those that have spent what a step has (units of WorkBudget).
constexpr std::size_t kLeastWork = 10'000'000;

constexpr double kGrowthToReorder = 1.5;  // of the mesh, until its vertices are put into order again

}  // namespace

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
    a.troubles.push_back({*place, 2 * limits.longest, FindingKind::entersWall});
  if (a.troubles.empty()) stopBeforeFlat(a);
  if (a.troubles.empty()) lookAtPins(a);
  return a;
}

void ActiveContour::State::adapt(Attempt& a) {
  AdaptationSettings settings{!mayShrink(), traces, iteration, topology, {}, limits.forbidden, &work};
  settings.cameBack = [this](const Vec3& p) { return resting.cameBack(p, longestAt(p)); };
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
  const auto measure = [&](const Event& e) {
    return heldSize(e, transaction.before(), mesh, limits.longest);
  };
  std::vector<HeldChange> changes = held.judge(a.events, iteration, limits.longest, measure);
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
    if (e.kind != EventKind::rolledBack && resting.repeats(e.location, longestAt(e.location)))
      report.events.push_back(rolledBack(e.location, FindingKind::changesAgain));
  }
}

Event ActiveContour::State::rolledBack(const Vec3& place, Finding reason) const {
  Event event;
  event.kind = EventKind::rolledBack;
  event.iteration = iteration;
  event.location = place;
  event.before = event.after = topology;
  event.reasons = {std::move(reason)};
  return event;
}

//! For leaks. The step has been made: it is not to be cancelled any more.
void ActiveContour::State::watch(const Attempt& kept, StepReport& report) {
  const CancelScope scope(nullptr);
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
  else if (isDone())
    stop = StopReason::given;
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
      resting.add(t.centre, sizeAt(t.centre) * (t.radius + 0.5 * limits.longest), iteration, t.waits);
  };
  Attempt last = transaction.run({mesh, topology, limits.longest, [this] { return attempt(); },
                                  [&](const Attempt& a) { return judge(a, report); }, rollBack});
  if (last.isKept())
    accept(last, report);
  else
    rollBack({last.place(), 1e3 * parameters.edgeLength, FindingKind::nothingKept});
  if (walls.isPushing()) {
    walls.release(mesh);
    chooseForbidden();
  }
  // Of the mesh that is left, also when all of the step was rolled back.
  report.settledVertices = std::max(0, mesh.vertexCount() - report.movedVertices);
  report.volume = transaction.volume();
  report.questions = held.questions(iteration);
  watch(last, report);
  decideStop(report);
  takePins();
  return report;
}

ActiveContour::ActiveContour(Volume volume, std::vector<Seed> seeds, Parameters parameters,
                             const Constraints& constraints, ObjectMemory* memory)
    : state_(std::make_unique<State>()) {
  requireSensible(parameters);
  requireSensible(constraints, volume.grid);
  state_->volume = std::move(volume);
  state_->seeds = std::move(seeds);
  state_->object = objectOf(state_->volume, state_->seeds, parameters, constraints.start, memory);
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
  if (!chooseSameImage(parameters, requested()) || constraints.start != this->constraints().start)
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
void ActiveContour::startFrom(const Mesh& mesh, bool holdTopology) {
  auto changed = std::make_unique<State>(*state_);
  changed->startFrom(mesh, holdTopology);
  state_ = std::move(changed);
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
const std::vector<ObjectCandidate>& ActiveContour::candidates() const {
  return state_->object.choices->get().candidates;
}
bool ActiveContour::isCloseChoice() const { return state_->object.choices->get().isCloseChoice; }
std::shared_ptr<const AskedChoices> ActiveContour::choices() const { return state_->object.choices; }
bool ActiveContour::isSettled(int vertex) const { return state_->sleeps(vertex); }
bool ActiveContour::isPinned(int vertex) const { return state_->pins.holds(vertex); }
std::size_t ActiveContour::memory() const {
  return sizeof(State) + state_->mesh.memory() + state_->quiet.size();
}
SurfaceSupport ActiveContour::support() const {
  if (!state_->isDone()) return surfaceSupport(state_->mesh, *state_->object.image);
  return {std::vector<FaceSupport>(static_cast<std::size_t>(state_->mesh.faceCount()), FaceSupport::edge), 0,
          0};
}
std::vector<Finding> ActiveContour::doubts(const SurfaceSupport& support) const {
  std::vector<Finding> doubts;
  if (!state_->isDone()) doubts = imageDoubts(state_->mesh, *state_->object.image, support);
  if (state_->walls.isPushing()) doubts.push_back(FindingKind::liesInWall);
  for (Finding& d : state_->held.doubts()) doubts.push_back(std::move(d));
  if (state_->object.neckRadius > 0)
    doubts.push_back({FindingKind::heldAtPassages, {{"radius_mm", state_->object.neckRadius}}});
  return doubts;
}
void ActiveContour::recordTraces(bool on) { state_->traces = on; }

}  // namespace handlebody
