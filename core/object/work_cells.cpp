#include "core/object/work_cells.h"

namespace handlebody {

bool WorkCells::reach(const Reach& box) {
  if (!volume_->grid.contains(volume_->grid.toIndex(box.centre)) || holds(box)) return false;
  boxes_.push_back(box);
  return true;
}

bool WorkCells::holds(const Reach& box) const {
  if (boxes_.empty()) return false;
  const CellGrid own = cellsAround(volume_->grid, box.centre, box.reach, volume_->grid.voxelCount());
  const CellGrid all = cells();
  for (std::size_t a = 0; a < 3; ++a)
    if (own.low[a] < all.low[a] ||
        own.low[a] + own.grid.size[a] > all.low[a] + all.grid.size[a] * all.factor[a])
      return false;
  return true;
}

WorkImage WorkCells::image(const IntensityScale& scale) const {
  const CellGrid grid = cells();
  WorkImage out{makeCells(*volume_, grid, view_), {}};
  scale.apply(out.image.values);
  out.values = smoothed(grid, out.image.values, policy_->smoothing * grid.grid.meanSpacing());
  return out;
}

}  // namespace handlebody
