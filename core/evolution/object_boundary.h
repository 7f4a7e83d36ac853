#pragma once
// Where the boundary of the object lies: its level place by place, and the neck through which it would leak.

#include <optional>
#include <vector>

#include "core/evolution/level_field.h"
#include "core/evolution/neck.h"
#include "core/volume/smoothed_volume.h"

namespace handlebody {

struct ObjectBoundary {
  LevelField levels;
  std::optional<NeckCut> neck;  //!< its `kept` is empty
};

//! An object around seeds.
struct ObjectSearch {
  const SmoothedVolume& volume;
  std::vector<Vec3> seeds;  //!< continuous indices
  double sign;              //!< +1 for a dark object, -1 for a bright one
  double object;            //!< level of the object at the seeds, intensity units
  LevelField levels;        //!< of its boundary, to begin with
  double expectedVoxels;    //!< of the region within them
  bool isWhole = false;     //!< that region is the object: it is not to be cut at necks
};

//! Goes back and forth between the region that the levels enclose around the seeds and the levels that the
//! edges of this region suggest, until they stay as they are. A level is the mean of the intensities across
//! the boundary, weighted with the square of the steps between neighbouring voxels: between two plateaus the
//! half-way level, wherever the region's boundary lay in the ramp between them. So the surface ends half-way
//! up its own edge everywhere, whatever the gain does along it. Where the region ends without an edge the
//! steps are small, and the levels of the nearest edges go on. Where edges of different height meet the lower
//! ones decide, since a level that is too high for them would leak there; if the levels do not converge that
//! way (a gain that changes fast), the higher ones do. Levels that have converged without a neck are then
//! moved to where the smoothing has taken the boundary: on a curved one that is not half-way
//! (edge_profile.h), so that thin tubes and small balls keep their size. The weighted mean is that of
//! Kittler, Illingworth and Föglein (1985), "Threshold selection based on a simple image statistic", taken
//! locally and at the boundary of a region only. If a region is far larger than the one before it, it has
//! leaked: it is cut at its neck (neck.h), or, where there is none, the levels go only half the way, again
//! and again. A hole in a thin wall (neck.h) is looked for whatever the size of what lies behind it: two
//! chambers of one size may share a wall with a hole. If the levels converge neither way, only lines along
//! the normals of the edges are asked, for half-way levels creep up on small objects that lines cross at a
//! slant; if not even then (surroundings that change along the boundary, not a gain), the first levels stay.
ObjectBoundary findBoundary(const ObjectSearch& search);

//! For a region that is out of all proportion to the place of the seeds: it has leaked, though no level shows
//! where. The same level everywhere, lowered towards that of the object until a neck shows. None if none
//! does.
std::optional<ObjectBoundary> findBoundaryAtNeck(const ObjectSearch& search);

}  // namespace handlebody
