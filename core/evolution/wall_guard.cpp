#include "core/evolution/wall_guard.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/evolution/wall_pieces.h"
#include "core/indices.h"
#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

// Parts of its move that a vertex may take before a wall, tried in turn.
constexpr std::array<double, 5> kParts{1, 0.5, 0.25, 0.125, 0};
constexpr double kSwallows = 6;  // edge lengths from a change of topology to what it may have swallowed
constexpr double kBeside = 6;    // voxels of mean size between a click and the ball that fits near it

}  // namespace

void WallGuard::choose(const WallList& list, const Grid& grid, double edgeLength, double largestStep) {
  edgeLength_ = edgeLength;
  largestStep_ = largestStep;
  pushing_ = nullptr;
  all_ = list.empty() ? nullptr : std::make_shared<const Walls>(list, grid, edgeLength, largestStep);
  holding_ = all_;
}

void WallGuard::putUp(const Mesh& mesh, const WallList& known, bool mayPush) {
  if (!all_) return;
  const bool isTouched = touchesAny(mesh, *all_);
  const WallList fresh = without(all_->list(), known);
  if (!isTouched && fresh.empty()) return;
  const Walls judged(isTouched ? all_->list() : fresh, all_->grid(), edgeLength_, largestStep_);
  const Occupied occupied = findOccupied(mesh, judged);
  const WallList& touched = occupied.touched;
  const auto refuse = [](const Vec3& place, FindingKind why) {
    throw Told<UsageError>(Finding(why, {{"place", placeValue(place)}}));
  };
  if (!touched.objects.empty())
    throw Told<UsageError>(Finding(FindingKind::objectOver, {{"object", touched.objects[0].name}}));
  if (const auto place = placeOfFresh(occupied.enclosed, known, all_->grid()))
    refuse(*place, FindingKind::wallWithin);
  if (!touched.discs.empty()) refuse(touched.discs[0].centre, FindingKind::wallAcross);
  if (!touched.empty() && !mayPush) refuse(placeOf(touched, all_->grid()), FindingKind::wallOver);
  setPushing(touched);
}

void WallGuard::setPushing(const WallList& pushing) {
  pushing_ = nullptr;
  holding_ = all_;
  if (pushing.empty()) return;
  const WallList rest = without(all_->list(), pushing);
  pushing_ = std::make_shared<const Walls>(pushing, all_->grid(), edgeLength_, largestStep_);
  holding_ =
      rest.empty() ? nullptr : std::make_shared<const Walls>(rest, all_->grid(), edgeLength_, largestStep_);
}

Forbidden WallGuard::forbidden() const {
  if (!holding_) return {};
  const auto holds = [walls = holding_](const Vec3& a, const Vec3& b, const Vec3& c) {
    return !walls->clears(a, b, c);
  };
  const auto places = [walls = holding_](const Vec3& low, const Vec3& high) {
    return walls->places((low + high) / 2, (high - low).norm() / 2);
  };
  return {holds, places};
}

void WallGuard::bound(const Mesh& mesh, std::span<const int> moving, double largestStep,
                      std::vector<Vec3>& moves) const {
  if (!holding_) return;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const double length = moves[i].norm();
    if (length > largestStep && holding_->isNear(mesh.position(moving[i]))) moves[i] *= largestStep / length;
  }
}

void WallGuard::holdBack(Mesh& mesh, const Mesh& before, std::span<const int> moving,
                         std::vector<Vec3>& moves) const {
  if (!holding_) return;
  std::vector<int> suspects;
  for (const int v : moving)
    if (holding_->isNear(mesh.position(v))) suspects.push_back(v);
  if (suspects.empty()) return;
  std::vector<int> order(mesh.vertexSlots(), -1);
  for (std::size_t i = 0; i < moving.size(); ++i) order[moving[i]] = static_cast<int>(i);
  const std::vector<Vec3> whole = moves;
  std::vector<unsigned char> part(moves.size(), 0);
  std::vector<int> lastLook(mesh.faceSlots(), -1);
  for (int round = 0; !suspects.empty(); ++round) {
    std::vector<int> cut;
    const auto look = [&](int face) {
      if (std::exchange(lastLook[face], round) == round) return;
      const Triangle& t = mesh.face(face);
      if (holding_->clears(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]))) return;
      for (const int v : t)
        if (order[v] >= 0 && part[order[v]] + 1u < kParts.size()) cut.push_back(v);
    };
    for (const int v : suspects) mesh.forEachOutgoing(v, [&](int h) { look(Mesh::faceOf(h)); });
    sortUnique(cut);
    for (const int v : cut) {
      const std::size_t i = idx(order[v]);
      moves[i] = kParts[++part[i]] * whole[i];
      mesh.setPosition(v, before.position(v) + moves[i]);
    }
    suspects = std::move(cut);
  }
}

std::optional<Vec3> WallGuard::broken(const Mesh& mesh, VertexMarkSpan touched,
                                      std::span<const Event> events) const {
  if (!holding_) return std::nullopt;
  const auto isTouched = [&](int v) { return idx(v) >= touched.size() || touched[v] != 0; };
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0 || !(isTouched(t[0]) || isTouched(t[1]) || isTouched(t[2]))) continue;
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    if (holding_->touches(a, b, c)) return a;
  }
  for (const Event& e : events)
    if (holding_->isNear(e.location) && enclosesAny(mesh, *holding_, e.location, kSwallows * edgeLength_))
      return e.location;
  if (enclosesAny(mesh, holding_->smallParts()))
    for (const Vec3& place : holding_->smallParts())
      if (enclosesAny(mesh, {place})) return place;
  return std::nullopt;
}

std::optional<Vec3> WallGuard::brokenAnywhere(const Mesh& mesh) const {
  if (!holding_) return std::nullopt;
  const Occupied occupied = findOccupied(mesh, *holding_);
  for (const auto* walls : {&occupied.touched, &occupied.enclosed})
    if (!walls->empty()) return placeOf(*walls, holding_->grid());
  return std::nullopt;
}

void WallGuard::release(const Mesh& mesh) {
  if (!pushing_) return;
  WallList still;
  if (touchesAny(mesh, *pushing_)) still = findOccupied(mesh, *pushing_).touched;
  if (!(still == pushing_->list())) setPushing(still);
}

namespace {

void requireFree(const std::vector<Seed>& asked, const Walls& walls) {
  for (const Seed& s : asked) {
    const int object = walls.objects() ? walls.objects()->objectAt(s.centre) : -1;
    if (object >= 0)
      throw Told<SeedError>(
          Finding(FindingKind::seedInObject,
                  {{"place", placeValue(s.centre)}, {"object", walls.list().objects[object].name}}));
    if (walls.distance(s.centre, 1) <= 0)
      throw Told<SeedError>(Finding(FindingKind::wallOverSeed, {{"place", placeValue(s.centre)}}));
  }
}

//! True if the place was not pushed through a wall on the way from a click to what fits near it.
bool isReached(const Seed& from, const Vec3& to, const Walls& walls) {
  const double near = kBeside * walls.grid().meanSpacing();
  return (from.centre - to).norm() <= near && !walls.touches(from.centre, to, to);
}

}  // namespace

std::vector<Seed> clearOfWalls(std::vector<Seed> fitted, const std::vector<Seed>& asked, const Walls& walls,
                               double smallest) {
  requireFree(asked, walls);
  const double clearance = 0.1 * walls.grid().spacing.minCoeff();
  for (Seed& s : fitted) {
    const bool reached = std::any_of(asked.begin(), asked.end(),
                                     [&](const Seed& from) { return isReached(from, s.centre, walls); });
    const double needed = *s.radius + clearance, free = walls.distance(s.centre, needed);
    const double room = free < needed ? free - clearance : *s.radius;
    if (!reached || room < std::min(*s.radius, smallest))
      throw Told<SeedError>(Finding(FindingKind::wallLeavesNoRoom, {{"place", placeValue(s.centre)}}));
    s.radius = std::min(*s.radius, room);
  }
  return fitted;
}

bool isFree(const Mesh& mesh, const WallList& walls, const Grid& grid) {
  if (walls.empty()) return true;
  double longest = 0;
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    if (mesh.isFace(Mesh::faceOf(h)))
      longest = std::max(longest, (mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))).norm());
  const Occupied occupied = findOccupied(mesh, Walls(walls, grid, longest, longest));
  return occupied.touched.empty() && occupied.enclosed.empty();
}

}  // namespace handlebody
