#include "core/evolution/motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

namespace handlebody {

namespace {

// Part of the tangential umbrella vector that a moving vertex follows; settled ones do not slide.
constexpr double kTangential = 0.4;
// Below this many vertices a thread costs more than it saves.
constexpr std::size_t kVerticesPerThread = 500;

constexpr std::size_t kTogether = 16;  // vertices

// Bound of the correction for flat faces on a curved boundary, in edge lengths.
constexpr double kLargestSagitta = 0.1;

struct Ring {
  Vec3 normal{0, 0, 0};
  Vec3 umbrella{0, 0, 0};  // mean of the neighbours less the vertex
  double meanSquare = 0;   // of the distances to the neighbours
};

Ring examineRing(const Mesh& mesh, int v) {
  Ring r;
  const Vec3 p = mesh.position(v);
  double n = 0;
  // On a closed mesh the ring goes on where a face ends.
  Vec3 a = mesh.position(mesh.target(mesh.outgoing(v))) - p;
  mesh.forEachOutgoing(v, [&](int h) {
    const Vec3 b = mesh.position(mesh.apex(h)) - p;
    r.normal += a.cross(b);
    r.umbrella += a;
    r.meanSquare += a.squaredNorm();
    n += 1;
    a = b;
  });
  const double length = r.normal.norm();
  if (length > 0) r.normal /= length;
  r.umbrella /= n;
  r.meanSquare /= n;
  return r;
}

//! Distance along `direction` from p to the zero of image.inside, where it is `here` at p and `there` at
//! `reach`, of opposite signs: one step of regula falsi, improved once.
double crossing(const ObjectImage& image, const Vec3& p, const Vec3& direction, double reach, double here,
                double there) {
  const double t = reach * here / (here - there);
  const double value = image.inside(p + t * direction);
  if (value * here > 0) return t + (reach - t) * value / (value - there);
  return here == value ? t : t * here / (here - value);
}

//! What is known of a vertex's motion before the image is asked.
struct Attempt {
  Vec3 normal;
  Vec3 tangential;
  Vec3 from;     // where the image is asked
  double force;  // along the normal, in parts of the largest step
};

Attempt attemptOf(const Mesh& mesh, const MotionSettings& s, int v) {
  const Ring ring = examineRing(mesh, v);
  const double height = ring.normal.dot(ring.umbrella);
  // Mean curvature from the umbrella: a ring at distance h on a sphere of radius r lies h²/(2r) below its
  // middle.
  const double curvature = ring.meanSquare > 0 ? -2 * height / ring.meanSquare : 0.0;
  const double force = s.balloon - s.curvature * s.edgeLength * curvature;
  // On a curved boundary the flat faces lie inside of their corners. The image is asked where the faces lie
  // on the mean, a quarter of the ring's height below the vertex (mean sagitta of a triangle: e²/8r, of the
  // ring: e²/2r), so that surface and volume come out right, not the corners alone.
  const double limit = kLargestSagitta * s.edgeLength;
  return {ring.normal, ring.umbrella - height * ring.normal,
          mesh.position(v) + std::clamp(0.25 * height, -limit, limit) * ring.normal,
          std::clamp(force / s.balloon, s.outwardOnly ? 0.0 : -1.0, 1.0)};
}

//! Signed distance along the normal.
double normalStep(const ObjectImage& image, const Attempt& a, const MotionSettings& s) {
  const double reach = s.largestStep;
  const double here = image.inside(a.from);
  if (here < 0) {
    const double there = image.inside(a.from - reach * a.normal);
    return there <= 0 ? -reach : -crossing(image, a.from, -a.normal, reach, here, there);
  }
  if (a.force <= 0) return a.force * reach;
  const double there = image.inside(a.from + reach * a.normal);
  const double room = there >= 0 ? reach : crossing(image, a.from, a.normal, reach, here, there);
  return std::min(a.force * reach, room);
}

Vec3 displacement(const ObjectImage& image, const Attempt& a, const MotionSettings& s) {
  const double along = normalStep(image, a, s);
  const double moving = std::min(1.0, 4 * std::abs(along) / s.largestStep);
  return along * a.normal + kTangential * moving * a.tangential;
}

//! Some vertices at a time: while the rings of the others are looked at, the image arrives from memory.
void computeSome(const Mesh& mesh, const ObjectImage& image, const MotionSettings& s,
                 std::span<const int> vertices, std::span<Vec3> moves) {
  std::array<Attempt, kTogether> attempts;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    attempts[i] = attemptOf(mesh, s, vertices[i]);
    image.prefetch(attempts[i].from);
    image.prefetch(attempts[i].from + s.largestStep * attempts[i].normal);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) moves[i] = displacement(image, attempts[i], s);
}

}  // namespace

std::vector<Vec3> computeMotion(const Mesh& mesh, const ObjectImage& image, const MotionSettings& settings,
                                std::span<const int> vertices) {
  std::vector<Vec3> moves(vertices.size());
  const auto work = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; i += kTogether) {
      const std::size_t some = std::min(kTogether, to - i);
      computeSome(mesh, image, settings, vertices.subspan(i, some), std::span(moves).subspan(i, some));
    }
  };
  const std::size_t threads = std::clamp<std::size_t>(
      vertices.size() / kVerticesPerThread, 1, static_cast<std::size_t>(std::max(1, settings.threads)));
  std::vector<std::jthread> others;
  for (std::size_t t = 1; t < threads; ++t)
    others.emplace_back(work, t * vertices.size() / threads, (t + 1) * vertices.size() / threads);
  work(0, vertices.size() / threads);
  others.clear();
  return moves;
}

}  // namespace handlebody
