#include "core/solid/label_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/collision/certify.h"
#include "core/collision/closest_point.h"
#include "core/solid/blurred_mask.h"
#include "core/solid/guarded_mesh.h"
#include "core/solid/mask_surface.h"
#include "core/threads.h"

namespace handlebody {

namespace {

constexpr int kLevelPasses = 20;  // of the mean over neighbours: a radius of some three voxels
constexpr int kFirstMoves = 10;   // before the first look at the edges
constexpr int kRegulations = 5;
constexpr int kMovesBetween = 3;
constexpr double kTangential = 0.5;                // of the way to the neighbours' mean
constexpr double kLongestStep = 0.25;              // voxels, towards the level
constexpr double kLongest = 1.5, kShortest = 0.6;  // of the edge length that is wanted
constexpr std::size_t kChunk = 1024;

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

TriangleSoup onGrid(TriangleSoup mesh, const Grid& grid) {
  for (Vec3& p : mesh.points) p = grid.toIndex(p);
  return mesh;
}

//! The smooth surface that is meant: where the blurred mask has the mean value that it has around there on
//! the surface between the voxels. Half way on a plane; on what is thin or curved, another one, so that it
//! keeps its size.
class SmoothSurface {
 public:
  SmoothSurface(const Mask& mask, const TriangleSoup& surface, const Vec3& sigma)
      : grid_(mask.grid),
        blurred_(mask, sigma),
        inVoxels_(onGrid(surface, mask.grid)),
        nearest_(inVoxels_),
        levels_(meanLevels(Mesh(surface))) {}

  //! From `p` towards it; `hint` as ClosestPoint. Never farther than kMostMove from the voxels' surface.
  Vec3 towards(const Vec3& from, const Vec3& p, int& hint) const {
    const Vec3 start = grid_.toIndex(from);
    Vec3 index = grid_.toIndex(p);
    if (hint < 0) nearest_.distance(index, &hint);
    const Triangle& t = inVoxels_.triangles[idx(hint)];
    const double level = (levels_[idx(t[0])] + levels_[idx(t[1])] + levels_[idx(t[2])]) / 3;
    index += step(index, level);
    index += step(index, level);
    for (int i = 0; i < 4; ++i, index = (index + start) / 2)
      if (nearest_.distance(index, &hint) <= kMostMove) return grid_.toWorld(index);
    return from;
  }
  double distance(const Vec3& p) const { return nearest_.distance(grid_.toIndex(p)); }

 private:
  Vec3 step(const Vec3& index, double level) const {
    const Vec3 g = blurred_.gradient(index);
    const double squared = g.squaredNorm();
    if (squared < 1e-6) return Vec3::Zero();
    const Vec3 s = (level - blurred_.at(index)) / squared * g;
    const double length = s.norm();
    return length > kLongestStep ? s * (kLongestStep / length) : s;
  }

  std::vector<double> meanLevels(const Mesh& mesh) const {
    std::vector<double> level(inVoxels_.points.size()), next(level.size());
    for (std::size_t v = 0; v < level.size(); ++v) level[v] = blurred_.at(inVoxels_.points[v]);
    for (int pass = 0; pass < kLevelPasses; ++pass) {
      for (int v = 0; v < mesh.vertexSlots(); ++v) {
        double sum = level[idx(v)];
        int n = 1;
        mesh.forEachNeighbour(v, [&](int w) {
          sum += level[idx(w)];
          ++n;
        });
        next[idx(v)] = sum / n;
      }
      level.swap(next);
    }
    return level;
  }

  Grid grid_;
  BlurredMask blurred_;
  TriangleSoup inVoxels_;
  ClosestPoint nearest_;
  std::vector<double> levels_;
};

//! The mean of the neighbours, as far as it lies in the tangent plane.
Vec3 evened(const Mesh& mesh, int v) {
  Vec3 mean = Vec3::Zero(), normal = Vec3::Zero();
  int n = 0;
  mesh.forEachOutgoing(v, [&](int h) {
    mean += mesh.position(mesh.target(h));
    normal += mesh.areaVector(Mesh::faceOf(h));
    ++n;
  });
  const Vec3& p = mesh.position(v);
  const double length = normal.norm();
  if (n == 0 || !(length > 0)) return p;
  normal /= length;
  const Vec3 shift = mean / n - p;
  return p + kTangential * (shift - shift.dot(normal) * normal);
}

void moveOnce(GuardedMesh& guarded, const SmoothSurface& surface, std::vector<int>& hints, int threads) {
  const Mesh& mesh = guarded.mesh();
  std::vector<Vec3> targets(idx(mesh.vertexSlots()));
  hints.resize(targets.size(), -1);
  forEachOnThreads((targets.size() + kChunk - 1) / kChunk, threads, [&](std::size_t chunk) {
    const int end = static_cast<int>(std::min((chunk + 1) * kChunk, targets.size()));
    for (int v = static_cast<int>(chunk * kChunk); v < end; ++v)
      if (mesh.isVertex(v))
        targets[idx(v)] = surface.towards(mesh.position(v), evened(mesh, v), hints[idx(v)]);
  });
  guarded.move(targets);
}

//! In the order of size, as the order of components may change.
std::vector<int> sortedGenus(const Certificate& c) {
  std::vector<int> genus = c.genus;
  std::sort(genus.begin(), genus.end());
  return genus;
}

bool isSameTopology(const Certificate& a, const Certificate& b) {
  return a.components == b.components && a.cavities == b.cavities && sortedGenus(a) == sortedGenus(b);
}

void smoothAndRegulate(GuardedMesh& guarded, const SmoothSurface& surface, double edge, int threads) {
  const RemeshLimits limits{kLongest * edge, kShortest * edge};
  std::vector<int> hints;
  for (int i = 0; i < kFirstMoves; ++i) moveOnce(guarded, surface, hints, threads);
  for (int i = 0; i < kRegulations; ++i) {
    guarded.regulate(limits);
    hints.assign(hints.size(), -1);  // vertices have other numbers
    for (int k = 0; k < kMovesBetween; ++k) moveOnce(guarded, surface, hints, threads);
  }
}

}  // namespace

LabelMesh meshOf(const Mask& mask, const LabelMeshOptions& options) {
  LabelMesh result;
  result.mesh = maskSurface(mask);
  if (options.smoothing == 0) {
    result.certificate = certify(result.mesh);
    return result;
  }
  const Vec3 sigma = options.smoothing < 0
                         ? Vec3::Ones()
                         : Vec3(Vec3::Constant(options.smoothing).cwiseQuotient(mask.grid.spacing));
  const double edge = options.edgeLength > 0 ? options.edgeLength : mask.grid.meanSpacing();
  const SmoothSurface surface(mask, result.mesh, sigma);
  const Certificate counted = examine(Mesh(result.mesh));
  GuardedMesh guarded{Mesh(result.mesh)};
  smoothAndRegulate(guarded, surface, edge, options.threads);
  result.mesh = guarded.mesh().compact();
  result.certificate = certify(result.mesh);
  if (!result.certificate.boundsBody() || !isSameTopology(result.certificate, counted))
    throw std::logic_error("the mesh of a label map has lost its topology");
  for (const Vec3& p : result.mesh.points) result.farthest = std::max(result.farthest, surface.distance(p));
  return result;
}

}  // namespace handlebody
