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
//! Voxels: how far a vertex may go between two looks at the edges. What is thin would draw back without end.
struct Reach {
  double along;  // the normal
  double any;    // in any direction
};
constexpr Reach kFirstReach{0.75, 0.8}, kLaterReach{0.15, 0.3};
constexpr double kSameWay = 0.3;     // cosine; steps of voxels are within 55° of the surface meant
constexpr double kMostOffset = 0.3;  // of the smallest spacing, to keep the volume
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

//! The place nearest to `index` along the normal, and then on the way from the anchor, that it may go to.
//! Voxels.
Vec3 withinReach(const Vec3& anchor, const Vec3& index, const Vec3& normal, const Reach& reach) {
  Vec3 way = index - anchor;
  const double along = way.dot(normal);
  way += (std::clamp(along, -reach.along, reach.along) - along) * normal;
  const double length = way.norm();
  return anchor + (length > reach.any ? reach.any / length : 1.0) * way;
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

  //! Where a vertex is, and what it is to do.
  struct Place {
    Vec3 from, to;  //!< mm
    Vec3 normal;    //!< of the mesh, of any length
    double offset;  //!< mm, outside of the surface that is meant
    Vec3 anchor;    //!< mm
    Reach reach;    //!< from there
  };

  //! From `to` towards the surface. Never farther than kMostMove from the voxels' surface, and only to where
  //! that faces the same way: else what is as thin as a voxel would draw back along itself.
  Vec3 towards(const Place& place, int& hint) const {
    const Vec3 start = grid_.toIndex(place.from);
    Vec3 index = grid_.toIndex(place.to);
    if (hint < 0) nearest_.distance(index, &hint);
    const Triangle& t = inVoxels_.triangles[idx(hint)];
    const double level = (levels_[idx(t[0])] + levels_[idx(t[1])] + levels_[idx(t[2])]) / 3;
    index += step(index, level);
    index += step(index, level);
    index += outwards(index, place.offset);
    const Vec3 normal = normalInVoxels(place.normal);
    index = withinReach(grid_.toIndex(place.anchor), index, normal, place.reach);
    for (int i = 0; i < 4; ++i, index = (index + start) / 2)
      if (nearest_.distance(index, &hint) <= kMostMove && facesLike(normal, hint))
        return grid_.toWorld(index);
    return place.from;
  }
  //! From the voxels' surface, in voxels.
  double distance(const Vec3& p) const { return nearest_.distance(grid_.toIndex(p)); }

 private:
  //! Normals go the other way than points: a plane stays a plane.
  Vec3 normalInVoxels(const Vec3& normal) const {
    const double turned = grid_.direction.determinant() < 0 ? -1 : 1;
    return (turned * (grid_.direction.transpose() * normal).cwiseProduct(grid_.spacing)).normalized();
  }
  bool facesLike(const Vec3& normal, int triangle) const {
    const Triangle& t = inVoxels_.triangles[idx(triangle)];
    const Vec3& a = inVoxels_.points[idx(t[0])];
    const Vec3 there = (inVoxels_.points[idx(t[1])] - a).cross(inVoxels_.points[idx(t[2])] - a);
    return normal.dot(there) > kSameWay * there.norm();
  }

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

//! To the mean of the neighbours, as far as it lies in the tangent plane.
SmoothSurface::Place evened(const Mesh& mesh, int v) {
  Vec3 mean = Vec3::Zero(), normal = Vec3::Zero();
  int n = 0;
  mesh.forEachOutgoing(v, [&](int h) {
    mean += mesh.position(mesh.target(h));
    normal += mesh.areaVector(Mesh::faceOf(h));
    ++n;
  });
  const Vec3& p = mesh.position(v);
  const double squared = normal.squaredNorm();
  if (n == 0 || !(squared > 0)) return {p, p, normal, 0, p, {}};
  const Vec3 shift = mean / n - p;
  return {p, p + kTangential * (shift - shift.dot(normal) / squared * normal), normal, 0, p, {}};
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

//! Moves all vertices towards the surface that is meant.
class Moves {
 public:
  Moves(GuardedMesh& guarded, const SmoothSurface& surface, const Offsets& offsets, int threads)
      : guarded_(guarded), surface_(surface), offsets_(offsets), threads_(threads) {}

  //! None goes farther than `reach` from where it is now.
  void make(int count, const Reach& reach) {
    anchors_.assign(guarded_.mesh().positions().begin(), guarded_.mesh().positions().end());
    hints_.assign(anchors_.size(), -1);
    for (int i = 0; i < count; ++i) make(reach);
  }

 private:
  void make(const Reach& reach) {
    const Mesh& mesh = guarded_.mesh();
    std::vector<Vec3> targets(anchors_.size());
    forEachOnThreads((targets.size() + kChunk - 1) / kChunk, threads_, [&](std::size_t chunk) {
      const int end = static_cast<int>(std::min((chunk + 1) * kChunk, targets.size()));
      for (int v = static_cast<int>(chunk * kChunk); v < end; ++v) {
        if (!mesh.isVertex(v)) continue;
        SmoothSurface::Place place = evened(mesh, v);
        place.offset = offsets_.of(guarded_.component(v));
        place.anchor = anchors_[idx(v)];
        place.reach = reach;
        targets[idx(v)] = surface_.towards(place, hints_[idx(v)]);
      }
    });
    guarded_.move(targets);
  }

  GuardedMesh& guarded_;
  const SmoothSurface& surface_;
  const Offsets& offsets_;
  int threads_;
  std::vector<Vec3> anchors_;
  std::vector<int> hints_;
};

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
  Moves moves(guarded, surface, offsets, threads);
  moves.make(kFirstMoves, kFirstReach);
  for (int i = 0; i < kRegulations; ++i) {
    offsets.update(guarded);
    guarded.regulate(limits, [&](const Vec3& p) { return surface.distance(p) <= kMostApart; });
    moves.make(kMovesBetween, kLaterReach);
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
