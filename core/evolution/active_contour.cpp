#include "core/evolution/active_contour.h"

#include <algorithm>

#include "core/cancellation.h"
#include "core/evolution/click_faults.h"
#include "core/evolution/contour_state.h"
#include "core/evolution/image_warnings.h"
#include "core/evolution/parameter_limits.h"
#include "core/indices.h"
#include "core/mesh/morton_order.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

constexpr double kGrowthToReorder = 1.5;  // of the mesh, until its vertices are put into order again

}  // namespace

StepScene ActiveContour::State::scene() {
  return {*object.image,         motion,   limits,    walls,       active, locked,
          parameters.broadPhase, topology, iteration, mayShrink(), traces};
}

StopFacts ActiveContour::State::facts() const {
  StopFacts f{iteration, parameters.maxIterations, mesh.vertexCount(), mesh.faceCount(), isDone()};
  if (const auto next = edits.waiting()) f.nextEdit = next->iteration;
  return f;
}

//! A ring of a mesh that has grown lies anywhere in memory. At 150,000 vertices it costs five times as much
//! to look at as one in order.
void ActiveContour::State::keepOrder() {
  if (mesh.vertexSlots() < kGrowthToReorder * orderedVertices) return;
  unordered = {mesh, active, locked.pins, orderedVertices};
  const std::vector<int> order = mortonOrder(mesh, parameters.edgeLength);
  mesh.reorder(order);
  locked.pins.reorder(order);
  chooseForbidden();
  active.reorder(order);
  orderedVertices = mesh.vertexSlots();
}

//! Of a step that has not been made: what is asked for before the next try finds the vertices as a run that
//! was never interrupted does.
void ActiveContour::State::takeOrderBack() {
  if (!unordered) return;
  mesh = std::move(unordered->mesh);
  active = std::move(unordered->active);
  locked.pins = std::move(unordered->pins);
  orderedVertices = unordered->orderedVertices;
  unordered.reset();
  chooseForbidden();
}

void ActiveContour::State::accept(const Attempt& a, StepReport& report) {
  active.count(mesh, {a.moving, a.distances, a.touched}, parameters.edgeLength);
  for (double d : a.distances) {
    report.movedVertices += d >= kUnmoved * parameters.edgeLength;
    report.largestMove = std::max(report.largestMove, d);
  }
  if (!report.events.empty()) topology = report.events.back().after;
}

//! For leaks.
void ActiveContour::State::watch(const Attempt& kept, StepReport& report) {
  std::vector<Vec3> starts;
  for (const Seed& s : seedsOfSide(parameters.seeds, false)) starts.push_back(s.centre);
  const LeakAlarm::Scene scene{*object.image, walls.all().get(), starts, iteration, motion.threads};
  report.leaks = alarm.look(mesh, kept.moving, scene);
}

//! Of the mesh that is left, also when all of the step was rolled back.
void ActiveContour::State::finish(StepReport& report) {
  const bool isEdit = !report.events.empty() && report.events.front().edit;
  const bool isUneventful = report.events.empty() && !locked.regions.anyWillUnlock(iteration);
  const auto whyAtRest = [this] {
    return reasonOfRest(mesh, *object.image, motion, locked.regions, iteration);
  };
  stop.afterStep(facts(), {isEdit, isUneventful, report.movedVertices}, whyAtRest);
  takePins();
}

void ActiveContour::State::takePins() {
  locked.pins.take(mesh, iteration);
  chooseForbidden();
}

//! Walls that the surface has been pushed out of hold from now on.
void ActiveContour::State::releaseWalls() {
  if (!walls.isPushing()) return;
  walls.release(mesh);
  chooseForbidden();
}

//! As if it had never begun, if it is cancelled: the transaction takes the mesh back, and this all that an
//! attempt leaves besides. Whatever else is thrown may come after the mesh was accepted: the iteration then
//! says so, and the history restores what was before.
StepReport ActiveContour::State::stepOrNothing() {
  const int iterationBefore = iteration;
  const Restraints lockedBefore = locked;
  const CollapsedComponents collapsedBefore = transaction.collapsed();
  unordered.reset();  // of a step that something else has broken off
  try {
    StepReport report = step();
    unordered.reset();
    return report;
  } catch (const Cancelled&) {
    iteration = iterationBefore;
    locked.takeBack(lockedBefore);
    takeOrderBack();
    transaction.takeBack(collapsedBefore);
    throw;
  }
}

StepReport ActiveContour::State::step() {
  if (const MeshEdit* edit = edits.dueAt(iteration + 1)) return editStep(MeshEdit(*edit));
  if (isDone()) return waitingStep();
  StepReport report;
  report.iteration = ++iteration;
  keepOrder();
  StepOutcome made = transaction.move(mesh, scene());
  const CancelScope isMade(nullptr);  // it is not to be cancelled any more
  report.events = std::move(made.events);
  if (made.last.isKept()) accept(made.last, report);
  releaseWalls();
  report.unmovedVertices = std::max(0, mesh.vertexCount() - report.movedVertices);
  report.volume = transaction.volume();
  report.questions = locked.held.questions(iteration);
  watch(made.last, report);
  finish(report);
  return report;
}

//! Nothing grows on the way to an edit of an object that was given.
StepReport ActiveContour::State::waitingStep() {
  const CancelScope isMade(nullptr);
  StepReport report;
  report.iteration = ++iteration;
  report.unmovedVertices = mesh.vertexCount();
  report.volume = signedVolume(mesh);
  finish(report);
  return report;
}

//! All or nothing: what throws has changed nothing.
StepReport ActiveContour::State::editStep(const MeshEdit& edit) {
  Attempt made = transaction.edit(mesh, edit, scene(), asked.constraints.topology);
  const CancelScope isMade(nullptr);
  StepReport report;
  report.iteration = ++iteration;
  edits.setMade(edit);
  active.convergeChanged(transaction.before(), mesh, made.touched);
  topology = made.events.back().after;
  report.events = std::move(made.events);
  releaseWalls();
  report.unmovedVertices = mesh.vertexCount();
  report.volume = transaction.volume();
  finish(report);
  return report;
}

namespace {

void requireWithin(const Parameters& p, const Grid& grid) {
  const ParameterLimits limits = limitsFor(grid);
  const auto require = [&](const std::optional<double>& given, double most, FindingKind kind) {
    if (given && *given > most)
      throw Told<UsageError>(
          Finding(kind, {{"given_mm", *given}, {"longest_mm", limits.longestSide}, {"most_mm", most}}));
  };
  require(p.smoothing, limits.smoothing, FindingKind::smoothingTooLarge);
  require(p.edgeLength, limits.edgeLength, FindingKind::edgeTooLarge);
}

}  // namespace

ActiveContour::ActiveContour(Volume volume, std::vector<Seed> seeds, Parameters parameters,
                             const Constraints& constraints, ObjectMemory* memory)
    : state_(std::make_unique<State>()) {
  requireSensible(parameters);
  requireWithin(parameters, volume.grid);
  requireSensible(constraints, volume.grid);
  state_->volume = std::move(volume);
  state_->object = objectOf(state_->volume, seeds, parameters, constraints.start, memory);
  state_->start({std::move(seeds), parameters, constraints});
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
    return {state_->volume, requestedSeeds(), parameters, constraints};
  requireSensible(parameters);
  requireWithin(parameters, grid());
  requireSensible(constraints, grid());
  auto fresh = std::make_unique<State>();
  fresh->volume = state_->volume;
  fresh->object = state_->object;
  fresh->start({requestedSeeds(), parameters, constraints});
  return ActiveContour(std::move(fresh));
}
void ActiveContour::startFrom(const Mesh& mesh, bool holdTopology) {
  auto changed = std::make_unique<State>(*state_);
  changed->startFrom(mesh, holdTopology);
  state_ = std::move(changed);
}
StopReason ActiveContour::stopReason() const { return state_->stop.reason(); }
int ActiveContour::iteration() const { return state_->iteration; }
const Mesh& ActiveContour::mesh() const { return state_->mesh; }
const Grid& ActiveContour::grid() const { return state_->volume.grid; }
const ResolvedParameters& ActiveContour::parameters() const { return state_->parameters; }
std::shared_ptr<const ObjectImage> ActiveContour::image() const { return state_->object.image; }
const Parameters& ActiveContour::requested() const { return state_->asked.parameters; }
const std::vector<Seed>& ActiveContour::requestedSeeds() const { return state_->asked.seeds; }
const Constraints& ActiveContour::constraints() const { return state_->asked.constraints; }
std::optional<Veto> ActiveContour::waitingVeto() const { return state_->locked.held.waiting(); }
std::vector<PinnedPart> ActiveContour::pinned() const { return state_->locked.pins.list(); }
std::optional<Pin> ActiveContour::waitingPin() const { return state_->locked.pins.waiting(); }
std::optional<MeshEdit> ActiveContour::waitingEdit() const { return state_->edits.waiting(); }
std::vector<HeldPlace> ActiveContour::held() const { return state_->locked.held.list(); }
const std::vector<ObjectCandidate>& ActiveContour::candidates() const {
  return state_->object.choices->get().candidates;
}
bool ActiveContour::isCloseChoice() const { return state_->object.choices->get().isCloseChoice; }
std::shared_ptr<const AskedChoices> ActiveContour::choices() const { return state_->object.choices; }
bool ActiveContour::isConverged(int vertex) const { return state_->active.isConverged(vertex); }
bool ActiveContour::isPinned(int vertex) const { return state_->locked.pins.holds(vertex); }
std::size_t ActiveContour::memory() const {
  return sizeof(State) + state_->mesh.memory() + state_->active.memory();
}
SurfaceSupport ActiveContour::support() const {
  return state_->isDone() ? SurfaceSupport{} : surfaceSupport(state_->mesh, *state_->object.image);
}
std::vector<Finding> ActiveContour::warnings(const SurfaceSupport& support) const {
  std::vector<Finding> warnings;
  if (!state_->isDone()) warnings = imageWarnings(state_->mesh, *state_->object.image, support);
  const int asked = requested().candidate, taken = parameters().candidate;
  if (!state_->isDone() && !requested().range && asked > taken)
    warnings.push_back({FindingKind::fewerCandidates, {{"asked", asked}, {"taken", taken}}});
  if (stopReason() != StopReason::running)
    for (Finding& click : unheededClicks(state_->mesh, state_->volume.grid, state_->asked.seeds))
      warnings.push_back(std::move(click));
  if (state_->walls.isPushing()) warnings.push_back(FindingKind::liesInWall);
  for (Finding& d : state_->locked.held.warnings()) warnings.push_back(std::move(d));
  if (state_->object.neckRadius > 0)
    warnings.push_back({FindingKind::heldAtPassages, {{"radius_mm", state_->object.neckRadius}}});
  if (state_->object.isCutOff) warnings.push_back(FindingKind::endsWithSearch);
  return warnings;
}
void ActiveContour::recordTraces(bool on) { state_->traces = on; }

}  // namespace handlebody
