#pragma once
// What one further click makes of a region: what it may ask for is tried, the best of it taken, and the
// surface moves around the click.

#include <memory>
#include <optional>
#include <vector>

#include "core/object/candidates.h"
#include "core/object/corrections.h"
#include "core/object/expected_overlap.h"

namespace handlebody {

//! A click that is taken in, or will be.
struct GivenClick {
  CellClick click;
  bool isInside = true;
  std::optional<double> asked{};  //!< mm: its radius, if it was given one
};
inline bool isTrue(const Region& r, const GivenClick& c) {
  return (r.inside[c.click.cell] != 0) == c.isInside;
}
//! Those of one side.
std::vector<CellClick> clicksOf(const std::vector<GivenClick>& clicks, bool isInside);

//! What some clicks have made of the first region.
struct Corrected {
  Region region;
  std::vector<GivenClick> done;  //!< clicks that have been taken in
  int inARow = 0;                //!< corrections near clicks, after the last of the whole
  double largest = 0;            //!< cells, that it has had when something was looked for
  bool isBoundary = false;       //!< between two intensities, found to a fraction of a cell
  std::vector<Vec3> parts{};     //!< mm: in parts of the first region that hold no click, and are kept
};

//! Only what hangs together with the clicks inside so far, or with `parts` (mm), without the holes that noise
//! makes.
Region tidied(const WorkImage& work, Region region, const std::vector<GivenClick>& done,
              const ObjectPolicy& policy, const std::vector<Vec3>& parts = {});

using ClickSearches = std::vector<std::unique_ptr<ClickSearch>>;

//! Where a correction looks for regions.
class RegionSource {
 public:
  virtual ~RegionSource() = default;
  //! All that may be meant, star-shaped ones through these clicks among them. Valid until the next call.
  virtual std::vector<RankedRegion> rank(const std::vector<CellClick>& inside,
                                         const std::vector<CellClick>& outside) = 0;
  //! They in the cells of the object, their surfaces on the edges next to them.
  virtual std::vector<std::shared_ptr<const Region>> onImage(const std::vector<OfferedRegion>& offered) = 0;
  virtual ClickSearches searchesAround(const Vec3& click) const = 0;
};

//! What all corrections of an object have in common.
struct CorrectionScene {
  RegionSource& source;
  const WorkImage& work;
  double noise;  //!< standard deviation, intensities
  const ObjectPolicy& policy;
  int threads;
};

//! Takes in the click that was done last, `depth` mm on the wrong side of the surface. The region stays as it
//! is where nothing serves.
void correct(const CorrectionScene& scene, Corrected& corrected, double depth);

}  // namespace handlebody
