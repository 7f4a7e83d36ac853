#pragma once
// How long the edges of a front may be before what is hollow in finished objects.

#include <array>
#include <unordered_map>
#include <vector>

#include "core/evolution/wall_surface.h"

namespace handlebody {

//! A face of the longest edges that the mesh has, 1.4 / sqrt(3) (its circumradius), lies within its corners
//! on a sphere around a point by as much as this makes of the radius. In edge lengths.
inline constexpr double kCircumradius = 0.81;

//! Edge lengths in parts of the target: below 1 before an object that is so hollow that faces between
//! corners that rest on it would stay away from it. From place to place it changes by no more than
//! SizeField::kGrade, so that what moves a little asks for little else.
class HollowSizes {
 public:
  //! `edgeLength`: the target, `voxel`: mean size, both mm.
  HollowSizes(const WallSurface& objects, double edgeLength, double voxel);
  //! At a world point, mm.
  double at(const Vec3& world) const;

 private:
  struct Place {
    Vec3 where;  // mm
    double part;
  };
  using Cell = std::array<int, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const;
  };
  Cell cellOf(const Vec3& world) const;

  double edgeLength_, reach_;                                  // mm: beyond it no place asks for anything
  std::unordered_map<Cell, std::vector<Place>, Hash> places_;  // by cells as wide as the reach
};

}  // namespace handlebody
