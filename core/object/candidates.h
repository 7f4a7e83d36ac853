#pragma once
// The regions around a click that may be meant, ranked: by how little they change when bounds or opening do,
// by their edges and by their contrast.

#include <memory>
#include <vector>

#include "core/object/arrival.h"
#include "core/object/clicks.h"
#include "core/object/intensity_scale.h"

namespace handlebody {

struct ClickSearch;
//! A region {level <= rung} of one map, and what speaks for it.
struct RankedRegion {
  const ClickSearch* search = nullptr;
  const ArrivalMap* map = nullptr;
  int rung = 0;
  double volume = 0;    //!< mm³
  double border = 0;    //!< part of its surface on the border of the volume
  double cut = 0;       //!< and on sides of the box beyond which the volume goes on
  double votes = 0;     //!< regions that can hardly be told from it
  double edge = 0;      //!< median gradient on its surface, log2 of noise per cell
  double shape = 0;     //!< log of (surface³ over that of a ball as large); 0 = a ball
  double contrast = 0;  //!< distance of the means inside and just outside over the sum of their deviations
  double rise = 0;      //!< on the search's scale: mean just outside less mean inside
  double score = 0;

  bool holds(std::size_t cell) const { return map->level[cell] <= rung; }
  //! Found by its shape; it has no bounds of intensity.
  bool isStar() const { return map->agreement > 0; }
  bool isTube() const;
  //! False for points beyond the search.
  bool holds(const Vec3& world) const;
  //! Lower and upper bound, intensities; infinite where it has none.
  std::array<double, 2> bounds() const;
  //! The same on the search's scale.
  std::array<double, 2> scaledBounds() const;
};

//! A search around one click in one grid of cells.
struct ClickSearch {
  IntensityScale scale;
  CellImage image;            //!< on the scale
  std::vector<float> values;  //!< smoothed
  std::array<int, 3> click;
  ClickIntensities intensities;     //!< on the scale
  std::vector<ArrivalMap> maps;     //!< by intensity
  std::vector<ArrivalMap> stars;    //!< star-shaped
  std::vector<RankedRegion> known;  //!< those of `maps` without scores, once rankRegions has asked for them
  std::vector<std::uint8_t> gradients;  //!< per cell, in bins; likewise
  bool isTube = false;                  //!< of one tube, in a box around it
  std::vector<Vec3> goesOn;             //!< mm: where it leaves the cells in which it was followed
};

//! Of the sides of a search's box that cut a region off, the middle of where it does, mm.
std::vector<Vec3> cutSides(const RankedRegion& region);

//! Precondition: the cells hold the click.
ClickSearch searchAround(const Volume& volume, const CellGrid& cells, const Vec3& click,
                         const FieldOfView* view, const ObjectPolicy& policy, int threads,
                         const IntensityScale& scale = {});

//! The star-shaped regions around clicks, in place of those of other clicks.
void addStars(ClickSearch& search, const std::vector<CellClick>& inside,
              const std::vector<CellClick>& outside, const ObjectPolicy& policy, int threads);

//! All regions of the searches with their scores. A region that the box of its search cuts is left out if
//! another search is `wider`.
std::vector<RankedRegion> rankRegions(const std::vector<std::unique_ptr<ClickSearch>>& searches,
                                      const ObjectPolicy& policy, int threads = 1);

//! The best `most` that differ, best first. Orders `regions` by score.
std::vector<RankedRegion> distinctRegions(std::vector<RankedRegion>& regions, std::size_t most,
                                          const ObjectPolicy& policy);

}  // namespace handlebody
