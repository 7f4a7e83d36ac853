#pragma once
// Label maps of bodies that are given by their distance, and grids to draw them on.

#include <Eigen/Geometry>

#include "core/solid/mask.h"

namespace handlebody::testing {

//! The label map of what is at a negative distance of a body.
template <typename Body>
Mask draw(Grid grid, Body&& distance) {
  Mask mask;
  mask.grid = grid;
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x)
        mask.inside.push_back(distance(grid.toWorld(Vec3(x, y, z))) < 0 ? 1 : 0);
  return mask;
}

inline auto ball(const Vec3& centre, double radius) {
  return [=](const Vec3& p) { return (p - centre).norm() - radius; };
}

inline Grid gridAround(int n, double spacing) {
  Grid grid;
  grid.size = {n, n, n};
  grid.spacing.setConstant(spacing);
  grid.origin.setConstant(-(n - 1) * spacing / 2);
  return grid;
}

inline Grid obliqueGrid() {
  Grid grid;
  grid.size = {22, 30, 14};
  grid.spacing = Vec3(1.1, 0.8, 1.9);
  grid.direction =
      (Eigen::AngleAxisd(0.5, Vec3::UnitY()) * Eigen::AngleAxisd(2.4, Vec3::UnitZ())).toRotationMatrix();
  grid.direction.col(2) *= -1;  // left-handed, as some files are
  grid.origin = -(grid.direction * (0.5 * grid.spacing.cwiseProduct(Vec3(21, 29, 13))));
  return grid;
}

}  // namespace handlebody::testing
