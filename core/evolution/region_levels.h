#pragma once
// Which intensities lie on the surface of a region.

#include <functional>
#include <memory>
#include <optional>

#include "core/evolution/level_field.h"
#include "core/evolution/parameters.h"
#include "core/object/region.h"

namespace handlebody {

//! Half-way levels of the edges on a region's surface, for those that rise outwards and those that fall, and
//! which do where. Indices are those of a grid of one's choice.
struct RegionLevels {
  std::shared_ptr<const LevelField> high;  //!< of edges that rise outwards
  std::shared_ptr<const LevelField> low;   //!< of those that fall
  std::shared_ptr<const LevelField> side;  //!< +1 where the edges rise, -1 where they fall, mixed between
  double halfStep = 0;                     //!< typical, intensities; 0 = there is no edge
  ObjectKind kind = ObjectKind::dark;      //!< dark: more of the edges rise
};

//! The level (intensity) that the surface follows already near a place (world, mm) on an edge that rises
//! outwards, or falls; none elsewhere.
using KnownLevel = std::function<std::optional<double>(const Vec3& world, bool rises)>;

//! Of a region in the work image's cells; the fields are for indices of `grid`. A known level is kept.
RegionLevels levelsOn(const WorkImage& work, const Region& region, const Grid& grid,
                      const KnownLevel& known = {});

}  // namespace handlebody
