#pragma once
// Meshes with edges of very different lengths.

#include <cmath>

#include "core/mesh/mesh.h"

namespace handlebody::zoo {

//! A sphere of radius 1 about the origin drawn together on one side: the longest edges are some twelve times
//! as long as the shortest ones, and change slowly from place to place.
inline TriangleSoup graded(TriangleSoup s) {
  for (Vec3& p : s.points) {
    const double z = 2 * std::pow(0.5 * (p.z() + 1), 0.35) - 1, around = std::hypot(p.x(), p.y());
    const double in = std::sqrt(std::max(0.0, 1 - z * z));
    p = around > 0 ? Vec3(p.x() * in / around, p.y() * in / around, z) : Vec3(0, 0, z);
  }
  return s;
}

}  // namespace handlebody::zoo
