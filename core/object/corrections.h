#pragma once
// What a further click changes: near it, and by about as much as it says is wrong.

#include "core/object/region.h"

namespace handlebody {

//! How deep (mm) a click lies on the wrong side of the region's surface; at least one cell.
double depthBehindSurface(const WorkImage& work, const Region& region, std::size_t cell);

//! How deep (mm) the deepest cell of a region lies in it.
double deepestInside(const WorkImage& work, const Region& region);

//! How deep (mm) the cells are that one region has and the other has not.
struct ChangeDepth {
  double added = 0, removed = 0;
};
ChangeDepth depthOfChange(const WorkImage& work, const Region& from, const Region& to);

//! How strong the edges are (mean log2 of 1 + jump over noise) on the surface that a change gains and on that
//! which it loses.
struct EdgeChange {
  double gained = 0, lost = 0;
};
EdgeChange edgesOfChange(const WorkImage& work, const Region& from, const Region& to, double noise);

//! The region without what hangs closer to the click than to the rest: paths are long across edges and
//! through thin places. Only cells within twice the click's depth can go.
Region cutAway(const WorkImage& work, const Region& region, const CellClick& click,
               const std::vector<CellClick>& inside, double noise, double depth);

//! Makes the balls of the clicks what they are said to be.
void stamp(const WorkImage& work, Region& region, const std::vector<CellClick>& inside,
           const std::vector<CellClick>& outside);

//! What a click on the wrong side asks for.
struct WantedChange {
  bool isInside;  //!< the click: the region grows
  double depth;   //!< mm: of the click behind the surface
  double noise;   //!< standard deviation, intensities
};
//! What speaks against a change (score, at least 0): its surface has weaker edges than the one it gives
//! up, it is deeper than the click in the click's sense, or deep at all against it. Stronger edges win
//! nothing: what is around an object has strong ones, too.
double costOfChange(const WorkImage& work, const Region& from, const Region& to, const WantedChange& wanted,
                    const ObjectPolicy& policy);

}  // namespace handlebody
