#pragma once
// Where the object is kept: cells around the first click that reach what else turns out to belong to it.

#include <vector>

#include "core/object/intensity_scale.h"
#include "core/object/region.h"

namespace handlebody {

class WorkCells {
 public:
  //! `view` may be null; all must outlive this.
  WorkCells(const Volume& volume, const FieldOfView* view, const ObjectPolicy& policy)
      : volume_(&volume), view_(view), policy_(&policy) {}

  //! The box is widened by that around a point of the volume. False if it holds that already.
  bool reach(const Reach& box);
  CellGrid cells() const { return cells(policy_->workCells); }
  //! The same box in the finest cells that are no more than `most`.
  CellGrid cells(std::size_t most) const { return cellsAround(volume_->grid, boxes_, most); }
  //! The image in the box on a scale, smoothed.
  WorkImage image(const IntensityScale& scale) const;

 private:
  bool holds(const Reach& box) const;

  const Volume* volume_;
  const FieldOfView* view_;
  const ObjectPolicy* policy_;
  std::vector<Reach> boxes_;
};

}  // namespace handlebody
