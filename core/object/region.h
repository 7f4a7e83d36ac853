#pragma once
// A region of cells, as it is kept and corrected.

#include "core/object/candidates.h"

namespace handlebody {

//! The image in the cells in which an object is kept, and which of them belong to it.
struct Region {
  std::vector<std::uint8_t> inside;  //!< per cell
  std::size_t count() const;         //!< cells inside
};

//! The cells in which the object is kept.
struct WorkImage {
  CellImage image;
  std::vector<float> values;  //!< smoothed
  const CellGrid& cells() const { return image.cells; }
};

//! A ranked region in finer or other cells: along its surface the intensities of these decide.
Region regionOn(const WorkImage& work, const RankedRegion& region);

//! Keeps the parts that hold one of the cells, and fills cavities of fewer than `cavity` cells.
void keepParts(const WorkImage& work, Region& region, const std::vector<std::size_t>& holding, std::size_t cavity);

//! A box of cells, both ends included.
struct CellBox {
  std::array<int, 3> low, high;
  bool empty() const { return low[0] > high[0]; }
  void widen(const std::array<int, 3>& cell);
  CellBox grown(int by, const std::array<int, 3>& size) const;
  std::array<int, 3> size() const { return {high[0] - low[0] + 1, high[1] - low[1] + 1, high[2] - low[2] + 1}; }
  std::size_t count() const;
};
CellBox boxOf(const CellGrid& cells, const Region& region);
//! Part of the cells' values in a box, x fastest.
std::vector<std::uint8_t> cutOut(const CellGrid& cells, const std::vector<std::uint8_t>& values, const CellBox& box);

}  // namespace handlebody
