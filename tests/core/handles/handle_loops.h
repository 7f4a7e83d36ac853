#pragma once
// Loops for handles to join.

#include <cmath>
#include <random>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody::test {

using Sizes = std::vector<int>;
using Loops = std::vector<std::vector<Vec3>>;

inline Loops randomLoops(const Sizes& sizes, unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  Loops loops;
  for (const int size : sizes) {
    std::vector<Vec3>& loop = loops.emplace_back();
    for (int i = 0; i < size; ++i) {
      const double x = coordinate(), y = coordinate();
      loop.emplace_back(x, y, coordinate());
    }
  }
  return loops;
}

//! Rings that face a common middle from the sides of a regular polygon, as fronts that meet in a node.
inline Loops facingRings(const Sizes& sizes, double noise, unsigned seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] { return noise * (static_cast<double>(random()) / 2147483648.0 - 1); };
  Loops loops;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const double turn = 2 * M_PI * static_cast<double>(k) / static_cast<double>(sizes.size());
    const Vec3 out(std::cos(turn), std::sin(turn), 0), side(-std::sin(turn), std::cos(turn), 0);
    std::vector<Vec3>& loop = loops.emplace_back();
    const double radius = sizes[k] / (2 * M_PI);
    for (int i = 0; i < sizes[k]; ++i) {
      const double u = 2 * M_PI * i / sizes[k];
      const Vec3 ring = std::cos(u) * side - std::sin(u) * Vec3::UnitZ();
      const double x = coordinate(), y = coordinate();
      loop.push_back(radius * (1.3 * out + ring) + Vec3(x, y, coordinate()));
    }
  }
  return loops;
}

}  // namespace handlebody::test
