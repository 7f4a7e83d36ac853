#pragma once
// What a further click changes: near it, and by about as much as it says is wrong.

#include "core/object/region.h"

namespace handlebody {

//! A click and its cell. A click in the middle of what is wrong says how large that is: about as deep as the
//! click lies behind the surface.
struct CellClick {
  Vec3 place{0, 0, 0};  //!< mm
  std::size_t cell = 0;
  double radius = 0;  //!< mm: of a ball that is all inside or all outside; 0 = the cell
};

//! How deep (mm) a click lies on the wrong side of the region's surface; at least one cell.
double depthBehindSurface(const WorkImage& work, const Region& region, std::size_t cell);

//! How deep (mm) the cells are that one region has and the other has not.
struct ChangeDepth {
  double added = 0, removed = 0;
};
ChangeDepth depthOfChange(const WorkImage& work, const Region& from, const Region& to);

//! The region without what hangs closer to the click than to the rest: paths are long across edges and
//! through thin places. Only cells within twice the click's depth can go.
Region cutAway(const WorkImage& work, const Region& region, const CellClick& click,
               const std::vector<CellClick>& inside, double noise, double depth);

//! Makes the balls of the clicks what they are said to be.
void stamp(const WorkImage& work, Region& region, const std::vector<CellClick>& inside,
           const std::vector<CellClick>& outside);

}  // namespace handlebody
