#include "core/object/region_field.h"

#include <algorithm>
#include <cmath>

#include "core/object/distance.h"
#include "core/volume/voxel_walk.h"

namespace handlebody {

namespace {

constexpr int kMargin = 4;       // cells around the region
constexpr double kSmooth = 0.7;  // cells: takes the steps of the cells' faces away

//! Half the way from a centre to the next one across the surface belongs to the other side.
float toSurface(float toCentre, double cell) {
  return toCentre - static_cast<float>(0.5 * std::min<double>(toCentre, cell));
}

//! A region with a margin around it: also beyond the cells where the volume goes on. At the volume's border
//! the box ends as the cells do.
CellBox withMargin(const CellGrid& cells, CellBox box) {
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [below, above] = cells.goesOn[a];
    box.low[a] -= below ? kMargin : std::min(kMargin, box.low[a]);
    box.high[a] += above ? kMargin : std::min(kMargin, cells.grid.size[a] - 1 - box.high[a]);
  }
  return box;
}

}  // namespace

RegionField::RegionField(const WorkImage& work, const Region& region) {
  const CellGrid& cells = work.cells();
  const CellBox box = withMargin(cells, boxOf(cells, region));
  CellGrid part = cells;
  part.grid.size = box.size();
  part.grid.origin = cells.grid.toWorld(Vec3(box.low[0], box.low[1], box.low[2]));
  grid_ = part.grid;
  const std::vector<std::uint8_t> inside = cutOut(cells, region.inside, box);
  std::vector<std::uint8_t> outside(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) outside[i] = !inside[i];
  const double cell = grid_.meanSpacing();
  const std::vector<float> in = distanceTo(grid_.size, grid_.spacing, outside),
                           out = distanceTo(grid_.size, grid_.spacing, inside);
  const float most =
      static_cast<float>(grid_.spacing.maxCoeff() * (grid_.size[0] + grid_.size[1] + grid_.size[2]));
  std::vector<float> signedDistance(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i)
    signedDistance[i] = inside[i] ? toSurface(std::min(in[i], most), cell) : -toSurface(out[i], cell);
  distance_ = smoothed(part, signedDistance, kSmooth * cell);
}

double RegionField::at(const Vec3& world) const {
  // Where the box ends at the volume's border, what is beyond is as the border is.
  return trilinear(distance_.data(), grid_.size, grid_.toIndex(world));  // some may be infinite
}

bool RegionField::areJoined(const Vec3& from, const Vec3& to, double depth) const {
  const CellGrid cells{grid_};
  if (!cells.contains(from) || !cells.contains(to)) return false;
  const std::size_t goal = cells.at(cells.nearest(to));
  std::vector<std::uint8_t> seen(distance_.size());
  std::vector<std::size_t> front;
  const auto visit = [&](const std::array<int, 3>& c) {
    const std::size_t i = cells.at(c);
    if (seen[i] || distance_[i] < depth) return;
    seen[i] = 1;
    front.push_back(i);
  };
  visit(cells.nearest(from));
  while (!front.empty() && !seen[goal]) {
    const std::array<int, 3> c = cells.cellOf(front.back());
    front.pop_back();
    for (std::size_t a = 0; a < 3; ++a)
      for (const int step : {-1, 1}) {
        std::array<int, 3> n = c;
        n[a] += step;
        if (n[a] >= 0 && n[a] < grid_.size[a]) visit(n);
      }
  }
  return seen[goal] != 0;
}

}  // namespace handlebody
