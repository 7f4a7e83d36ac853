#include "core/evolution/walls.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/triangle_distance.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kBrick = 4;        // voxels of mean size
constexpr double kMaxBricks = 256;  // along an axis
// What is left free between a wall and the faces, voxels of the finest axis: far above the rounding of
// coordinates, in single precision, too.
constexpr double kClearance = 0.01;
// No flip or collapse moves the surface by more than twice this part of the edge length (kFlatEnough).
constexpr double kHalfFlip = 0.2;
constexpr double kRest =
    0.05;  // voxels between where corners come to rest at the map's voxels or an object and its margin
constexpr double kSmallPart = 4;      // edge lengths: no step carries a front over anything larger
constexpr double kMinBulge = 0.08;    // voxels of mean size: that edges stand out of a surface that is smooth
constexpr double kMaxBulge = 0.3;     // voxels of mean size: what objects may lie apart is half of one
constexpr double kObjectCell = 2;     // voxels of mean size
constexpr double kNotMore = 0.999;    // of what is free: far above the rounding of single precision
constexpr double kLongestFace = 4.5;  // edge lengths: longer than any edge, three times the paper's bound

}  // namespace

Walls::Walls(const WallList& list, const Grid& grid, double edgeLength, double largestStep)
    : list_(list), grid_(grid), edgeLength_(edgeLength), largestStep_(largestStep) {
  const double finest = grid.spacing.minCoeff(), clearance = kClearance * finest;
  clearance_ = clearance;
  far_ = kFarVoxels * grid.meanSpacing();
  reach_ = kLongestFace * edgeLength;
  margin_ = std::max(clearance, kHalfFlip * edgeLength - 0.5 * finest);
  // A sheet of surface that keeps half of what it moves away from a point at all times cannot pass it.
  const double least = std::max(0.5 * largestStep, kHalfFlip * edgeLength);
  for (const WallBall& w : list_.balls) {
    const double guard = std::max(w.radius, least) + clearance;
    reaches_.push_back({guard, std::hypot(guard, kCircumradius * edgeLength)});
  }
  chooseBricks();
  fillBalls();
  discGuard_ = least + clearance;
  discRest_ = discGuard_ + kRest * grid_.meanSpacing();
  fillDiscs();
  fillMap();
  fillObjects();
}

void Walls::chooseBricks() {
  for (std::size_t a = 0; a < 3; ++a) {
    const double voxels = kBrick * grid_.meanSpacing() / grid_.spacing[static_cast<int>(a)];
    brickSize_[a] = static_cast<int>(std::ceil(std::max({voxels, 1.0, grid_.size[a] / kMaxBricks})));
    bricks_[a] = (grid_.size[a] + brickSize_[a] - 1) / brickSize_[a];
  }
  const std::size_t count = idx(bricks_[0]) * idx(bricks_[1]) * idx(bricks_[2]);
  const Vec3 bricksPerMm =
      (grid_.spacing.cwiseProduct(Vec3(brickSize_[0], brickSize_[1], brickSize_[2]))).cwiseInverse();
  toBricks_ = bricksPerMm.asDiagonal() * grid_.direction.transpose();
  brickOrigin_ =
      Vec3(0.5 / brickSize_[0], 0.5 / brickSize_[1], 0.5 / brickSize_[2]) - toBricks_ * grid_.origin;
  free_.assign(count, static_cast<float>(kNotMore * reach_));
  near_.assign(count, false);
  hasVoxels_.assign(count, false);
  first_.assign(count + 1, 0);
}

Walls::Index Walls::clampedBrick(const Vec3& bricks) const {
  Index b{};
  for (std::size_t a = 0; a < 3; ++a)
    b[a] = static_cast<int>(std::clamp(bricks[static_cast<int>(a)], 0.0, bricks_[a] - 1.0));
  return b;
}

Walls::Index Walls::brickOf(const Vec3& index) const {
  return clampedBrick(
      {(index[0] + 0.5) / brickSize_[0], (index[1] + 0.5) / brickSize_[1], (index[2] + 0.5) / brickSize_[2]});
}

Walls::Range Walls::bricksWithin(const Vec3& low, const Vec3& high, double mm) const {
  const Vec3 wide = mm * grid_.spacing.cwiseInverse();
  return {brickOf(low - wide), brickOf(high + wide)};
}

Walls::Range Walls::voxelsWithin(const Vec3& low, const Vec3& high, double mm) const {
  Range r{};
  for (std::size_t a = 0; a < 3; ++a) {
    const int i = static_cast<int>(a);
    const double wide = mm / grid_.spacing[i] + 0.5, last = grid_.size[a] - 1.0;
    r.low[a] = static_cast<int>(std::clamp(std::floor(low[i] - wide), 0.0, last));
    r.high[a] = static_cast<int>(std::clamp(std::ceil(high[i] + wide), 0.0, last));
  }
  return r;
}

namespace {

template <typename Range, typename F>
void forEach(const Range& r, F&& f) {
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y)
      for (int x = r.low[0]; x <= r.high[0]; ++x) f(std::array<int, 3>{x, y, z});
}

}  // namespace

//! Places outside of the bricks count as in the nearest one: no two of them come further apart by that, so
//! what holds from the ball's own nearest place holds for all. `ball`: continuous voxel index of its centre.
void Walls::limitFree(const Index& b, const Vec3& ball, double guard) {
  Vec3 away;
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const double size = brickSize_[a], low = b[a] * size - 0.5;
    const double centre = std::clamp(ball[axis], -0.5, bricks_[a] * size - 0.5);
    away[axis] = std::max({0.0, low - centre, centre - low - size}) * grid_.spacing[axis];
  }
  float& free = free_[brickAt(b)];
  free = std::min(free, static_cast<float>(kNotMore * std::max(0.0, away.norm() - guard)));
}

void Walls::fillBalls() {
  std::vector<std::vector<int>> held(first_.size() - 1);
  for (std::size_t i = 0; i < list_.balls.size(); ++i) {
    const Vec3 index = grid_.toIndex(list_.balls[i].centre);
    forEach(bricksWithin(index, index, reaches_[i].rest + far_),
            [&](const Index& b) { held[brickAt(b)].push_back(static_cast<int>(i)); });
    forEach(bricksWithin(index, index, reaches_[i].rest + reach_), [&](const Index& b) {
      near_[brickAt(b)] = true;
      limitFree(b, index, reaches_[i].guard);
    });
  }
  for (std::size_t b = 0; b < held.size(); ++b) {
    balls_.insert(balls_.end(), held[b].begin(), held[b].end());
    first_[b + 1] = static_cast<int>(balls_.size());
  }
}

//! Between corners on one side of a disc a face lies on that side, too: they may rest at the margin.
void Walls::fillDiscs() {
  nearDiscs_ = hasVoxels_;
  for (const WallDisc& d : list_.discs) {
    discs_.emplace_back(d);
    const Vec3 half = discs_.back().halfBox();
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const Vec3 index = grid_.toIndex(d.centre + sign.cwiseProduct(half));
      low = low.cwiseMin(index);
      high = high.cwiseMax(index);
    }
    forEach(bricksWithin(low, high, discRest_ + std::max(far_, reach_)), [&](const Index& b) {
      near_[brickAt(b)] = nearDiscs_[brickAt(b)] = true;
      free_[brickAt(b)] = 0;
    });
  }
}

void Walls::fillMap() {
  nearVoxels_ = hasVoxels_;
  if (!list_.map) return;
  const std::vector<bool>& wall = *list_.map->voxels;
  std::size_t i = 0;
  forEach(Range{{0, 0, 0}, {grid_.size[0] - 1, grid_.size[1] - 1, grid_.size[2] - 1}}, [&](const Index& v) {
    if (wall[i++])
      hasVoxels_[brickAt({v[0] / brickSize_[0], v[1] / brickSize_[1], v[2] / brickSize_[2]})] = true;
  });
  nearVoxels_ = hasVoxels_;
  dilate(nearVoxels_, margin_ + far_);
  std::vector<bool> around = hasVoxels_;
  dilate(around, margin_ + reach_);
  for (std::size_t b = 0; b < near_.size(); ++b) {
    near_[b] = near_[b] || around[b];
    if (around[b]) free_[b] = 0;
  }
}

void Walls::fillObjects() {
  if (list_.objects.empty()) return;
  objects_ = std::make_shared<const WallSurface>(list_.objects, kObjectCell * grid_.meanSpacing());
  hollowSizes_ = std::make_shared<const HollowSizes>(*objects_, edgeLength_, grid_.meanSpacing());
  for (const Triangle& t : objects_->triangles()) {
    const auto corner = [&](std::size_t i) { return grid_.toIndex(objects_->points()[t[i]]); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    forEach(bricksWithin(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), clearance_ + reach_),
            [&](const Index& i) {
              near_[brickAt(i)] = true;
              free_[brickAt(i)] = 0;
            });
  }
  forEach(Range{{0, 0, 0}, {bricks_[0] - 1, bricks_[1] - 1, bricks_[2] - 1}}, [&](const Index& b) {
    Vec3 middle;
    for (std::size_t a = 0; a < 3; ++a) middle[static_cast<int>(a)] = (b[a] + 0.5) * brickSize_[a] - 0.5;
    if (!objects_->encloses(grid_.toWorld(middle))) return;
    near_[brickAt(b)] = true;
    free_[brickAt(b)] = 0;
  });
  for (const WallSurface::Part& part : objects_->parts())
    if (part.extent < kSmallPart * edgeLength_) smallParts_.push_back(part.place);
}

//! To all bricks within so many mm, axis by axis.
void Walls::dilate(std::vector<bool>& flags, double mm) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const double brick = brickSize_[a] * grid_.spacing[static_cast<int>(a)];
    const int wide = static_cast<int>(std::ceil(mm / brick));
    const std::vector<bool> before = flags;
    forEach(Range{{0, 0, 0}, {bricks_[0] - 1, bricks_[1] - 1, bricks_[2] - 1}}, [&](const Index& b) {
      if (!before[brickAt(b)]) return;
      Index c = b;
      for (c[a] = std::max(0, b[a] - wide); c[a] <= std::min(bricks_[a] - 1, b[a] + wide); ++c[a])
        flags[brickAt(c)] = true;
    });
  }
}

bool Walls::isWall(const Index& v) const {
  const std::size_t row = idx(v[2]) * idx(grid_.size[1]) + idx(v[1]);
  return (*list_.map->voxels)[row * idx(grid_.size[0]) + idx(v[0])];
}

bool Walls::isNear(const Vec3& world) const { return near_[brickAt(clampedBrick(inBricks(world)))]; }

double Walls::room(const Vec3& world, const Vec3& index) const {
  const std::size_t brick = idx(brickAt(brickOf(index)));
  double room = far_;
  for (int i = first_[brick]; i < first_[brick + 1]; ++i) {
    const std::size_t ball = idx(balls_[i]);
    const double reach = room + reaches_[ball].rest;
    const double squared = (world - list_.balls[ball].centre).squaredNorm();
    if (squared < reach * reach) room = std::sqrt(squared) - reaches_[ball].rest;
  }
  if (nearDiscs_[brick])
    for (const DiscShape& disc : discs_) room = std::min(room, disc.distance(world) - discRest_);
  if (nearVoxels_[brick]) room = std::min(room, roomToVoxels(index));
  if (!objects_) return room;
  // Corners that are no nearer than what bulges between them stay out of each other's way: where some came
  // nearer, the faces at them would hold back the others.
  const double least = clearance_ + kRest * grid_.meanSpacing(), most = kMaxBulge * grid_.meanSpacing();
  const double across = hollowSizes_->at(world) * kCircumradius * edgeLength_;
  const WallSurface::Nearest nearest = objects_->nearest(world, far_ + least + most);
  const double bulge = std::clamp(nearest.bulge * across * across, kMinBulge * grid_.meanSpacing(), most);
  return std::min(room, nearest.distance - least - bulge);
}

double Walls::edgePart(const Vec3& world) const {
  return objects_ && isNear(world) ? hollowSizes_->at(world) : 1;
}

namespace {

//! mm from a voxel, the whole of it; 0 within.
double distanceToVoxel(const Grid& grid, const Vec3& index, const std::array<int, 3>& v) {
  Vec3 away;
  for (int a = 0; a < 3; ++a) away[a] = std::max(0.0, std::abs(index[a] - v[a]) - 0.5) * grid.spacing[a];
  return away.norm();
}

}  // namespace

double Walls::roomToVoxels(const Vec3& index) const {
  const double rest = margin_ + kRest * grid_.meanSpacing();
  double nearest = far_ + rest;
  forEach(voxelsWithin(index, index, nearest), [&](const Index& v) {
    if (isWall(v)) nearest = std::min(nearest, distanceToVoxel(grid_, index, v));
  });
  return nearest - rest;
}

double Walls::distance(const Vec3& world, double limit) const {
  double nearest = limit;
  for (const WallBall& w : list_.balls) nearest = std::min(nearest, (world - w.centre).norm() - w.radius);
  for (const DiscShape& disc : discs_) nearest = std::min(nearest, disc.distance(world));
  if (objects_) nearest = std::min(nearest, objects_->distance(world, limit));
  const Vec3 index = grid_.toIndex(world);
  if (list_.map)
    forEach(voxelsWithin(index, index, limit), [&](const Index& v) {
      if (isWall(v)) nearest = std::min(nearest, distanceToVoxel(grid_, index, v));
    });
  return nearest;
}

std::vector<Vec3> Walls::places(const Vec3& world, double within) const {
  std::vector<Vec3> out;
  for (const WallBall& w : list_.balls)
    if ((w.centre - world).squaredNorm() <= within * within) out.push_back(w.centre);
  for (const DiscShape& disc : discs_)
    if (disc.distance(world) <= within) out.push_back(disc.nearest(world));
  if (objects_)
    for (const Vec3& p : objects_->places(world, within)) out.push_back(p);
  if (!list_.map) return out;
  const Vec3 index = grid_.toIndex(world);
  std::vector<Index> left;  // in ascending order of z, y, x
  forEach(voxelsWithin(index, index, within), [&](const Index& v) {
    if (isWall(v)) left.push_back({v[2], v[1], v[0]});
  });
  while (!left.empty()) {
    std::vector<Index> piece{left.back()};
    out.push_back(grid_.toWorld(Vec3(piece[0][2], piece[0][1], piece[0][0])));
    left.pop_back();
    for (std::size_t at = 0; at < piece.size(); ++at) {
      const Index c = piece[at];
      const auto hangs = [&](const Index& v) {
        const bool beside =
            std::abs(v[0] - c[0]) < 2 && std::abs(v[1] - c[1]) < 2 && std::abs(v[2] - c[2]) < 2;
        if (beside) piece.push_back(v);
        return beside;
      };
      std::erase_if(left, hangs);
    }
  }
  return out;
}

bool Walls::meets(const Vec3& a, const Vec3& b, const Vec3& c, bool withMargin, Touched* which) const {
  const std::array<Vec3, 3> world{a, b, c};
  const double size = std::sqrt(std::max((b - a).squaredNorm(), (c - a).squaredNorm()));
  const Vec3 first = inBricks(a);
  if (size < static_cast<double>(free_[brickAt(clampedBrick(first))])) return false;
  const Vec3 second = inBricks(b), third = inBricks(c);
  const Range bricks{clampedBrick(first.cwiseMin(second).cwiseMin(third)),
                     clampedBrick(first.cwiseMax(second).cwiseMax(third))};
  const bool balls = meetsBalls(world, size, bricks, withMargin, which);
  if (balls && !which) return true;
  const bool discs = !discs_.empty() && meetsDiscs(world, withMargin, which);
  if (discs && !which) return true;
  const bool objects = objects_ && meetsObjects(world, withMargin, which);
  if (objects && !which) return true;
  bool voxels = false;
  if (list_.map) forEach(bricks, [&](const Index& v) { voxels = voxels || nearVoxels_[brickAt(v)]; });
  if (voxels) voxels = meetsVoxels({grid_.toIndex(a), grid_.toIndex(b), grid_.toIndex(c)}, withMargin, which);
  return voxels || balls || discs || objects;
}

bool Walls::meetsDiscs(const std::array<Vec3, 3>& t, bool withMargin, Touched* which) const {
  bool any = false;
  for (std::size_t i = 0; i < discs_.size() && (which || !any); ++i) {
    if (withMargin ? discs_[i].clears(t, discGuard_) : !discs_[i].meets(t)) continue;
    any = true;
    if (which) which->discs.push_back(static_cast<int>(i));
  }
  return any;
}

//! A triangle that meets no surface lies wholly inside or outside.
bool Walls::meetsObjects(const std::array<Vec3, 3>& t, bool withMargin, Touched* which) const {
  if (withMargin) return !objects_->clears(t[0], t[1], t[2], clearance_) || objects_->encloses(t[0]);
  if (objects_->meets(t[0], t[1], t[2], which ? &which->objects : nullptr)) return true;
  if (!objects_->encloses(t[0])) return false;
  if (which) which->objects.push_back(objects_->objectAt(t[0]));
  return true;
}

bool Walls::meetsBalls(const std::array<Vec3, 3>& t, double size, const Range& bricks, bool withMargin,
                       Touched* which) const {
  bool any = false;
  forEach(bricks, [&](const Index& b) {
    const std::size_t brick = idx(brickAt(b));
    for (int i = first_[brick]; i < first_[brick + 1] && (which || !any); ++i) {
      const std::size_t ball = idx(balls_[i]);
      const Vec3& centre = list_.balls[ball].centre;
      const double radius = withMargin ? reaches_[ball].guard : list_.balls[ball].radius;
      if ((t[0] - centre).squaredNorm() > (radius + size) * (radius + size)) continue;
      if (squaredDistance(centre, t[0], t[1], t[2]) > radius * radius) continue;
      any = true;
      if (which) which->balls.push_back(static_cast<int>(ball));
    }
  });
  return any;
}

bool Walls::meetsVoxels(const std::array<Vec3, 3>& t, bool withMargin, Touched* which) const {
  const double wide = withMargin ? margin_ : 0.0;
  const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  const Vec3 half = 0.5 * grid_.spacing + Vec3::Constant(wide);
  bool any = false;
  forEach(voxelsWithin(low, high, wide), [&](const Index& v) {
    if ((any && !which) || !isWall(v)) return;
    const Vec3 centre(v[0], v[1], v[2]);
    const auto local = [&](const Vec3& p) { return Vec3((p - centre).cwiseProduct(grid_.spacing)); };
    if (!meetsBox(local(t[0]), local(t[1]), local(t[2]), half)) return;
    any = true;
    if (!which) return;
    const std::size_t row = idx(v[2]) * idx(grid_.size[1]) + idx(v[1]);
    which->voxels.push_back(row * idx(grid_.size[0]) + idx(v[0]));
  });
  return any;
}

}  // namespace handlebody
