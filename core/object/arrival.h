#pragma once
// Region growing from a click at all levels at once, with passages of a width cut: the opened component tree
// of one place.

#include <array>
#include <cstdint>
#include <vector>

#include "core/object/cells.h"

namespace handlebody {

//! Rungs: the distances from the intensity at the click at which regions end.
inline constexpr int kRungs = 20;
//! Level of a cell that no region reaches.
inline constexpr std::uint8_t kNever = kRungs + 1;

//! How the intensities at a click lie: its level, the ladder of distances from it, the noise.
struct ClickIntensities {
  double level = 0;                    //!< median around the click
  double range = 0;                    //!< of the intensities around it
  double noise = 0;                    //!< standard deviation
  std::array<float, kRungs> ladder{};  //!< ascending distances from `level`
};
//! Standard deviation of the noise in a box of `reach` cells to each side of one: from the median of the
//! second differences, in which edges hardly count. In white noise they have 6 times its variance.
double noiseAround(const CellGrid& cells, const std::vector<float>& raw, const std::array<int, 3>& click,
                   int reach);

//! `raw`: before smoothing.
ClickIntensities readClick(const CellGrid& cells, const std::vector<float>& raw,
                           const std::vector<float>& values, const std::array<int, 3>& click,
                           const ObjectPolicy& policy);

//! Which rungs the intensities below and above the click's level lie on, cell by cell.
struct RungImage {
  std::vector<std::uint8_t> below, above;
};
RungImage rungsOf(const CellImage& image, const std::vector<float>& values, const std::array<int, 3>& click,
                  const ClickIntensities& intensities);

//! The regions {level <= t} for all t: connected cells of intensities from the click's level less rung t to
//! the level plus rung `band`, without what hangs on by a passage narrower than the opening.
struct ArrivalMap {
  int band = 0;       //!< rung of the other bound; kRungs = none
  int passes = 0;     //!< of the opening
  double radius = 0;  //!< of the opening, mm
  int end = kNever;   //!< rungs from here on are not known: the region became the background
  //! > 0: a star-shaped region, at level 0, in which this part of the starts ended; it has no bounds.
  double agreement = 0;
  std::vector<std::uint8_t> level;
};

//! One map per band and opening of the policy, in this order; those in which the click is cut off are left
//! out. Bands go on threads of their own.
std::vector<ArrivalMap> arrivalMaps(const CellGrid& cells, const RungImage& rungs,
                                    const std::array<int, 3>& click, const ObjectPolicy& policy, int threads);

}  // namespace handlebody
