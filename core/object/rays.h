#pragma once
// Directions spread evenly over a sphere.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! Unit vectors: the vertices of a divided icosahedron. `spacing`: longest distance of neighbours on the unit
//! sphere.
std::vector<Vec3> directionsOverSphere(double spacing);

//! Such directions, and which are neighbours.
struct Rays {
  std::vector<Vec3> directions;
  std::vector<std::array<std::size_t, 2>> pairs;
  explicit Rays(double spacing);
  //! Which of kSquareCount parts of the sphere holds a direction (of unit length).
  static std::size_t squareOf(const Vec3& direction);
  //! The three nearest to any direction in that part are among these; ascending.
  const std::vector<std::uint16_t>& near(std::size_t square) const { return near_[square]; }

  // Squares along a side of a cube around the sphere, and on all of them.
  static constexpr int kSquares = 16;
  static constexpr std::size_t kSquareCount = 6 * kSquares * kSquares;

 private:
  std::vector<std::vector<std::uint16_t>> near_;  // per square
};

//! The three rays nearest to a direction, with weights that sum to 1, the nearer the more.
struct NearestRays {
  std::array<std::size_t, 3> ray{};
  std::array<double, 3> weight{};
};
//! `direction`: of unit length.
NearestRays nearestRays(const Rays& rays, const Vec3& direction);

}  // namespace handlebody
