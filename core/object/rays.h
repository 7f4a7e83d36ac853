#pragma once
// Directions spread evenly over a sphere.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! Unit vectors, and which are neighbours: the vertices and edges of a divided icosahedron.
struct Rays {
  std::vector<Vec3> directions;
  std::vector<std::array<std::size_t, 2>> pairs;
  //! `spacing`: longest distance of neighbours on the unit sphere.
  explicit Rays(double spacing);
  //! The three nearest to a direction (of unit length) are among these; ascending.
  const std::vector<std::uint16_t>& near(const Vec3& direction) const;

 private:
  std::vector<std::vector<std::uint16_t>> near_;  // per square of a cube around the sphere
};

//! The three rays nearest to a direction, with weights that sum to 1, the nearer the more.
struct NearestRays {
  std::array<std::size_t, 3> ray{};
  std::array<double, 3> weight{};
};
//! `direction`: of unit length.
NearestRays nearestRays(const Rays& rays, const Vec3& direction);

}  // namespace handlebody
