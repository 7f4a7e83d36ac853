#include "core/solid/label_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numeric>
#include <stdexcept>

#include "core/cancellation.h"
#include "core/collision/certify.h"
#include "core/collision/self_intersection.h"
#include "core/errors.h"
#include "core/indices.h"
#include "core/mesh/quality.h"
#include "core/mesh/topology.h"
#include "core/phase.h"
#include "core/solid/guarded_mesh.h"
#include "core/solid/mask_surface.h"
#include "core/solid/smooth_surface.h"
#include "core/threads.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

constexpr int kFirstMoves = 10;  // before the first look at the edges
constexpr int kRegulations = 5;
constexpr int kMovesBetween = 3;
constexpr double kTangential = 0.5;  // of the way to the neighbours' mean
constexpr double kMuchLonger = 2;    // than edges are: these are made longer in steps
constexpr double kStep = 1.4;        // from one edge length to the next
constexpr VertexReach kFirstReach{0.75, 0.8}, kLaterReach{0.15, 0.3};
constexpr double kMaxOffset = 0.3;        // of the smallest spacing, to keep the volume
constexpr double kMaxOffsetOfThin = 0.6;  // the same, where that has lost too much of it
constexpr double kMaxFine = 500'000;      // faces with edges as short as the smallest spacing
constexpr std::size_t kChunk = 1024;
// Objects that become meshes together, voxels: how far their surfaces, which coincide where they touch, are
// drawn back at first (where that is not enough, the next), and how far they keep from each other.
constexpr std::array kDrawnBack{0.05, 0.1, 0.2, 0.3};
constexpr double kKeptApart = 0.1;

//! To the mean of the neighbours, as far as it lies in the tangent plane.
SmoothSurface::VertexAim evened(const Mesh& mesh, int v) {
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
    if (isAcross) volumes[parts.ofVertex[v]] += (mask.holds(x, y, z) ? 1 : -1) * (x + 0.5);
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
  double of(int component) const { return offset_[component]; }
  void update(const GuardedMesh& guarded) {
    const auto now = guarded.measures();
    for (std::size_t c = 0; c < now.size(); ++c)
      offset_[c] = std::clamp(offset_[c] + (wanted_[c] - now[c].volume) / now[c].area, -most_, most_);
  }

 private:
  std::vector<double> wanted_, offset_;
  double most_;
};

//! Voxels of an object that have one of another object beside them, or are one.
class Crowd {
 public:
  Crowd(const std::vector<Mask>& masks, std::size_t which) : grid_(masks[which].grid) {
    if (masks.size() < 2) return;
    beside_.assign(masks[which].inside.size(), 0);
    for (std::size_t other = 0; other < masks.size(); ++other)
      if (other != which) add(masks[other]);
  }
  bool isBeside(const Vec3& world) const {
    if (beside_.empty()) return false;
    const Vec3 index = grid_.toIndex(world);
    std::array<int, 3> at{};
    for (int a = 0; a < 3; ++a)
      at[a] = std::clamp(static_cast<int>(std::lround(index[a])), 0, grid_.size[a] - 1);
    return beside_[place(at[0], at[1], at[2])] != 0;
  }

 private:
  std::size_t place(int x, int y, int z) const {
    return (idx(z) * idx(grid_.size[1]) + idx(y)) * idx(grid_.size[0]) + idx(x);
  }
  void add(const Mask& other) {
    const Vec3 shift = other.grid.toIndex(grid_.toWorld(Vec3::Zero()));  // both are cut from one grid
    const int dx = static_cast<int>(std::lround(shift.x())), dy = static_cast<int>(std::lround(shift.y())),
              dz = static_cast<int>(std::lround(shift.z()));
    for (int z = 0; z < grid_.size[2]; ++z) {
      giveUpIfCancelled();
      for (int y = 0; y < grid_.size[1]; ++y)
        for (int x = 0; x < grid_.size[0]; ++x)
          if (beside_[place(x, y, z)] == 0 && anyAround(other, x + dx, y + dy, z + dz))
            beside_[place(x, y, z)] = 1;
    }
  }
  static bool anyAround(const Mask& mask, int x, int y, int z) {
    for (int k = z - 1; k <= z + 1; ++k)
      for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i)
          if (mask.holds(i, j, k)) return true;
    return false;
  }

  Grid grid_;
  std::vector<std::uint8_t> beside_;
};

//! What a component is to become.
struct Meant {
  const SmoothSurface* surface;
  const Crowd* crowd;
  double apart;  //!< mm, that it keeps from half of the gap to others
};

//! Moves all vertices towards the surface that is meant.
class Moves {
 public:
  //! `meant`: per component.
  Moves(GuardedMesh& guarded, const std::vector<Meant>& meant, const Offsets& offsets, int threads)
      : guarded_(guarded), meant_(meant), offsets_(offsets), threads_(threads) {}

  //! None goes farther than `reach` from where it is now.
  void make(int count, const VertexReach& reach) {
    anchors_.assign(guarded_.mesh().positions().begin(), guarded_.mesh().positions().end());
    hints_.assign(anchors_.size(), -1);
    for (int i = 0; i < count; ++i) make(reach);
  }

 private:
  void make(const VertexReach& reach) {
    giveUpIfCancelled();
    const Mesh& mesh = guarded_.mesh();
    std::vector<Vec3> targets(anchors_.size());
    forEachOnThreads((targets.size() + kChunk - 1) / kChunk, threads_, [&](std::size_t chunk) {
      const int end = static_cast<int>(std::min((chunk + 1) * kChunk, targets.size()));
      for (int v = static_cast<int>(chunk * kChunk); v < end; ++v) {
        if (!mesh.isVertex(v)) continue;
        SmoothSurface::VertexAim place = evened(mesh, v);
        const Meant& meant = meant_[guarded_.component(v)];
        place.offset = offsets_.of(guarded_.component(v));
        if (meant.crowd->isBeside(place.from)) place.offset -= meant.apart;
        place.anchor = anchors_[v];
        place.reach = reach;
        targets[v] = meant.surface->towards(place, hints_[v]);
      }
    });
    guarded_.move(targets);
  }

  GuardedMesh& guarded_;
  const std::vector<Meant>& meant_;
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

void append(TriangleSoup& all, const TriangleSoup& more) {
  const int first = static_cast<int>(all.points.size());
  all.points.insert(all.points.end(), more.points.begin(), more.points.end());
  for (const Triangle& t : more.triangles)
    all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

//! Objects whose surfaces become smooth together, in one mesh that does not intersect itself.
class Together {
 public:
  Together(const std::vector<Mask>& masks, const LabelMeshOptions& options, double maxOffset = kMaxOffset)
      : masks_(masks), options_(options), maxOffset_(maxOffset) {
    for (const Mask& mask : masks) {
      voxels_.push_back(maskSurface(mask));
      counted_.push_back(examine(Mesh(voxels_.back())));
    }
  }

  //! With steps and all, where they are not to be smooth.
  std::vector<LabelMesh> made() {
    if (options_.smoothing != 0 || masks_.size() > 1) return smoothed();
    LabelMesh one;
    one.mesh = voxels_[0];
    one.certificate = certify(one.mesh);
    return {std::move(one)};
  }

 private:
  std::vector<LabelMesh> smoothed();
  TriangleSoup apart() const;
  TriangleSoup drawnBack(std::size_t object, double voxels) const;
  void choose(const GuardedMesh& guarded);
  bool regulate(GuardedMesh& guarded, double edge) const;
  void approach(GuardedMesh& guarded, Moves& moves, double edge) const;
  void smoothAndRegulate(GuardedMesh& guarded, Offsets& offsets) const;
  LabelMesh taken(const GuardedMesh& guarded, std::size_t object) const;
  double distance(const Vec3& p) const;

  const std::vector<Mask>& masks_;
  const LabelMeshOptions& options_;
  double maxOffset_;                  // of the smallest spacing
  std::vector<TriangleSoup> voxels_;  // surfaces between the voxels, which may coincide
  std::vector<Certificate> counted_;
  std::deque<SmoothSurface> surfaces_;  // none is moved
  std::vector<Crowd> crowds_;
  std::vector<std::size_t> objectOf_;  // per component
  std::vector<Meant> meant_;
  std::vector<double> volumes_;
};

//! Towards the voxels that are inside; what fills corners goes with its neighbours.
TriangleSoup Together::drawnBack(std::size_t object, double voxels) const {
  const Mask& mask = masks_[object];
  TriangleSoup out = voxels_[object];
  std::vector<Vec3> shift(out.points.size(), Vec3::Zero());
  std::vector<char> isKnown(out.points.size(), 0);
  for (std::size_t v = 0; v < out.points.size(); ++v) {
    const Vec3 index = mask.grid.toIndex(out.points[v]);
    if (!isCrossing(index)) continue;
    isKnown[v] = 1;
    for (int a = 0; a < 3; ++a) {
      const double low = std::floor(index[a] + 0.25);
      if (std::abs(index[a] - low - 0.5) > 0.25) continue;
      std::array<int, 3> at{static_cast<int>(std::lround(index.x())),
                            static_cast<int>(std::lround(index.y())),
                            static_cast<int>(std::lround(index.z()))};
      at[a] = static_cast<int>(low);
      shift[v][a] = mask.holds(at[0], at[1], at[2]) ? -voxels : voxels;
    }
  }
  const Mesh mesh(out);
  for (std::size_t v = 0; v < shift.size(); ++v) {
    if (isKnown[v] != 0) continue;
    int n = 0;
    mesh.forEachNeighbour(static_cast<int>(v), [&](int w) {
      if (isKnown[w] == 0) return;
      shift[v] += shift[w];
      ++n;
    });
    if (n > 0) shift[v] /= n;
  }
  for (std::size_t v = 0; v < shift.size(); ++v)
    out.points[v] = mask.grid.toWorld(mask.grid.toIndex(out.points[v]) + shift[v]);
  return out;
}

//! All of them in one mesh. Those that touch are drawn back until no two meet.
TriangleSoup Together::apart() const {
  if (masks_.size() == 1) return voxels_[0];
  for (const double voxels : kDrawnBack) {
    TriangleSoup all;
    for (std::size_t i = 0; i < masks_.size(); ++i) append(all, drawnBack(i, voxels));
    if (findSelfIntersections(all.points, all.triangles).empty()) return all;
  }
  throw Told<InputError>(Finding(FindingKind::labelsTooFine));
}

//! What the components of the mesh, in which the objects lie one behind the other, are to become.
void Together::choose(const GuardedMesh& guarded) {
  const auto count = guarded.measures().size();
  objectOf_.assign(count, 0);
  volumes_.assign(count, 0);
  std::size_t first = 0;
  for (std::size_t i = 0; i < masks_.size(); ++i) {
    const std::vector<double> volumes = voxelVolumes(masks_[i], voxels_[i]);
    const Components parts = findComponents(Mesh(voxels_[i]));
    for (std::size_t v = 0; v < voxels_[i].points.size(); ++v) {
      const auto c = idx(guarded.component(static_cast<int>(first + v)));
      objectOf_[c] = i;
      volumes_[c] = volumes[parts.ofVertex[v]];
    }
    first += voxels_[i].points.size();
  }
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t i = objectOf_[c];
    meant_.push_back({&surfaces_[i], &crowds_[i], kKeptApart * masks_[i].grid.spacing.minCoeff()});
  }
}

//! Voxels, from the nearest surface between voxels that is near enough, or from the last one.
double Together::distance(const Vec3& p) const {
  double nearest = 0;
  for (const SmoothSurface& surface : surfaces_)
    if ((nearest = surface.distance(p)) <= kMaxApart) break;
  return nearest;
}

bool Together::regulate(GuardedMesh& guarded, double edge) const {
  const Phase phase("regulating");
  return guarded.regulate({kLongestWanted * edge, kShortestWanted * edge},
                          [&](const Vec3& p) { return distance(p) <= kMaxApart; });
}

//! Edges that become much longer at once take vertices off the surface, to which moves bring them back.
void Together::approach(GuardedMesh& guarded, Moves& moves, double edge) const {
  double step = meshQuality(guarded.mesh().compact()).edges.median;
  if (options_.edgeLength > 0 && edge > kMuchLonger * step)
    for (step *= kStep; step < edge; step *= kStep) {
      regulate(guarded, step);
      moves.make(kMovesBetween, kLaterReach);
    }
  regulate(guarded, edge);
}

void Together::smoothAndRegulate(GuardedMesh& guarded, Offsets& offsets) const {
  const double edge = options_.edgeLength > 0 ? options_.edgeLength : masks_[0].grid.meanSpacing();
  Moves moves(guarded, meant_, offsets, options_.threads);
  moves.make(kFirstMoves, kFirstReach);
  for (int i = 0; i < kRegulations; ++i) {
    offsets.update(guarded);
    approach(guarded, moves, edge);
    moves.make(kMovesBetween, kLaterReach);
  }
}

LabelMesh Together::taken(const GuardedMesh& guarded, std::size_t object) const {
  LabelMesh result;
  const TriangleSoup all = guarded.mesh().compact();
  std::vector<int> number(all.points.size(), -1);
  for (const Triangle& t : all.triangles) {
    if (objectOf_[guarded.component(t[0])] != object) continue;
    Triangle mine = t;
    for (int& v : mine) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(result.mesh.points.size());
        result.mesh.points.push_back(all.points[v]);
      }
      v = number[v];
    }
    result.mesh.triangles.push_back(mine);
  }
  if (masks_.size() == 1) result.mesh = all;
  result.certificate = certify(result.mesh);
  if (!result.certificate.boundsBody() || !isSameTopology(result.certificate, counted_[object]))
    throw std::logic_error("the mesh of a label map has lost its topology");
  for (const Vec3& p : result.mesh.points)
    result.farthest = std::max(result.farthest, surfaces_[object].distance(p));
  return result;
}

std::vector<LabelMesh> Together::smoothed() {
  const Phase phase("smoothing");
  for (std::size_t i = 0; i < masks_.size(); ++i) {
    const Vec3 sigma = options_.smoothing < 0
                           ? Vec3::Ones()
                           : Vec3(Vec3::Constant(options_.smoothing).cwiseQuotient(masks_[i].grid.spacing));
    surfaces_.emplace_back(masks_[i], voxels_[i], sigma);
    crowds_.emplace_back(masks_, i);
  }
  GuardedMesh guarded{Mesh(apart())};
  choose(guarded);
  Offsets offsets(volumes_, maxOffset_ * masks_[0].grid.spacing.minCoeff());
  if (options_.smoothing != 0) smoothAndRegulate(guarded, offsets);
  std::vector<LabelMesh> meshes;
  for (std::size_t i = 0; i < masks_.size(); ++i) meshes.push_back(taken(guarded, i));
  return meshes;
}

}  // namespace

//! What is few voxels wide along its narrow sides may be no wider than edges of the mean spacing are long,
//! and loses its volume to them.
LabelMesh meshOf(const Mask& mask, const LabelMeshOptions& options) {
  const std::vector<Mask> one{mask};
  LabelMesh made = std::move(Together(one, options).made()[0]);
  const double meant = static_cast<double>(mask.count()) * mask.grid.voxelVolume();
  const auto lost = [&](const LabelMesh& mesh) { return std::abs(mesh.certificate.volume - meant); };
  if (options.smoothing == 0 || options.edgeLength > 0 || lost(made) <= kMuchVolume * meant) return made;
  LabelMeshOptions fine = options;
  fine.edgeLength = mask.grid.spacing.minCoeff();
  const double shorter = mask.grid.meanSpacing() / fine.edgeLength;
  if (static_cast<double>(made.mesh.triangles.size()) * shorter * shorter > kMaxFine) return made;
  LabelMesh finer = std::move(Together(one, fine, kMaxOffsetOfThin).made()[0]);
  return lost(finer) < lost(made) ? std::move(finer) : std::move(made);
}

std::vector<LabelMesh> meshesOf(const std::vector<Mask>& masks, const LabelMeshOptions& options) {
  if (masks.empty()) return {};
  if (masks.size() == 1) return {meshOf(masks[0], options)};
  return Together(masks, options).made();
}

}  // namespace handlebody
