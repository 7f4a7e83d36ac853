#include "core/evolution/passages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evolution/space_tree.h"
#include "core/indices.h"
#include "core/object/distance.h"
#include "core/threads.h"

namespace handlebody {

namespace {

constexpr double kNarrow = 0.41;    // a passage is no more than this part of both sides
constexpr double kMinVoxels = 2.5;  // radius of what lies behind, cells
constexpr double kMinBall = 1.5;    // the same, of the balls that mark it
// A cell whose centre is nearer than this to where fronts end before a wall, in cells, is closed: no way of
// neighbours leads through a wall that is thinner than they are.
constexpr double kAtWall = 0.6;
constexpr float kUnlimited = 1e6f;                                    // mm
constexpr double kNoLimit = std::numeric_limits<double>::infinity();  // of a distance
// Below this many cells a thread costs more than it saves.
constexpr std::size_t kCellsPerThread = 50'000;

//! Calls f(cell number, x, y, z) for all cells but the outermost layer.
template <typename F>
void forInner(const std::array<int, 3>& size, F&& f) {
  for (int z = 1; z < size[2] - 1; ++z)
    for (int y = 1; y < size[1] - 1; ++y) {
      std::size_t i = (idx(z) * idx(size[1]) + idx(y)) * idx(size[0]) + 1;
      for (int x = 1; x < size[0] - 1; ++x, ++i) f(i, x, y, z);
    }
}

//! 1 in what is neither the object (0) nor a cavity in it: what hangs together with the box's border.
void fillCavities(const std::array<int, 3>& size, std::vector<std::uint8_t>& outside) {
  constexpr std::uint8_t kNotYet = 2;
  const std::array<std::size_t, 3> steps{1, idx(size[0]), idx(size[0]) * idx(size[1])};
  std::vector<std::uint32_t> front;
  const auto enter = [&](std::size_t i) {
    if (outside[i] != kNotYet) return;
    outside[i] = 1;
    front.push_back(static_cast<std::uint32_t>(i));
  };
  for (std::uint8_t& o : outside) o = o ? kNotYet : std::uint8_t{0};
  forInner(size, [&](std::size_t i, int x, int y, int z) {
    if (x == 1 || y == 1 || z == 1 || x == size[0] - 2 || y == size[1] - 2 || z == size[2] - 2) enter(i);
  });
  while (!front.empty()) {
    const std::size_t i = front.back();
    front.pop_back();
    for (const std::size_t step : steps) {
      enter(i - step);
      enter(i + step);
    }
  }
  for (std::uint8_t& o : outside) o = o == 1;
}

}  // namespace

PassageMap::PassageMap(const ObjectImage& image, const Walls* walls, const VoxelBox& box,
                       std::span<const Vec3> starts, int threads)
    : grid_(image.volume().grid()) {
  layOut(box);
  const std::vector<float> radius = findRadii(findOutside(image, walls, threads), threads);
  std::vector<std::uint32_t> cells;
  for (const Vec3& s : starts)
    if (const std::int64_t at = cellAt(s); at >= 0)
      cells.push_back(uphill(static_cast<std::uint32_t>(at), radius));
  NarrowRule rule;
  rule.narrow = kNarrow;
  rule.leastBehind = kMinVoxels * cell_;
  if (surelyTellsNothing(size_, radius, cells, rule)) return;
  SpaceTree tree(size_, radius);
  const std::vector<Merging> mergings = tree.merge(cells, rule);
  if (mergings.empty()) return;

  zones_.assign(radius.size(), 0);
  std::vector<std::vector<std::uint32_t>> cores(mergings.size());
  const auto ballOf = [&](const Merging& m) { return std::max(m.level / kNarrow, kMinBall * cell_); };
  for (std::uint32_t i = 0; i < radius.size(); ++i)
    if (const int n = tree.behindWhich(i); n > 0 && static_cast<double>(radius[i]) >= ballOf(mergings[n - 1]))
      cores[n - 1].push_back(i);
  for (std::size_t k = 0; k < mergings.size(); ++k) {
    const Merging& m = mergings[k];
    passages_.push_back(
        {placeOf(m.at), m.level, m.before, m.behind, placeOf(m.peak), m.level > 0, m.isWidening});
    markBehind(k, radius, cores[k], ballOf(m));
  }
}

bool PassageMap::isSure(const Passage& p) const {
  const double widening = NarrowRule().widening;
  return p.isWidening ? p.behind >= widening * (p.before + cell_)
                      : p.radius + cell_ <= kNarrow * std::min(p.before, p.behind);
}

void PassageMap::layOut(const VoxelBox& box) {
  low_ = box.low;
  for (step_ = 1;; ++step_) {
    std::size_t count = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      size_[a] = (box.high[a] - box.low[a]) / step_ + 3;
      count *= idx(size_[a]);
    }
    if (count <= kMaxCells) break;
  }
  cell_ = step_ * grid_.meanSpacing();
}

std::int64_t PassageMap::cellAt(const Vec3& world) const {
  const Vec3 index = grid_.toIndex(world);
  std::int64_t cell = 0;
  for (std::size_t a = 3; a-- > 0;) {
    const long i = std::lround((index[static_cast<int>(a)] - low_[a]) / step_) + 1;
    if (i < 1 || i > size_[a] - 2) return -1;
    cell = cell * size_[a] + i;
  }
  return cell;
}

Vec3 PassageMap::placeOf(std::size_t cell) const {
  const std::size_t nx = idx(size_[0]), ny = idx(size_[1]);
  const std::array<std::size_t, 3> at{cell % nx, cell / nx % ny, cell / nx / ny};
  Vec3 index;
  for (std::size_t a = 0; a < 3; ++a)
    index[static_cast<int>(a)] = low_[a] + step_ * (static_cast<double>(at[a]) - 1);
  return grid_.toWorld(index);
}

std::vector<std::uint8_t> PassageMap::findOutside(const ObjectImage& image, const Walls* walls,
                                                  int threads) const {
  std::vector<std::uint8_t> outside(idx(size_[0]) * idx(size_[1]) * idx(size_[2]), 0);
  const double closed = kAtWall * cell_;
  const auto lookAtRow = [&](int y, int z) {
    const std::array<int, 3> first{low_[0], low_[1] + step_ * (y - 1), low_[2] + step_ * (z - 1)};
    const int n = size_[0] - 2;
    std::uint8_t* row = &outside[(idx(z) * idx(size_[1]) + idx(y)) * idx(size_[0]) + 1];
    if (step_ == 1)
      image.holdsRow(first, n, row);
    else
      for (int x = 0; x < n; ++x) row[x] = image.holds({first[0] + step_ * x, first[1], first[2]});
    for (int x = 0; x < n; ++x) {
      const Vec3 index(first[0] + step_ * x, first[1], first[2]);
      const bool in = row[x] && (!walls || walls->room(grid_.toWorld(index), index) > closed);
      row[x] = !in;
    }
  };
  const std::size_t cellsOfSlab = idx(size_[0]) * idx(size_[1]);
  forRangesOnThreads(idx(size_[2] - 2), threads, kCellsPerThread / cellsOfSlab + 1,
                     [&](std::size_t from, std::size_t to) {
                       for (int z = static_cast<int>(from) + 1; z <= static_cast<int>(to); ++z)
                         for (int y = 1; y < size_[1] - 1; ++y) lookAtRow(y, z);
                     });
  fillCavities(size_, outside);
  return outside;
}

//! Measured to where the object ends: half a cell before the first centre outside.
std::vector<float> PassageMap::findRadii(const std::vector<std::uint8_t>& outside, int threads) const {
  std::vector<float> radius = distanceTo(size_, step_ * grid_.spacing, outside, kNoLimit, threads);
  std::vector<float> inner(radius.size(), 0.0f);
  const auto half = static_cast<float>(cell_ / 2);
  forInner(size_, [&](std::size_t i, int, int, int) {
    if (!outside[i]) inner[i] = std::min(std::max(radius[i] - half, 0.25f * half), kUnlimited);
  });
  return inner;
}

//! A click near the edge of a space means that space.
std::uint32_t PassageMap::uphill(std::uint32_t cell, const std::vector<float>& radius) const {
  const std::ptrdiff_t row = size_[0], slab = row * size_[1];
  while (radius[cell] > 0) {
    std::uint32_t best = cell;
    for (std::ptrdiff_t dz = -slab; dz <= slab; dz += slab)
      for (std::ptrdiff_t dy = -row; dy <= row; dy += row)
        for (std::ptrdiff_t dx = -1; dx <= 1; ++dx) {
          const auto n = static_cast<std::uint32_t>(cell + dz + dy + dx);
          if (radius[n] > radius[best]) best = n;
        }
    if (best == cell) break;
    cell = best;
  }
  return cell;
}

//! All cells that balls of that radius (mm) reach in the space behind; `core`: where they fit.
void PassageMap::markBehind(std::size_t passage, const std::vector<float>& radius,
                            const std::vector<std::uint32_t>& core, double ball) {
  const std::size_t nx = idx(size_[0]), ny = idx(size_[1]);
  const auto at = [&](std::uint32_t c) {
    return std::array<int, 3>{static_cast<int>(c % nx), static_cast<int>(c / nx % ny),
                              static_cast<int>(c / nx / ny)};
  };
  std::array<int, 3> low = size_, high{0, 0, 0}, size{};
  for (const std::uint32_t c : core)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], at(c)[a]);
      high[a] = std::max(high[a], at(c)[a]);
    }
  for (std::size_t a = 0; a < 3; ++a) {
    const int wide = static_cast<int>(std::ceil(ball / (step_ * grid_.spacing[static_cast<int>(a)])));
    low[a] = std::max(1, low[a] - wide);
    high[a] = std::min(size_[a] - 2, high[a] + wide);
    size[a] = high[a] - low[a] + 1;
  }
  std::vector<std::uint8_t> marks(idx(size[0]) * idx(size[1]) * idx(size[2]), 0);
  const auto local = [&](const std::array<int, 3>& c) {
    return (idx(c[2] - low[2]) * idx(size[1]) + idx(c[1] - low[1])) * idx(size[0]) + idx(c[0] - low[0]);
  };
  for (const std::uint32_t c : core) marks[local(at(c))] = 1;
  const std::vector<float> d = distanceTo(size, step_ * grid_.spacing, marks);
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const std::size_t i = (idx(z) * ny + idx(y)) * nx + idx(x);
        if (static_cast<double>(d[local({x, y, z})]) < ball && radius[i] > 0 && zones_[i] == 0)
          zones_[i] = static_cast<std::uint8_t>(passage + 1);
      }
}

}  // namespace handlebody
