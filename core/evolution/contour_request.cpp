// What a contour is asked for: at first, and when it is changed on the way.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/collision/body_contact.h"
#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/evolution/contour_state.h"
#include "core/evolution/seeds.h"
#include "core/evolution/start_object.h"
#include "core/indices.h"
#include "core/mesh/structure.h"
#include "core/phase.h"
#include "core/threads.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

// Lengths as parts of the target edge length.
constexpr double kLongest = 1.4;  // the paper's bound s
constexpr double kShortest = 0.55;
constexpr double kStep =
    0.28;  // largest move along the normal: two fronts come closer by little more than s / 3
constexpr double kStepVoxels = 0.9;  // and never further than this many voxels of the finest axis
// Of an object, from a place in it to its boundary: from here on longer edges save a sixth of the time and
// more (docs/adaptive.md).
constexpr double kWideEdges = 6;
constexpr double kAgrees = 0.5;  // voxels between a boundary and a surface that agree

}  // namespace

//! Two voxels, but finer in thin structures.
void ActiveContour::State::chooseEdge() {
  const double voxel = volume.grid.meanSpacing();
  const auto image = object.image->behind(nullptr);
  double fit = 0;
  for (const Seed& s : seedsInside()) fit = std::max(fit, fittingRadius(*image, s.centre, 8 * voxel));
  automaticEdge = std::clamp(0.6 * fit / voxel, 1.0, 2.0) * voxel;
}

//! Everything but the seeds' radii. Precondition: object and automatic edge length are chosen.
void ActiveContour::State::resolve() {
  const Parameters& p = asked.parameters;
  const double edge = p.edgeLength.value_or(automaticEdge);
  parameters.object = object.kind;
  parameters.range = object.range;
  parameters.smoothing = object.smoothing;
  parameters.candidate = object.candidate;
  parameters.edgeLength = edge;
  parameters.direction = p.direction;
  parameters.balloon = p.balloon;
  parameters.curvature = p.curvature;
  parameters.maxIterations = p.maxIterations;
  parameters.threads = threadCount(p.threads);
  parameters.broadPhase = p.broadPhase;
  parameters.resolution = p.resolution;

  motion.balloon = p.balloon;
  motion.curvature = p.curvature;
  motion.edgeLength = edge;
  motion.largestStep = std::min(kStep * edge, kStepVoxels * volume.grid.spacing.minCoeff());
  motion.outwardOnly = p.direction == Direction::outward;
  motion.threads = parameters.threads;
  limits.longest = kLongest * edge;
  limits.shortest = kShortest * edge;
  chooseWalls();
}

void ActiveContour::State::chooseWalls() {
  walls.choose(asked.constraints.walls, volume.grid, parameters.edgeLength, motion.largestStep);
  object.image = object.image->behind(walls.all());
  chooseForbidden();
}

void ActiveContour::State::chooseForbidden() {
  limits.forbidden = walls.forbidden();
  limits.forbidden.pinned = locked.pins.mask();
}

//! Of a mesh with longer edges than from now on. If it would not be valid then, it stays as it is, and the
//! steps that follow split them where it moves.
void ActiveContour::State::splitLongEdges() {
  Mesh split = mesh;
  VertexStates regulated(idx(mesh.vertexSlots()), kActive);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (!mesh.isVertex(v) || locked.pins.holds(v)) regulated[v] = kAtRest;
  regulate(split, {limits.longest, 0, {}, limits.forbidden}, regulated);
  if (findStructureFault(split) || !certify(split.compact()).boundsBody()) return;
  mesh = std::move(split);
  active.resize(mesh.vertexSlots());
}

//! Where edges may be longer; null where they are to be the same everywhere.
std::shared_ptr<const SizeField> ActiveContour::State::sizesFor(const std::vector<Seed>& inside) const {
  std::vector<Vec3> starts;
  for (const Seed& s : inside) starts.push_back(s.centre);
  auto sizes = std::make_shared<const SizeField>(*object.image, starts, parameters.edgeLength);
  const bool pays = sizes->widest() >= kWideEdges;
  return pays || asked.parameters.resolution == Resolution::adaptive ? sizes : nullptr;
}

//! Walls and pins rest on edges that are nowhere longer than the target: with any, the sizes are uniform, but
//! for shorter ones before hollow objects.
void ActiveContour::State::chooseSizes(const std::vector<Seed>& inside, bool anew) {
  const bool isUniform = asked.parameters.resolution == Resolution::uniform || isDone() || walls.all() ||
                         !asked.constraints.pins.empty();
  const bool wasLonger = motion.sizes != nullptr;
  if (isUniform)
    motion.sizes = nullptr;
  else if (anew || !wasLonger)
    motion.sizes = sizesFor(inside);
  parameters.resolution = motion.sizes ? Resolution::adaptive : Resolution::uniform;
  if (!motion.sizes) {
    limits.size = nullptr;
    if (walls.all() && walls.all()->objects())
      limits.size = [near = walls.all()](const Vec3& p) { return near->edgePart(p); };
    if (wasLonger) splitLongEdges();
    return;
  }
  limits.size = [sizes = motion.sizes](const Vec3& p) { return sizes->at(p); };
}

//! Precondition: volume and object are chosen.
void ActiveContour::State::start(Request request) {
  const Phase phase("first surface");
  asked = std::move(request);
  locked.held.choose(asked.constraints, 0);
  locked.pins.choose(asked.constraints.pins, 0);
  edits.choose(asked.constraints.edits, 0);
  chooseEdge();
  resolve();
  begin(true);
  takePins();
}

std::vector<Seed> ActiveContour::State::seedsInside() const {
  std::vector<Seed> inside = seedsOfSide(asked.seeds, false);
  const std::optional<StartSurface>& surface = asked.constraints.start;
  if (inside.empty() && surface) inside.push_back(seedWithin(*surface));
  return inside;
}

void ActiveContour::State::begin(bool withStart) {
  if (withStart && asked.constraints.start) {
    beginWithStart();
  } else {
    const std::vector<Seed> clicks = seedsInside();
    std::vector<Seed> inside =
        fitSeeds(*object.image, clicks, parameters.edgeLength, parameters.direction == Direction::both);
    if (walls.all()) inside = clearOfWalls(inside, clicks, *walls.all(), limits.shortest);
    chooseSizes(inside, true);
    mesh = seedMesh(inside, parameters.edgeLength, motion.sizes.get());
    resolveSeeds(inside);
  }
  active.activateAll(mesh.vertexSlots());
  topology = topologyNumbers(mesh);
  stop.begin(facts());
}

//! Its vertices and edges are as they were given until the first step regulates them.
void ActiveContour::State::beginWithStart() {
  const StartSurface& start = *asked.constraints.start;
  for (const WallObject& other : asked.constraints.walls.objects)
    if (bodyContact(*other.mesh, *start.mesh) != BodyContact::none)
      throw Told<UsageError>(
          Finding(FindingKind::startMeetsObject, {{"file", start.path}, {"object", other.name}}));
  mesh = Mesh(*start.mesh);
  std::vector<Seed> inside;
  if (!isDone()) {
    inside = fitSeeds(*object.image, seedsInside(), parameters.edgeLength,
                      parameters.direction == Direction::both);
    chooseSizes(inside, true);
    walls.putUp(mesh, {}, mayShrink());
    chooseForbidden();
  }
  resolveSeeds(inside);
}

//! Where nothing is to grow the image is not asked.
ClickedObject objectOf(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& parameters,
                       const std::optional<StartSurface>& start, ObjectMemory* memory) {
  if (!start) return findClickedObject(volume, seeds, parameters, memory);
  if (!start->isDone) return findClickedObject(volume, seeds, parameters, memory, &*start);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ClickedObject object;
  object.range = {-kInfinity, kInfinity};
  object.choices = std::make_shared<const AskedChoices>(ObjectChoices{});
  object.image =
      std::make_shared<ObjectImage>(std::make_shared<SmoothedVolume>(volume, 0.0), object.range, 1.0);
  return object;
}

void ActiveContour::State::startFrom(const Mesh& surface, bool holdTopology) {
  mesh = surface;
  active.activateAll(mesh.vertexSlots());
  topology = topologyNumbers(mesh);
  locked.held.holdTopology(holdTopology);
  walls.putUp(mesh, {}, mayShrink());
  chooseForbidden();
}

void ActiveContour::State::resolveSeeds(const std::vector<Seed>& inside) {
  parameters.seeds = inside;
  for (Seed s : seedsOfSide(asked.seeds, true)) {
    s.radius = s.radius.value_or(volume.grid.meanSpacing());
    parameters.seeds.push_back(s);
  }
}

void ActiveContour::State::change(const Request& to, const State* prepared) {
  requireSensible(to.parameters);
  requireSensible(to.constraints, volume.grid);
  if (to.constraints.start != asked.constraints.start) throw Told<UsageError>(FindingKind::startCannotChange);
  const WallList known = asked.constraints.walls;
  const Parameters before = asked.parameters;
  const bool otherWalls = to.constraints.walls != known;
  const bool otherClicks = to.seeds != asked.seeds;
  const bool otherImage = otherClicks || !chooseSameImage(to.parameters, before);
  const bool freed = locked.held.choose(to.constraints, iteration);
  const bool unpinned = locked.pins.choose(to.constraints.pins, iteration);
  takePins();
  edits.choose(to.constraints.edits, iteration);
  const bool activates = otherClicks || otherWalls || freed || unpinned || !moveAlike(to.parameters, before);
  const bool staysConverged = otherClicks && haveSameForces(to.parameters, before);
  asked = to;
  if (otherImage)
    object = prepared ? prepared->object
                      : objectOf(volume, asked.seeds, to.parameters, asked.constraints.start, nullptr);
  if (otherImage && !otherClicks) chooseEdge();
  const double edge = parameters.edgeLength;
  resolve();
  const bool isOtherEdge = parameters.edgeLength != edge;
  if (activates) forgetLocks();
  if (activates && !staysConverged) active.activateAll(mesh.vertexSlots());
  if (otherClicks && !isDone()) correct();
  if (otherClicks || otherImage || otherWalls) alarm.forget();
  chooseSizes(seedsOfSide(parameters.seeds, false), otherImage || isOtherEdge);
  walls.putUp(mesh, known, mayShrink());
  chooseForbidden();
  stop.change(facts(), activates);
}

void ActiveContour::State::forgetLocks() {
  locked.forgetRollbacks();
  stop.forgetLocks();
  transaction.forgetCollapsed();
}

//! After a change of the clicks. What had converged and agrees with the new image stays so.
void ActiveContour::State::correct() {
  std::vector<Seed> fronts;
  const PinnedParts& pins = locked.pins;
  const auto isPinned = [&pins](int v) { return pins.holds(v); };
  correction = correctComponents(mesh, *object.image, asked.seeds, parameters.edgeLength, limits.longest,
                                 fronts, pins.any() ? isPinned : std::function<bool(int)>());
  if (correction->beganAnew) {
    if (pins.any()) throw Told<UsageError>(Finding(FindingKind::clicksVersusPins));
    beginAnew();
    return;
  }
  std::vector<Seed> inside = seedsOfSide(parameters.seeds, false);
  inside.insert(inside.end(), fronts.begin(), fronts.end());
  resolveSeeds(inside);
  const Disagreement differs = findDisagreement(mesh, *object.image, kAgrees * volume.grid.meanSpacing());
  correction->givesGround = differs.isOutside;
  active.resize(mesh.vertexSlots());
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (differs.vertices[v] != 0) active.activate(v);
  topology = topologyNumbers(mesh);
}

void ActiveContour::State::beginAnew() {
  chooseEdge();
  resolve();
  orderedVertices = kFitsIntoCache;
  begin(false);
}

}  // namespace handlebody
