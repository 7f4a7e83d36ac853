#include "core/evolution/seeds.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/shapes.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFit = 0.85;  // part of the fitting radius that a seed takes
constexpr double kLargestSeed =
    4.0;  // edge lengths; a larger seed saves little time and may reach over a thin wall
constexpr int kLookAround = 4, kPlaces = 26;  // voxels from a click, and places at each distance
constexpr double kPassage = 0.75;             // edge lengths: radius of a passage that a front surely passes
constexpr double kRound = 0.5;                // edge length of a sphere, in parts of its radius
constexpr double kSmallestSeed = 0.7;         // edge lengths: a smaller sphere would be collapsed at once

//! Evenly spread directions (Fibonacci lattice).
std::vector<Vec3> directions(int n) {
  std::vector<Vec3> d;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, angle = i * kPi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
    d.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return d;
}

//! More than a growth can handle in any patience; without a limit a mistyped edge length fills the memory.
constexpr double kMaxTriangles = 2e6;

void requireManageable(const std::vector<Seed>& seeds, double edgeLength) {
  double triangles = 0;  // of that edge length on the spheres
  for (const Seed& s : seeds) {
    const double ratio = *s.radius / edgeLength;
    triangles += 16 * kPi / std::sqrt(3.0) * ratio * ratio;
  }
  if (triangles <= kMaxTriangles) return;
  throw Told<UsageError>(Finding(FindingKind::edgeTooShort, {{"edge_mm", edgeLength}}));
}

}  // namespace

double fittingRadius(const ObjectImage& image, const Vec3& centre, double limit) {
  const double step = 0.25 * image.volume().grid().spacing.minCoeff();
  const std::vector<Vec3> around = directions(64);
  for (double radius = step; radius < limit; radius += step)
    for (const Vec3& d : around)
      if (image.inside(centre + radius * d) <= 0) return radius - step;
  return limit;
}

Vec3 roomiestNear(const ObjectImage& image, const Vec3& centre, double wanted) {
  const double fit = fittingRadius(image, centre, wanted);
  if (fit >= wanted || !image.isRegion()) return centre;
  const double step = image.volume().grid().meanSpacing();
  Vec3 best = centre;
  double deepest = image.inside(centre) > 0 ? fit : -1;
  for (int ring = 1; ring <= kLookAround; ++ring)
    for (const Vec3& d : directions(kPlaces)) {
      const Vec3 at = centre + ring * step * d;
      if (image.inside(at) <= 0) continue;
      const double here = fittingRadius(image, at, wanted);
      if (here > deepest + 0.1 * step) deepest = here, best = at;
    }
  return best;
}

namespace {

std::vector<Vec3> centresOf(const std::vector<Seed>& seeds) {
  std::vector<Vec3> centres;
  for (const Seed& s : seeds) centres.push_back(s.centre);
  return centres;
}

//! Radius of a ball that lies in the object; no more than was asked for.
double radiusWithin(const ObjectImage& image, const Seed& seed, double edgeLength) {
  const double fit =
      fittingRadius(image, seed.centre, std::max(seed.radius.value_or(0), kLargestSeed * edgeLength));
  return seed.radius ? std::min(*seed.radius, fit) : kFit * fit;
}

}  // namespace

// A click without a radius that corrects a region needs no start of its own there: two fronts that meet
// widely cost much, and win nothing.
bool comesAnyway(const ObjectImage& image, const std::vector<Vec3>& from, const Vec3& to, double edgeLength) {
  return std::any_of(from.begin(), from.end(),
                     [&](const Vec3& p) { return image.reaches(p, to, kPassage * edgeLength); });
}

std::optional<Seed> fitBall(const ObjectImage& image, const Seed& asked, double edgeLength,
                            const std::function<double(const Vec3&)>& room) {
  const double smallest = kSmallestSeed * edgeLength;
  const auto ballAt = [&](const Vec3& place) {
    const double fit = radiusWithin(image, {place, asked.radius}, edgeLength);
    return Seed{place, std::min(std::max(fit, smallest), room(place))};
  };
  Seed best = ballAt(asked.centre);
  const double step = image.volume().grid().meanSpacing();
  for (int ring = 1; ring <= kLookAround && *best.radius < smallest; ++ring)
    for (const Vec3& d : directions(kPlaces)) {
      const Vec3 at = asked.centre + ring * step * d;
      if (image.inside(at) <= 0) continue;
      const Seed ball = ballAt(at);
      if (*ball.radius > *best.radius) best = ball;
    }
  if (*best.radius < smallest) return std::nullopt;
  return best;
}

std::vector<Seed> fitSeeds(const ObjectImage& image, const std::vector<Seed>& seeds, double edgeLength,
                           bool beyond) {
  std::vector<Seed> fitted;
  for (const Seed& asked : seeds) {
    const Seed seed{roomiestNear(image, asked.centre, edgeLength), asked.radius};
    if (!seed.radius && comesAnyway(image, centresOf(fitted), seed.centre, edgeLength)) continue;
    double radius = seed.radius && beyond ? *seed.radius : radiusWithin(image, seed, edgeLength);
    radius = std::max(radius, kSmallestSeed * edgeLength);
    for (const Seed& other : fitted)
      radius = std::min(radius, (seed.centre - other.centre).norm() - *other.radius - edgeLength);
    if (fitted.empty() || radius >= kSmallestSeed * edgeLength) fitted.push_back({seed.centre, radius});
  }
  return fitted;
}

TriangleSoup seedSphere(const Seed& seed, double edgeLength) {
  return icosphere(seed.centre, *seed.radius, 1.2 * edgeLength);
}

Mesh seedMesh(const std::vector<Seed>& seeds, double edgeLength, const SizeField* sizes) {
  requireManageable(seeds, edgeLength);
  TriangleSoup all;
  for (const Seed& s : seeds) {
    const double round = kRound * *s.radius / edgeLength;
    const double size = sizes ? std::clamp(round, 1.0, sizes->leastOn(s.centre, *s.radius)) : 1;
    const TriangleSoup sphere = seedSphere(s, size * edgeLength);
    const int shift = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), sphere.points.begin(), sphere.points.end());
    for (Triangle t : sphere.triangles) {
      for (int& v : t) v += shift;
      all.triangles.push_back(t);
    }
  }
  return Mesh(all);
}

}  // namespace handlebody
