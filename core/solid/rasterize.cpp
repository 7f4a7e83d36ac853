// A closed mesh to a label map: crossings of the mesh with the grid's x lines, sorted, filled in pairs.

#include "core/solid/rasterize.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/cancellation.h"

namespace handlebody {
namespace {

struct Crossing {
  std::size_t line;  //!< j + size_y · k
  double x;          //!< continuous voxel index
  bool operator<(const Crossing& o) const { return line != o.line ? line < o.line : x < o.x; }
};

bool before(const Vec3& a, const Vec3& b) {
  if (a.z() != b.z()) return a.z() < b.z();
  if (a.y() != b.y()) return a.y() < b.y();
  return a.x() < b.x();
}

//! Whether the ray from (y, z) towards larger y crosses the projection of an edge. Half open in z, and worked
//! out from the edge's own ends in a fixed order: both triangles at an edge get the same answer to the last
//! bit. So every line meets a closed mesh an even number of times, also through vertices and edges.
bool rayCrosses(const Vec3& p, const Vec3& q, double y, double z) {
  if ((p.z() > z) == (q.z() > z)) return false;
  const Vec3& a = before(p, q) ? p : q;
  const Vec3& b = before(p, q) ? q : p;
  const double crossing = a.y() + (z - a.z()) * ((b.y() - a.y()) / (b.z() - a.z()));
  // Kept within the edge: lines beyond the triangle's extent are not asked.
  return std::clamp(crossing, std::min(a.y(), b.y()), std::max(a.y(), b.y())) > y;
}

//! x where the line through (y, z) meets the triangle's plane, kept within the triangle's extent (a triangle
//! seen edge-on has no well-defined one).
double crossingX(const Vec3& a, const Vec3& b, const Vec3& c, double y, double z) {
  const double low = std::min({a.x(), b.x(), c.x()}), high = std::max({a.x(), b.x(), c.x()});
  const double area = (b.y() - a.y()) * (c.z() - a.z()) - (b.z() - a.z()) * (c.y() - a.y());
  const double u = ((y - a.y()) * (c.z() - a.z()) - (z - a.z()) * (c.y() - a.y())) / area;
  const double v = ((b.y() - a.y()) * (z - a.z()) - (b.z() - a.z()) * (y - a.y())) / area;
  const double x = a.x() + u * (b.x() - a.x()) + v * (c.x() - a.x());
  return std::isfinite(x) ? std::clamp(x, low, high) : low;
}

//! First grid line at or after the lower end and last one at or before the upper end, within 0 … n-1.
struct Range {
  int first, last;
  Range(double low, double high, int n)
      : first(static_cast<int>(std::ceil(std::clamp(low, 0.0, static_cast<double>(n))))),
        last(static_cast<int>(std::floor(std::clamp(high, -1.0, n - 1.0)))) {}
};

void addCrossings(const Vec3& a, const Vec3& b, const Vec3& c, const Grid& grid,
                  std::vector<Crossing>& crossings) {
  const Range ks(std::min({a.z(), b.z(), c.z()}), std::max({a.z(), b.z(), c.z()}), grid.size[2]);
  const Range js(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}), grid.size[1]);
  for (int k = ks.first; k <= ks.last; ++k)
    for (int j = js.first; j <= js.last; ++j)
      if (rayCrosses(a, b, j, k) != (rayCrosses(b, c, j, k) != rayCrosses(c, a, j, k)))
        crossings.push_back({static_cast<std::size_t>(j) +
                                 static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(k),
                             crossingX(a, b, c, j, k)});
}

}  // namespace

Volume rasterize(const TriangleSoup& mesh, const Grid& grid) {
  std::vector<Vec3> points;
  points.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) points.push_back(grid.toIndex(p));
  const auto at = [&](int v) -> const Vec3& { return points[v]; };
  std::vector<Crossing> crossings;
  for (const Triangle& t : mesh.triangles) {
    giveUpIfCancelled();
    addCrossings(at(t[0]), at(t[1]), at(t[2]), grid, crossings);
  }
  std::sort(crossings.begin(), crossings.end());

  void* buffer = nullptr;
  Volume label = makeVolume(grid, VoxelType::uint8, &buffer);
  auto* voxels = static_cast<std::uint8_t*>(buffer);
  // A closed mesh crosses each line in pairs; a centre on the surface belongs to the interval that begins
  // there.
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    if (crossings[i].line != crossings[i + 1].line) continue;
    const double n = grid.size[0];
    const auto from = static_cast<std::size_t>(std::ceil(std::clamp(crossings[i].x, 0.0, n)));
    const auto to = static_cast<std::size_t>(std::ceil(std::clamp(crossings[i + 1].x, 0.0, n)));
    std::uint8_t* row = voxels + crossings[i].line * static_cast<std::size_t>(grid.size[0]);
    std::fill(row + from, row + std::max(from, to), std::uint8_t{1});
    ++i;
  }
  return label;
}

}  // namespace handlebody
