#include "core/object/centrality.h"

#include <algorithm>
#include <cmath>

#include "core/object/distance.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;
// Cells that are sampled; a ball among them has a radius of 17.
constexpr std::size_t kSampled = 40'000;
// Sampled depths of so many steps or less are measured again in all cells.
constexpr double kShallow = 3;

//! Every n-th cell along each axis, the click among them, and a layer of what is outside around them.
struct Lattice {
  Cell low{}, size{};
  int step = 1;

  Lattice(const Cell& from, const Cell& to, const Cell& click, int n) : step(n) {
    for (std::size_t a = 0; a < 3; ++a) {
      const int below = (click[a] - from[a]) / n + 1, above = (to[a] - click[a]) / n + 1;
      low[a] = click[a] - below * n;
      size[a] = below + above + 1;
    }
  }
  std::size_t at(const Cell& cell) const {
    std::size_t out = 0;
    for (std::size_t a = 3; a-- > 0;)
      out = out * static_cast<std::size_t>(size[a]) + static_cast<std::size_t>((cell[a] - low[a]) / step);
    return out;
  }
  //! Calls f(cell, whether it is in the outermost layer), x fastest.
  template <typename F>
  void forCells(F&& f) const {
    const auto isRim = [&](int i, std::size_t a) { return i == 0 || i + 1 == size[a]; };
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x)
          f(Cell{low[0] + x * step, low[1] + y * step, low[2] + z * step},
            isRim(x, 0) || isRim(y, 1) || isRim(z, 2));
  }
};

int stepFor(const Cell& from, const Cell& to) {
  double cells = 1;
  for (std::size_t a = 0; a < 3; ++a) cells *= to[a] - from[a] + 1;
  return std::max(1, static_cast<int>(std::ceil(std::cbrt(cells / static_cast<double>(kSampled)))));
}

bool holds(const RankedRegion& r, const Cell& c) {
  const CellGrid& cells = r.search->image.cells;
  for (std::size_t a = 0; a < 3; ++a)
    if (c[a] < 0 || c[a] >= cells.grid.size[a]) return false;
  return r.holds(cells.at(c));
}

//! Distance (mm) from the click to the nearest cell that the region does not hold, up to `reach`.
double depthUpTo(double reach, const RankedRegion& r, const Cell& click) {
  const Vec3& h = r.search->image.cells.grid.spacing;
  Cell n{};
  for (std::size_t a = 0; a < 3; ++a) n[a] = static_cast<int>(reach / h[static_cast<Eigen::Index>(a)]);
  double nearest = reach;
  for (int z = -n[2]; z <= n[2]; ++z)
    for (int y = -n[1]; y <= n[1]; ++y)
      for (int x = -n[0]; x <= n[0]; ++x) {
        const double d = Vec3(x, y, z).cwiseProduct(h).norm();
        if (d < nearest && !holds(r, {click[0] + x, click[1] + y, click[2] + z})) nearest = d;
      }
  return nearest;
}

//! A box around the region; what is thinner than the steps of a first look may be left out.
std::array<Cell, 2> roughBox(const RankedRegion& r, const Cell& click) {
  const Cell& size = r.search->image.cells.grid.size;
  const Cell last{size[0] - 1, size[1] - 1, size[2] - 1};
  const Lattice all({0, 0, 0}, last, click, stepFor({0, 0, 0}, last));
  std::array<Cell, 2> box{click, click};
  all.forCells([&](const Cell& c, bool isRim) {
    if (isRim || !holds(r, c)) return;
    for (std::size_t a = 0; a < 3; ++a) {
      box[0][a] = std::min(box[0][a], std::max(0, c[a] - all.step));
      box[1][a] = std::max(box[1][a], std::min(last[a], c[a] + all.step));
    }
  });
  return box;
}

}  // namespace

double centrality(const RankedRegion& r) {
  const Cell& click = r.search->click;
  if (!holds(r, click)) return 0;
  const auto [from, to] = roughBox(r, click);
  const Lattice lattice(from, to, click, stepFor(from, to));
  std::vector<std::uint8_t> outside;
  // Where the box is rough its rim may lie within the region.
  lattice.forCells([&](const Cell& c, bool isRim) { outside.push_back(isRim || !holds(r, c)); });
  const Vec3& spacing = r.search->image.cells.grid.spacing;
  const std::vector<float> depth = distanceTo(lattice.size, spacing * lattice.step, outside);
  const double deepest = *std::max_element(depth.begin(), depth.end());
  double here = depth[lattice.at(click)];
  if (lattice.step > 1 && here <= kShallow * lattice.step * spacing.maxCoeff())
    here = depthUpTo(here, r, click);
  return std::min(1.0, here / std::max(deepest, here));
}

}  // namespace handlebody
