#include "core/solid/label_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/collision/certify.h"
#include "core/collision/closest_point.h"
#include "core/mesh/topology.h"
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
constexpr double kMostOffset = 0.3;                // of the smallest spacing, to keep the volume
constexpr std::size_t kChunk = 1024;

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

TriangleSoup onGrid(TriangleSoup mesh, const Grid& grid) {
  for (Vec3& p : mesh.points) p = grid.toIndex(p);
  return mesh;
}

//! Midway between two voxels.
bool isCrossing(const Vec3& index) {
  int halves = 0;
  for (int a = 0; a < 3; ++a) {
    const double twice = 2 * index[a], whole = std::round(twice);
    if (std::abs(twice - whole) > 1e-6) return false;
    halves += static_cast<long>(whole) % 2 != 0;
  }
  return halves == 1;
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

  //! From `p` towards what lies `offset` mm outside of it; `hint` as ClosestPoint. Never farther than
  //! kMostMove from the voxels' surface.
  Vec3 towards(const Vec3& from, const Vec3& p, double offset, int& hint) const {
    const Vec3 start = grid_.toIndex(from);
    Vec3 index = grid_.toIndex(p);
    if (hint < 0) nearest_.distance(index, &hint);
    const Triangle& t = inVoxels_.triangles[idx(hint)];
    const double level = (levels_[idx(t[0])] + levels_[idx(t[1])] + levels_[idx(t[2])]) / 3;
    index += step(index, level);
    index += step(index, level);
    index += outwards(index, offset);
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

  //! Only where an edge of the grid crosses the surface is its place known without bias: what fills corners
  //! begins with the mean of its neighbours.
  double firstLevel(const Mesh& mesh, int v) const {
    if (isCrossing(inVoxels_.points[idx(v)])) return blurred_.at(inVoxels_.points[idx(v)]);
    double sum = 0;
    int n = 0;
    mesh.forEachNeighbour(v, [&](int w) {
      sum += blurred_.at(inVoxels_.points[idx(w)]);
      ++n;
    });
    return sum / n;
  }

  //! A way of `offset` mm, in voxels.
  Vec3 outwards(const Vec3& index, double offset) const {
    const Vec3 g = blurred_.gradient(index).cwiseQuotient(grid_.spacing);  // per mm
    const double length = g.norm();
    if (offset == 0 || !(length > 0)) return Vec3::Zero();
    return (-offset / length * g).cwiseQuotient(grid_.spacing);
  }

  std::vector<double> meanLevels(const Mesh& mesh) const {
    std::vector<double> level(inVoxels_.points.size()), next(level.size());
    for (std::size_t v = 0; v < level.size(); ++v) level[v] = firstLevel(mesh, static_cast<int>(v));
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

//! Per component of the surface between the voxels: the volume of the voxels that it encloses, mm³, negative
//! for a cavity. That is the sum over the sides of voxels across the first axis, each with its place along
//! it.
std::vector<double> voxelVolumes(const Mask& mask, const TriangleSoup& surface) {
  const Components parts = findComponents(Mesh(surface));
  std::vector<double> volumes(parts.vertices.size(), 0);
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    const Vec3 index = mask.grid.toIndex(surface.points[v]);
    const int x = static_cast<int>(std::floor(index.x())), y = static_cast<int>(std::lround(index.y())),
              z = static_cast<int>(std::lround(index.z()));
    const bool isAcross = isCrossing(index) && std::abs(index.x() - x - 0.5) < 0.25 &&
                          mask.holds(x, y, z) != mask.holds(x + 1, y, z);
    if (isAcross) volumes[idx(parts.ofVertex[v])] += (mask.holds(x, y, z) ? 1 : -1) * (x + 0.5);
  }
  for (double& volume : volumes) volume *= mask.grid.voxelVolume();
  return volumes;
}

//! How far outside of the smooth surface each component is to lie, mm, so that it keeps the volume of its
//! voxels.
class Offsets {
 public:
  Offsets(std::vector<double> wanted, double most)
      : wanted_(std::move(wanted)), offset_(wanted_.size(), 0), most_(most) {}
  double of(int component) const { return offset_[idx(component)]; }
  void update(const GuardedMesh& guarded) {
    const auto now = guarded.measures();
    for (std::size_t c = 0; c < now.size(); ++c)
      offset_[c] = std::clamp(offset_[c] + (wanted_[c] - now[c].volume) / now[c].area, -most_, most_);
  }

 private:
  std::vector<double> wanted_, offset_;
  double most_;
};

void moveOnce(GuardedMesh& guarded, const SmoothSurface& surface, const Offsets& offsets,
              std::vector<int>& hints, int threads) {
  const Mesh& mesh = guarded.mesh();
  std::vector<Vec3> targets(idx(mesh.vertexSlots()));
  hints.resize(targets.size(), -1);
  forEachOnThreads((targets.size() + kChunk - 1) / kChunk, threads, [&](std::size_t chunk) {
    const int end = static_cast<int>(std::min((chunk + 1) * kChunk, targets.size()));
    for (int v = static_cast<int>(chunk * kChunk); v < end; ++v)
      if (mesh.isVertex(v))
        targets[idx(v)] = surface.towards(mesh.position(v), evened(mesh, v), offsets.of(guarded.component(v)),
                                          hints[idx(v)]);
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

void smoothAndRegulate(GuardedMesh& guarded, const SmoothSurface& surface, Offsets& offsets, double edge,
                       int threads) {
  const RemeshLimits limits{kLongest * edge, kShortest * edge};
  std::vector<int> hints;
  for (int i = 0; i < kFirstMoves; ++i) moveOnce(guarded, surface, offsets, hints, threads);
  for (int i = 0; i < kRegulations; ++i) {
    offsets.update(guarded);
    guarded.regulate(limits);
    hints.assign(hints.size(), -1);  // vertices have other numbers
    for (int k = 0; k < kMovesBetween; ++k) moveOnce(guarded, surface, offsets, hints, threads);
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
  Offsets offsets(voxelVolumes(mask, result.mesh), kMostOffset * mask.grid.spacing.minCoeff());
  smoothAndRegulate(guarded, surface, offsets, edge, options.threads);
  result.mesh = guarded.mesh().compact();
  result.certificate = certify(result.mesh);
  if (!result.certificate.boundsBody() || !isSameTopology(result.certificate, counted))
    throw std::logic_error("the mesh of a label map has lost its topology");
  for (const Vec3& p : result.mesh.points) result.farthest = std::max(result.farthest, surface.distance(p));
  return result;
}

}  // namespace handlebody
