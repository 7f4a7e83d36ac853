#include "core/object/displacement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/indices.h"
#include "core/object/shortest_paths.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;

//! From a cell to one of the 26 around it.
struct Way {
  Cell by;
  double length;  // mm
};
std::vector<Way> waysIn(const CellGrid& cells) {
  std::vector<Way> ways;
  forBox({{-1, -1, -1}, {1, 1, 1}}, [&](const Cell& by) {
    if (by != Cell{0, 0, 0}) ways.push_back({by, placeOf(cells, by).norm()});
  });
  return ways;
}

//! Lengths (mm) of the shortest paths from the side of a region that moves, in a box. A step across an edge
//! is as long as more.
std::vector<float> waysFromSide(const WorkImage& work, const Region& from, const CellBox& box,
                                const Displacement& d) {
  const CellGrid& cells = work.cells();
  std::vector<float> lengths(box.count(), std::numeric_limits<float>::infinity()), values(box.count());
  forBox(box, [&](const Cell& c) {
    values[box.at(c)] = work.values[cells.at(c)];
    if ((from.inside[cells.at(c)] != 0) == d.isInside) lengths[box.at(c)] = 0;
  });
  const std::vector<Way> ways = waysIn(cells);
  const auto size = box.size();
  const auto forNeighbours = [&](std::size_t i, auto&& f) {
    const std::size_t row = i / idx(size[0]);
    const Cell c{box.low[0] + static_cast<int>(i % idx(size[0])),
                 box.low[1] + static_cast<int>(row % idx(size[1])),
                 box.low[2] + static_cast<int>(row / idx(size[1]))};
    for (const Way& way : ways) {
      const Cell next{c[0] + way.by[0], c[1] + way.by[1], c[2] + way.by[2]};
      if (box.holds(next)) f(box.at(next), way.length);
    }
  };
  const auto step = [&](std::size_t i, std::size_t j, double length) {
    const double jump = d.edge > 0 ? (values[i] - values[j]) / d.edge : 0;
    return length * (1 + jump * jump);
  };
  followShortestPaths(lengths, d.height, forNeighbours, step);
  return lengths;
}

//! The cells of a slice on the volume's border in which the click lies.
void startInEndSlice(const CellGrid& cells, const CellBox& box, const Displacement& d,
                     std::vector<float>& lengths) {
  const Cell click = cells.cellOf(d.click.cell);
  for (std::size_t a = 0; a < 3; ++a) {
    const double thick = cells.grid.spacing[static_cast<Eigen::Index>(a)];
    const bool areSlices = d.slices > 0 && thick >= d.slices * cells.grid.spacing.minCoeff();
    const int last = cells.grid.size[a] - 1;
    if (!areSlices || last < d.fewSlices) continue;
    const bool isEnd = (click[a] == 0 && !cells.goesOn[a][0]) || (click[a] == last && !cells.goesOn[a][1]);
    if (!isEnd) continue;
    CellBox slice = box;
    slice.low[a] = slice.high[a] = click[a];
    forBox(slice, [&](const Cell& c) { lengths[box.at(c)] = 0; });
  }
}

}  // namespace

Region displaced(const WorkImage& work, const Region& from, Region region, const Displacement& d) {
  const CellGrid& cells = work.cells();
  const double least = 0.5 * cells.grid.meanSpacing();
  if (d.height <= least) return region;
  const Cell centre = cells.cellOf(d.click.cell);
  const Vec3 middle = placeOf(cells, centre);
  const double reach = d.width * std::sqrt(2 * std::log(d.height / least));
  const CellBox box = boxAround(cells, centre, reach + d.height);
  std::vector<float> lengths = waysFromSide(work, from, box, d);
  if (!d.isInside) startInEndSlice(cells, box, d, lengths);
  std::vector<Vec3> against;
  for (const CellClick& c : d.against) against.push_back(placeOf(cells, cells.cellOf(c.cell)));
  forBox(box, [&](const Cell& c) {
    const Vec3 at = placeOf(cells, c);
    const double r = (at - middle).squaredNorm();
    if (r > reach * reach) return;
    if (lengths[box.at(c)] > d.height * std::exp(-r / (2 * d.width * d.width))) return;
    if (std::any_of(against.begin(), against.end(),
                    [&](const Vec3& a) { return (at - a).squaredNorm() < r; }))
      return;
    region.inside[cells.at(c)] = d.isInside;
  });
  return region;
}

}  // namespace handlebody
