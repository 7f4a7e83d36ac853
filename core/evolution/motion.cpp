#include "core/evolution/motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/evolution/normal_profile.h"
#include "core/threads.h"

namespace handlebody {

namespace {

// Part of the tangential umbrella vector that a moving vertex follows; converged ones do not slide.
constexpr double kTangential = 0.4;
// Below this many vertices a thread costs more than it saves.
constexpr std::size_t kVerticesPerThread = 500;

constexpr std::size_t kTogether = 16;  // vertices

// Bound of the correction for flat faces on a curved boundary, in edge lengths.
constexpr double kLargestSagitta = 0.1;

//! What is known of a vertex's motion before the image is asked.
struct Attempt {
  Vec3 normal;
  Vec3 tangential;
  Vec3 from;     // where the image is asked
  double force;  // along the normal, in parts of the largest step
  double size;   // of the edges here, in parts of the target
  bool isDeep;   // the object goes on farther than any step
};

Attempt attemptOf(const Mesh& mesh, const MotionSettings& s, RingHeights& heights, int v) {
  const Ring ring = examineRing(mesh, v);
  const double height = ring.height();
  heights.set(v, height);
  const double most = s.sizes ? s.sizes->at(mesh.position(v)) : 1;
  // The step follows the edges as they are: a front that has just come into a wide inside, or a small seed,
  // is still fine.
  const double size = most > 1 ? std::clamp(std::sqrt(ring.meanSquare) / s.edgeLength, 1.0, most) : 1;
  const double edge = size * s.edgeLength;
  // Mean curvature from the umbrella: a ring at distance h on a sphere of radius r lies h²/(2r) below its
  // middle.
  const double curvature = ring.meanSquare > 0 ? -2 * height / ring.meanSquare : 0.0;
  // Not in proportion to longer edges, which would hold a front back that is as round as they allow: far from
  // every boundary there is nothing to smooth but the front itself.
  const double force = s.balloon - s.curvature * s.edgeLength * curvature;
  // On a curved boundary the flat faces lie inside of their corners. The image is asked where the faces lie
  // on the mean, a quarter of the ring's height below the vertex (mean sagitta of a triangle: e²/8r, of the
  // ring: e²/2r), so that surface and volume come out right, not the corners alone.
  const double limit = kLargestSagitta * edge;
  return {ring.normal,
          ring.umbrella - height * ring.normal,
          mesh.position(v) + std::clamp(0.25 * height, -limit, limit) * ring.normal,
          std::clamp(force / s.balloon, s.outwardOnly ? 0.0 : -1.0, 1.0),
          size,
          most > 1};
}

//! Signed distance along the normal.
double normalStep(NormalProfile& profile, double force, double reach) {
  const double here = profile.at(0);
  if (here < 0) {
    const double there = profile.at(-reach);
    return there <= 0 ? -reach : profile.crossing(-reach, here, there);
  }
  if (force <= 0) return force * reach;
  const double there = profile.at(reach);
  const double room = there >= 0 ? reach : profile.crossing(reach, here, there);
  return std::min(force * reach, room);
}

Vec3 displacement(NormalProfile profile, const Attempt& a, const MotionSettings& s) {
  const double reach = a.size * s.largestStep;
  const double along = a.isDeep ? a.force * reach : normalStep(profile, a.force, reach);
  const double moving = std::min(1.0, 4 * std::abs(along) / reach);
  return along * a.normal + kTangential * moving * a.tangential;
}

//! Some vertices at a time: while the rings of the others are looked at, the image arrives from memory.
void computeSome(const Mesh& mesh, const ObjectImage& image, const MotionSettings& s, RingHeights& heights,
                 std::span<const int> vertices, std::span<Vec3> moves) {
  std::array<Attempt, kTogether> attempts;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    attempts[i] = attemptOf(mesh, s, heights, vertices[i]);
    if (attempts[i].isDeep) continue;
    image.prefetch(attempts[i].from);
    image.prefetch(attempts[i].from + s.largestStep * attempts[i].normal);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Attempt& a = attempts[i];
    moves[i] = displacement({image, mesh, heights, vertices[i], a.from, a.normal, s.edgeLength}, a, s);
  }
}

}  // namespace

std::vector<Vec3> computeMotion(const Mesh& mesh, const ObjectImage& image, const MotionSettings& settings,
                                std::span<const int> vertices) {
  std::vector<Vec3> moves(vertices.size());
  RingHeights heights(mesh);
  const auto work = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; i += kTogether) {
      const std::size_t some = std::min(kTogether, to - i);
      computeSome(mesh, image, settings, heights, vertices.subspan(i, some),
                  std::span(moves).subspan(i, some));
    }
  };
  forRangesOnThreads(vertices.size(), settings.threads, kVerticesPerThread, work);
  return moves;
}

}  // namespace handlebody
