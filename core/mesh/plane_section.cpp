#include "core/mesh/plane_section.h"

namespace handlebody {
namespace {

//! From the lower corner always, so that both triangles of an edge get the same point.
Vec3 crossing(const Vec3& below, const Vec3& above, double hBelow, double hAbove) {
  return below + (hBelow / (hBelow - hAbove)) * (above - below);
}

}  // namespace

void planeSection(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const Vec3& normal,
                  double offset, std::vector<std::array<Vec3, 2>>& section, std::vector<int>* crossed) {
  section.clear();
  if (crossed) crossed->clear();
  std::vector<double> heights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) heights[i] = normal.dot(points[i]) - offset;
  for (const Triangle& t : triangles) {
    const bool above[3] = {heights[t[0]] >= 0, heights[t[1]] >= 0, heights[t[2]] >= 0};
    if (above[0] == above[1] && above[1] == above[2]) continue;
    std::array<Vec3, 2> ends;
    std::size_t count = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3;
      if (above[c] == above[d]) continue;
      const int low = above[c] ? t[d] : t[c], high = above[c] ? t[c] : t[d];
      ends[count++] = crossing(points[low], points[high], heights[low], heights[high]);
    }
    section.push_back(ends);
    if (crossed) crossed->push_back(static_cast<int>(&t - triangles.data()));
  }
}

}  // namespace handlebody
