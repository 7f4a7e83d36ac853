#include "core/object/displacement.h"

#include <algorithm>
#include <cmath>

#include "core/object/distance.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;

Vec3 placeOf(const CellGrid& cells, const Cell& c) {
  return Vec3(c[0], c[1], c[2]).cwiseProduct(cells.grid.spacing);
}

//! Distance (mm) of the cells of a box to the side of the region that moves over them.
std::vector<float> distanceToSide(const CellGrid& cells, const Region& region, const CellBox& box,
                                  const Displacement& d) {
  std::vector<std::uint8_t> side = cutOut(cells, region.inside, box);
  if (!d.isInside)
    for (std::uint8_t& s : side) s = !s;
  return distanceTo(box.size(), cells.grid.spacing, side, d.height);
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
  const std::vector<float> distance = distanceToSide(cells, from, box, d);
  std::vector<Vec3> against;
  for (const CellClick& c : d.against) against.push_back(placeOf(cells, cells.cellOf(c.cell)));
  forBox(box, [&](const Cell& c) {
    const Vec3 at = placeOf(cells, c);
    const double r = (at - middle).squaredNorm();
    if (r > reach * reach) return;
    if (distance[box.at(c)] > d.height * std::exp(-r / (2 * d.width * d.width))) return;
    if (std::any_of(against.begin(), against.end(),
                    [&](const Vec3& a) { return (at - a).squaredNorm() < r; }))
      return;
    region.inside[cells.at(c)] = d.isInside;
  });
  return region;
}

}  // namespace handlebody
