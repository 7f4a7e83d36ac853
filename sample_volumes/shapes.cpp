#include "sample_volumes/shapes.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "sample_volumes/distances.h"
#include "sample_volumes/labyrinths.h"

namespace handlebody::phantoms {
namespace {

double cubeDistance(const Vec3& p) { return frameDistance(p, 40, 47.5); }

// Two rings that cross at right angles in two nodes: four arms of equal length, each a half circle.
constexpr double kRing = 32;
double genus3Distance(const Vec3& p) {
  const double arms =
      std::min(torusDistance(p, Vec3::UnitX(), kRing, 8), torusDistance(p, Vec3::UnitY(), kRing, 8));
  const double nodes = ballDistance(Vec3(p.x(), p.y(), std::abs(p.z()) - kRing), 12);
  return std::min(arms, nodes);
}

double torusWithBallsDistance(const Vec3& p) {
  const double at = 30 * std::sqrt(0.5);  // four balls on the diagonals of the ring
  const Vec3 ball(std::abs(p.x()) - at, std::abs(p.y()) - at, p.z());
  return std::max(torusDistance(p, Vec3::UnitZ(), 30, 13.3), -ballDistance(ball, 6));
}

double sphereDistance(const Vec3& p) { return ballDistance(p, 30); }

double dumbbellDistance(const Vec3& p) {
  const double balls = ballDistance(Vec3(std::abs(p.x()) - 26, p.y(), p.z()), 16);
  return std::min(balls, capsuleDistance(p, 26, 6));
}

const Vec3 kChamber(20, 30, 30);  // half sides, mm; the wall between the two is 2 mm thick
double leftChamberDistance(const Vec3& p) { return boxDistance(p + 21 * Vec3::UnitX(), kChamber, 6); }

double bothChambersDistance(const Vec3& p, const Hole& hole) {
  const double chambers = boxDistance(Vec3(std::abs(p.x()) - 21, p.y(), p.z()), kChamber, 6);
  if (hole.empty()) return chambers;
  const Vec3 low(-5, hole.low[0], hole.low[1]);
  const Vec3 high(5, hole.high[0], hole.high[1]);
  return std::min(chambers, boxDistance(p - (low + high) / 2, (high - low) / 2, 0));
}

std::vector<Shape> makeShapes() {
  std::vector<Shape> shapes;
  const auto add = [&](const char* name, Vec3 extent, Vec3 objectHalf, double thinnest, Vec3 seed,
                       double seedRadius, std::vector<int> genus, double (*distance)(const Vec3&)) -> Shape& {
    Shape& s = shapes.emplace_back();
    s.name = name;
    s.extent = extent;
    s.objectHalf = objectHalf;
    s.thinnest = thinnest;
    s.seed = seed;
    s.seedRadius = seedRadius;
    s.genus = std::move(genus);
    s.distance = distance;
    return s;
  };
  Shape& cyst = add("cyst", {199, 99, 171}, {76, 41, 58}, 7, {-22, 0, 0}, 8, {1}, cystDistance);
  cyst.speckle = true;
  cyst.noise = 0.2;  // at a contrast of 28 dB: the 5.6 dB of fully developed speckle
  cyst.depthLoss = 0.25;
  cyst.brightness = cystBrightness;
  const Vec3 hundred(100, 100, 100);
  add("cube", hundred, {40, 40, 40}, 7, {32, 32, 32}, 6, {5}, cubeDistance).noise = 0.12;
  add("genus3", hundred, {40, 40, 44}, 12, {0, 0, kRing}, 7, {3}, genus3Distance);
  add("torus", hundred, {43.3, 43.3, 13.3}, 7, {30, 0, 0}, 8, {1, 0, 0, 0, 0}, torusWithBallsDistance);
  add("sphere", {80, 80, 80}, {30, 30, 30}, 20, {6, -4, 3}, 8, {0}, sphereDistance);
  add("dumbbell", {100, 60, 60}, {42, 16, 16}, 12, {-26, 0, 0}, 8, {0}, dumbbellDistance);
  add("wall", {100, 80, 80}, {41, 30, 30}, 4, {-21, 0, 0}, 10, {0}, leftChamberDistance).dark =
      bothChambersDistance;
  add("rings", {100, 80, 80}, {42, 30, 30}, 10, kRingsSeed, 5, {2}, ringsDistance);
  add("trefoil", {100, 100, 60}, {45, 45, 19}, 11, trefoilPoint(0.3), 4.5, {1}, trefoilDistance);
  add("tree", {100, 60, 100}, {39, 23, 45}, 6, kTreeSeed, 2.5, {3}, treeDistance);
  add("balls", hundred, {45, 45, 45}, 4, {-6, 2, 2}, 8, std::vector<int>(1 + kBallsCavities, 0),
      ballsDistance);
  add("plate", {84, 68, 20}, {36, 28, 2}, 4, {-20, 10, 0}, 1.6, {0}, plateDistance);
  add("neck", {100, 60, 60}, {40, 16, 16}, 5, {-24, 2, 1}, 8, {0}, neckDistance);
  add("gyroid", hundred, {44, 44, 44}, 8, {-5, -5, -5}, 5, {27}, gyroidDistance);
  return shapes;
}

}  // namespace

const std::vector<Shape>& allShapes() {
  static const std::vector<Shape> shapes = makeShapes();
  return shapes;
}

const Shape& findShape(const std::string& name) {
  std::string known;
  for (const Shape& shape : allShapes()) {
    if (shape.name == name) return shape;
    known += (known.empty() ? "" : ", ") + shape.name;
  }
  throw UsageError("There is no phantom \"" + name + "\"; there are: " + known + ", beating.");
}

}  // namespace handlebody::phantoms
