#pragma once
// A box of a volume in cells of one or several voxels: what is searched around a click.

#include <array>
#include <cstdint>
#include <vector>

#include "core/object/policy.h"
#include "core/volume/field_of_view.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Which voxels of a volume a grid of cells covers.
struct CellGrid {
  Grid grid;                           //!< of the cells: an index is that of a cell
  std::array<int, 3> low{0, 0, 0};     //!< first voxel
  std::array<int, 3> factor{1, 1, 1};  //!< voxels per cell along each axis
  //! Sides of the box beyond which the volume goes on, per axis: below, above.
  std::array<std::array<bool, 2>, 3> goesOn{};

  std::size_t count() const { return grid.voxelCount(); }
  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(grid.size[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(grid.size[0]) +
           static_cast<std::size_t>(x);
  }
  std::size_t at(const std::array<int, 3>& c) const { return at(c[0], c[1], c[2]); }
  //! The cell of a number.
  std::array<int, 3> cellOf(std::size_t number) const {
    const std::size_t nx = static_cast<std::size_t>(grid.size[0]),
                      ny = static_cast<std::size_t>(grid.size[1]);
    return {static_cast<int>(number % nx), static_cast<int>(number / nx % ny),
            static_cast<int>(number / (nx * ny))};
  }
  //! The cell that holds a point (mm), moved to the nearest cell if it lies outside.
  std::array<int, 3> nearest(const Vec3& world) const;
  bool contains(const Vec3& world) const { return grid.contains(grid.toIndex(world)); }
};
//! The same cells of one volume.
bool isSame(const CellGrid& a, const CellGrid& b);

//! The voxels within `reach` (mm) around a point, in the finest cells that are no more than `most`: the axis
//! of the finest cells is made coarser first.
CellGrid cellsAround(const Grid& volume, const Vec3& centre, double reach, std::size_t most);
//! The box around several such boxes.
struct Reach {
  Vec3 centre;
  double reach;  //!< mm
};
CellGrid cellsAround(const Grid& volume, const std::vector<Reach>& boxes, std::size_t most);

//! The means of the voxels of each cell, and where there is no image.
struct CellImage {
  CellGrid cells;
  std::vector<float> values;          //!< intensities
  std::vector<std::uint8_t> padding;  //!< 1 = no image
};
//! `view` may be null.
CellImage makeCells(const Volume& volume, const CellGrid& cells, const FieldOfView* view);

//! Trilinear between the centres of a grid, at a continuous index; beyond the outermost as there. All values
//! are finite.
double interpolated(const Grid& grid, const std::vector<float>& values, const Vec3& index);

//! Gaussian, standard deviation in mm; cells beyond the border count as those of the border.
std::vector<float> smoothed(const CellGrid& cells, std::vector<float> values, double sigma);

}  // namespace handlebody
