#include "core/object/corrections.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/indices.h"
#include "core/object/distance.h"
#include "core/object/eight_cells.h"
#include "core/object/shortest_paths.h"
#include "core/volume/voxel_walk.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;
// Reach of a correction around its click, in depths of the click, and cells more.
constexpr double kCutReach = 2, kMore = 1;
// An edge of this many times the noise doubles the length of a step across it.
constexpr double kEdge = 1.5;
// A place as deep as this many cells makes a step three times as long as in the open.
constexpr double kThin = 2;

Vec3 indexOf(const Cell& c) { return Vec3(c[0], c[1], c[2]); }

//! A box around the marked cells (1) of a box of this size, and the cells next to it.
CellBox boxOfMarked(const std::array<int, 3>& size, const std::vector<std::uint8_t>& mask) {
  CellBox box{size, {-1, -1, -1}};
  std::size_t row = 0;
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y, row += idx(size[0])) {
      const auto* first = static_cast<const std::uint8_t*>(std::memchr(&mask[row], 1, idx(size[0])));
      if (!first) continue;
      int last = size[0] - 1;
      while (!mask[row + idx(last)]) --last;
      box.widen({static_cast<int>(first - &mask[row]), y, z});
      box.widen({last, y, z});
    }
  return box.empty() ? box : box.grown(1, size);
}

//! Largest distance (mm) of a marked cell to the others; the border of the box counts as unmarked. The
//! nearest of the others is never further away than next to the box around the marked ones.
double deepest(const std::array<int, 3>& size, const Vec3& spacing, const std::vector<std::uint8_t>& mask) {
  const CellBox box = boxOfMarked(size, mask);
  if (box.empty()) return 0;
  std::vector<std::uint8_t> other;
  other.reserve(box.count());
  for (int z = box.low[2]; z <= box.high[2]; ++z)
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      const auto row =
          mask.begin() + static_cast<std::ptrdiff_t>((idx(z) * idx(size[1]) + idx(y)) * idx(size[0]));
      for (auto m = row + box.low[0]; m <= row + box.high[0]; ++m) other.push_back(!*m);
    }
  return greatestDistanceTo(box.size(), spacing, other);
}

//! Shortest paths from two sets within a region.
class Competition {
 public:
  Competition(const WorkImage& work, const Region& region, const CellBox& box, double noise)
      : work_(work),
        box_(box),
        size_(box.size()),
        inside_(cutOut(work.cells(), region.inside, box)),
        noise_(noise) {
    std::vector<std::uint8_t> outside(inside_.size());
    for (std::size_t i = 0; i < outside.size(); ++i) outside[i] = !inside_[i];
    depth_ = distanceTo(size_, work.cells().grid.spacing, outside);
  }

  std::size_t local(const Cell& c) const { return box_.at(c); }
  bool isInside(const Cell& c) const { return inside_[local(c)] != 0; }

  std::vector<float> lengthsFrom(const std::vector<Cell>& starts) const {
    std::vector<float> lengths(inside_.size(), std::numeric_limits<float>::infinity());
    for (const Cell& c : starts) lengths[local(c)] = 0;
    const auto forNeighbours = [&](std::size_t i, auto&& f) {
      forFaceNeighbours(size_, i, [&](std::size_t j, std::size_t axis) {
        if (inside_[j]) f(j, axis);
      });
    };
    const auto step = [&](std::size_t i, std::size_t j, std::size_t axis) {
      return work_.cells().grid.spacing[static_cast<Eigen::Index>(axis)] * weight(i, j);
    };
    followShortestPaths(lengths, std::numeric_limits<double>::infinity(), forNeighbours, step);
    return lengths;
  }

 private:
  double value(std::size_t i) const {
    const std::size_t nx = idx(size_[0]), ny = idx(size_[1]);
    return work_.values[work_.cells().at(box_.low[0] + static_cast<int>(i % nx),
                                         box_.low[1] + static_cast<int>(i / nx % ny),
                                         box_.low[2] + static_cast<int>(i / (nx * ny)))];
  }
  double weight(std::size_t i, std::size_t j) const {
    const double jump = (value(i) - value(j)) / (kEdge * noise_);
    const double deep = std::min(depth_[i], depth_[j]) / work_.cells().grid.meanSpacing();
    return (1 + jump * jump) * (1 + kThin / std::max(0.5, deep));
  }

  const WorkImage& work_;
  CellBox box_;
  std::array<int, 3> size_;
  std::vector<std::uint8_t> inside_;
  std::vector<float> depth_;
  double noise_;
};

void setBall(const WorkImage& work, Region& region, const CellClick& click, std::uint8_t to) {
  const CellGrid& cells = work.cells();
  region.inside[click.cell] = to;
  const Vec3 centre = cells.grid.toWorld(indexOf(cells.cellOf(click.cell)));
  forCellsWithin(cells, centre, click.radius, [&](std::size_t i) { region.inside[i] = to; });
}

}  // namespace

double depthBehindSurface(const WorkImage& work, const Region& region, std::size_t cell) {
  const CellGrid& cells = work.cells();
  const std::uint8_t here = region.inside[cell];
  const Cell centre = cells.cellOf(cell);
  const Vec3 at = placeOf(cells, centre);
  const double least = cells.grid.meanSpacing();
  // Boxes twice as large each time: most clicks lie near the surface.
  for (double reach = 4 * least;; reach *= 2) {
    const CellBox box = boxAround(cells, centre, reach);
    double nearest = std::numeric_limits<double>::infinity();
    forBox(box, [&](const Cell& c) {
      if (region.inside[cells.at(c)] != here) nearest = std::min(nearest, (placeOf(cells, c) - at).norm());
    });
    if (nearest <= reach) return std::max(least, nearest);
    if (box.count() == cells.count()) return std::isfinite(nearest) ? nearest : reach;
  }
}

namespace {

//! Largest depth (mm) of the cells in `a` that are not in `b`; `box` holds all in which they differ.
double deepestBeyond(const WorkImage& work, const Region& a, const Region& b, const CellBox& box) {
  const CellGrid& cells = work.cells();
  std::vector<std::uint8_t> change = cutOut(cells, a.inside, box);
  const std::vector<std::uint8_t> other = cutOut(cells, b.inside, box);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] &= static_cast<std::uint8_t>(other[i] ^ 1);
  return deepest(box.size(), cells.grid.spacing, change);
}

}  // namespace

double deepestInside(const WorkImage& work, const Region& region) {
  const CellGrid& cells = work.cells();
  const CellBox box = boxOf(cells, region);
  if (box.empty()) return 0;
  const CellBox around = box.grown(1, cells.grid.size);
  return deepest(around.size(), cells.grid.spacing, cutOut(cells, region.inside, around));
}

ChangeDepth depthOfChange(const WorkImage& work, const Region& from, const Region& to) {
  const CellBox box = boxOfChange(work.cells(), from, to);
  if (box.empty()) return {};
  const CellBox around = box.grown(1, work.cells().grid.size);
  return {deepestBeyond(work, to, from, around), deepestBeyond(work, from, to, around)};
}

namespace {

//! Of eight cells each has changed as those after it along each axis have, or none of them has: no face
//! between them is gained or lost.
bool areLikeNext(const std::uint8_t* from, const std::uint8_t* to, const std::array<std::size_t, 3>& steps) {
  const auto change = [&](std::size_t at) { return eightCells(from + at) ^ eightCells(to + at); };
  const std::uint64_t own = change(0);
  return own == change(steps[0]) && own == change(steps[1]) && own == change(steps[2]);
}

}  // namespace

EdgeChange edgesOfChange(const WorkImage& work, const Region& from, const Region& to, double noise) {
  const CellGrid& cells = work.cells();
  const auto& n = cells.grid.size;
  const std::array<std::size_t, 3> steps{1, idx(n[0]), idx(n[0]) * idx(n[1])};
  const CellBox box = boxOfChange(cells, from, to);
  if (box.empty()) return {};
  EdgeChange sum, area;
  const auto addFaces = [&](const Cell& c) {
    const std::size_t i = cells.at(c);
    for (std::size_t a = 0; a < 3; ++a) {
      if (c[a] + 1 >= n[a]) continue;
      const std::size_t j = i + steps[a];
      const bool before = from.inside[i] != from.inside[j], after = to.inside[i] != to.inside[j];
      if (before == after) continue;
      const std::size_t i2 = c[a] > 0 ? i - steps[a] : i, j2 = c[a] + 2 < n[a] ? j + steps[a] : j;
      const float jump = std::max(std::abs(work.values[i] - work.values[j]),
                                  0.5f * std::abs(work.values[i2] - work.values[j2]));
      const double face = 1 / cells.grid.spacing[static_cast<Eigen::Index>(a)];
      (after ? sum.gained : sum.lost) += face * std::log2(1 + static_cast<double>(jump) / noise);
      (after ? area.gained : area.lost) += face;
    }
  };
  const CellBox around = box.grown(1, n);
  for (int z = around.low[2]; z <= around.high[2]; ++z)
    for (int y = around.low[1]; y <= around.high[1]; ++y) {
      const bool isLast = y + 1 == n[1] || z + 1 == n[2];
      for (int x = around.low[0]; x <= around.high[0]; ++x) {
        const std::size_t i = cells.at(x, y, z);
        if (!isLast && x + 8 < n[0] && areLikeNext(&from.inside[i], &to.inside[i], steps))
          x += 7;  // beyond the box nothing has changed either
        else
          addFaces({x, y, z});
      }
    }
  return {sum.gained / std::max(area.gained, 1e-12), sum.lost / std::max(area.lost, 1e-12)};
}

Region cutAway(const WorkImage& work, const Region& region, const CellClick& click,
               const std::vector<CellClick>& inside, double noise, double depth) {
  const CellGrid& cells = work.cells();
  const Cell centre = cells.cellOf(click.cell);
  const Vec3 at = placeOf(cells, centre);
  const double reach = kCutReach * depth + kMore * cells.grid.meanSpacing();
  const CellBox box = boxAround(cells, centre, reach + 2 * cells.grid.spacing.maxCoeff());
  const Competition competition(work, region, box, noise);
  std::vector<Cell> stay;
  forBox(box, [&](const Cell& c) {
    if (competition.isInside(c) && (placeOf(cells, c) - at).norm() > reach) stay.push_back(c);
  });
  for (const CellClick& p : inside) {
    const Cell c = cells.cellOf(p.cell);
    if (box.holds(c) && competition.isInside(c)) stay.push_back(c);
  }
  const std::vector<float> toStay = competition.lengthsFrom(stay),
                           toClick = competition.lengthsFrom({centre});
  Region out = region;
  forBox(box, [&](const Cell& c) {
    const std::size_t l = competition.local(c);
    if (competition.isInside(c) && toClick[l] < toStay[l]) out.inside[cells.at(c)] = 0;
  });
  return out;
}

void stamp(const WorkImage& work, Region& region, const std::vector<CellClick>& inside,
           const std::vector<CellClick>& outside) {
  for (const CellClick& c : outside) setBall(work, region, c, 0);
  for (const CellClick& c : inside) setBall(work, region, c, 1);
}

double costOfChange(const WorkImage& work, const Region& from, const Region& to, const WantedChange& wanted,
                    const ObjectPolicy& policy) {
  const double cell = work.cells().grid.meanSpacing();
  const auto [added, removed] = depthOfChange(work, from, to);
  const auto excess = [&](double change, double allowed) {
    return std::max(0.0, std::log(std::max(change, 0.5 * cell) / (allowed + 0.5 * cell)));
  };
  const EdgeChange edges = edgesOfChange(work, from, to, wanted.noise);
  return policy.edgesLost * std::max(0.0, edges.lost - edges.gained) +
         policy.tooDeep * excess(wanted.isInside ? added : removed, wanted.depth) +
         policy.against * excess(wanted.isInside ? removed : added, policy.againstDeep * wanted.depth);
}

}  // namespace handlebody
