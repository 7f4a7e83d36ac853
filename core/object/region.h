#pragma once
// A region of cells, as it is kept and corrected.

#include <algorithm>

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

//! A region with the cells that it is in.
struct RegionInCells {
  CellGrid cells;
  Region region;
};
//! The same cells, and the same of them inside; null is the same as null.
bool isSame(const RegionInCells* a, const RegionInCells* b);
//! The same in other cells: those whose centres lie in it.
Region regionOn(const WorkImage& work, const RegionInCells& other);

//! A ranked region in finer or other cells: along its surface the intensities of these decide.
Region regionOn(const WorkImage& work, const RankedRegion& region);

//! Keeps the parts that hold one of the cells, and fills cavities of fewer than `cavity` cells.
void keepParts(const WorkImage& work, Region& region, const std::vector<std::size_t>& holding,
               std::size_t cavity);

//! The deepest place (mm, world) of each part that hangs together by faces.
std::vector<Vec3> deepestOfParts(const WorkImage& work, const Region& region);

//! A box of cells, both ends included.
struct CellBox {
  std::array<int, 3> low, high;
  bool empty() const { return low[0] > high[0]; }
  bool holds(const std::array<int, 3>& cell) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (cell[a] < low[a] || cell[a] > high[a]) return false;
    return true;
  }
  //! Number of a cell within the box, x fastest.
  std::size_t at(const std::array<int, 3>& cell) const {
    const auto n = size();
    return (static_cast<std::size_t>(cell[2] - low[2]) * static_cast<std::size_t>(n[1]) +
            static_cast<std::size_t>(cell[1] - low[1])) *
               static_cast<std::size_t>(n[0]) +
           static_cast<std::size_t>(cell[0] - low[0]);
  }
  void widen(const std::array<int, 3>& cell);
  CellBox grown(int by, const std::array<int, 3>& size) const;
  std::array<int, 3> size() const {
    return {high[0] - low[0] + 1, high[1] - low[1] + 1, high[2] - low[2] + 1};
  }
  std::size_t count() const;
};
//! Calls f(cell) for the cells of a box, x fastest.
template <typename F>
void forBox(const CellBox& box, F&& f) {
  for (int z = box.low[2]; z <= box.high[2]; ++z)
    for (int y = box.low[1]; y <= box.high[1]; ++y)
      for (int x = box.low[0]; x <= box.high[0]; ++x) f(std::array<int, 3>{x, y, z});
}
//! mm along the axes of the cells.
inline Vec3 placeOf(const CellGrid& cells, const std::array<int, 3>& cell) {
  return Vec3(cell[0], cell[1], cell[2]).cwiseProduct(cells.grid.spacing);
}
//! The cells within `reach` mm of one along each axis.
CellBox boxAround(const CellGrid& cells, const std::array<int, 3>& centre, double reach);
//! Calls f(cell's number) for the cells whose centres lie within `reach` mm of a point.
template <typename F>
void forCellsWithin(const CellGrid& cells, const Vec3& world, double reach, F&& f) {
  forBox(boxAround(cells, cells.nearest(world), reach + cells.grid.spacing.maxCoeff()),
         [&](const std::array<int, 3>& c) {
           if ((cells.grid.toWorld(Vec3(c[0], c[1], c[2])) - world).norm() <= reach) f(cells.at(c));
         });
}
CellBox boxOf(const CellGrid& cells, const Region& region);
//! The region reaches a side of the cells beyond which the volume goes on.
bool isCutOff(const CellGrid& cells, const Region& region);
//! Dice of two regions in the same cells; 1 if both are empty.
double overlapOf(const Region& a, const Region& b);
//! Where two regions differ.
CellBox boxOfChange(const CellGrid& cells, const Region& a, const Region& b);
//! The cells' values in a box, x fastest; 0 where it goes on beyond the cells.
template <typename T>
std::vector<T> cutOut(const CellGrid& cells, const std::vector<T>& values, const CellBox& box) {
  const auto& n = cells.grid.size;
  const int first = std::max(0, box.low[0]), last = std::min(n[0] - 1, box.high[0]);
  std::vector<T> out(box.count(), T{0});
  if (first > last) return out;
  for (int z = std::max(0, box.low[2]); z <= std::min(n[2] - 1, box.high[2]); ++z)
    for (int y = std::max(0, box.low[1]); y <= std::min(n[1] - 1, box.high[1]); ++y) {
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(cells.at(first, y, z));
      std::copy(row, row + (last - first + 1),
                out.begin() + static_cast<std::ptrdiff_t>(box.at({first, y, z})));
    }
  return out;
}

}  // namespace handlebody
