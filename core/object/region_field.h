#pragma once
// How deep a point lies in a region of cells.

#include <vector>

#include "core/object/region.h"

namespace handlebody {

//! Signed distance to the surface of a region: mm, > 0 inside. Within the box of the region and some cells
//! around it; further out it is that of the nearest place in the box. Where the cells end and the volume goes
//! on the region ends, too; at the volume's border it goes on as it is there.
class RegionField {
 public:
  RegionField(const WorkImage& work, const Region& region);
  //! At a world point (mm); between the cells' centres trilinear.
  double at(const Vec3& world) const;
  //! True if a way leads from one point to another that is this deep (mm) in the region all along.
  bool areJoined(const Vec3& from, const Vec3& to, double depth) const;

 private:
  Grid grid_;  // of the box
  std::vector<float> distance_;
};

}  // namespace handlebody
