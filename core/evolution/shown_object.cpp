#include "core/evolution/shown_object.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handlebody {

namespace {

constexpr double kApart = 0.5;  // edge lengths between the points of the grid
// Lines are looked along a little beside the grid's points: voxels and corners of meshes often lie alike.
constexpr double kBesideX = 1.37e-4, kBesideY = 0.91e-4;
constexpr std::size_t kSampleEvery = 97;

Grid coarseGrid(const Grid& voxels, double apart) {
  Grid grid = voxels;
  for (int a = 0; a < 3; ++a) {
    const int step = std::max(1, static_cast<int>(apart / voxels.spacing[a]));
    grid.size[a] = (voxels.size[a] - 1) / step + 1;
    grid.spacing[a] *= step;
  }
  return grid;
}

using Point = std::array<int, 3>;

bool isIn(const Grid& grid, const Point& p) {
  for (std::size_t a = 0; a < 3; ++a)
    if (p[a] < 0 || p[a] >= grid.size[a]) return false;
  return true;
}

Vec3 worldOf(const Grid& grid, const Point& p) { return grid.toWorld(Vec3(p[0], p[1], p[2])); }

}  // namespace

ShownObject::ShownObject(const ObjectImage& image, const std::vector<Vec3>& places, double edgeLength)
    : grid_(coarseGrid(image.volume().grid(), kApart * edgeLength)), inside_(grid_.voxelCount(), false) {
  flood(image, places);
}

void ShownObject::flood(const ObjectImage& image, const std::vector<Vec3>& places) {
  std::vector<Point> front;
  const auto visit = [&](const Point& p) {
    if (!isIn(grid_, p) || holds(p[0], p[1], p[2]) || image.inside(worldOf(grid_, p)) <= 0) return;
    inside_[at(p[0], p[1], p[2])] = true;
    front.push_back(p);
  };
  // All eight points around a place: a click may lie in a part thinner than the grid.
  for (const Vec3& place : places) {
    if (image.inside(place) <= 0) continue;
    const Vec3 index = grid_.toIndex(place);
    for (int corner = 0; corner < 8; ++corner) {
      Point p;
      for (int a = 0; a < 3; ++a) p[a] = static_cast<int>(std::floor(index[a])) + ((corner >> a) & 1);
      visit(p);
    }
  }
  while (!front.empty()) {
    const Point p = front.back();
    front.pop_back();
    for (std::size_t a = 0; a < 3; ++a)
      for (const int step : {-1, 1}) {
        Point q = p;
        q[a] += step;
        visit(q);
      }
  }
}

namespace {

//! Where a line of the grid along its third axis meets a component.
struct Crossing {
  int component, i, j;
  double k;
  auto operator<=>(const Crossing&) const = default;
};

//! All lines through a triangle, in continuous indices.
void cross(const std::array<Vec3, 3>& t, int component, const Grid& grid, std::vector<Crossing>& out) {
  const auto side = [](const Vec3& a, const Vec3& b, double x, double y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  };
  const auto [lowX, highX] = std::minmax({t[0][0], t[1][0], t[2][0]});
  const auto [lowY, highY] = std::minmax({t[0][1], t[1][1], t[2][1]});
  const int fromX = std::max(0, static_cast<int>(std::ceil(lowX - kBesideX)));
  const int fromY = std::max(0, static_cast<int>(std::ceil(lowY - kBesideY)));
  for (int j = fromY; j < grid.size[1] && j + kBesideY <= highY; ++j)
    for (int i = fromX; i < grid.size[0] && i + kBesideX <= highX; ++i) {
      const double x = i + kBesideX, y = j + kBesideY;
      const double a = side(t[1], t[2], x, y), b = side(t[2], t[0], x, y), c = side(t[0], t[1], x, y);
      if (!((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) || a + b + c == 0) continue;
      out.push_back({component, i, j, (a * t[0][2] + b * t[1][2] + c * t[2][2]) / (a + b + c)});
    }
}

std::vector<Crossing> crossingsOf(const Mesh& mesh, const Components& parts, const Grid& grid) {
  std::vector<Vec3> indices;
  for (const Vec3& p : mesh.positions()) indices.push_back(grid.toIndex(p));
  std::vector<Crossing> out;
  for (const Triangle& f : mesh.faces())
    if (f[0] >= 0) cross({indices[f[0]], indices[f[1]], indices[f[2]]}, parts.ofVertex[f[0]], grid, out);
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

std::vector<Enclosed> enclosedBy(const Mesh& mesh, const Components& parts, const ShownObject& object) {
  const Grid& grid = object.grid();
  std::vector<Enclosed> out(parts.vertices.size());
  const std::vector<Crossing> crossings = crossingsOf(mesh, parts, grid);
  std::size_t seen = 0;
  for (std::size_t c = 0; c + 1 < crossings.size(); ++c) {
    const Crossing &from = crossings[c], &to = crossings[c + 1];
    if (from.component != to.component || from.i != to.i || from.j != to.j) continue;
    Enclosed& e = out[from.component];
    const int last = std::min(grid.size[2] - 1, static_cast<int>(std::floor(to.k)));
    for (int k = std::max(0, static_cast<int>(std::ceil(from.k))); k <= last; ++k) {
      e.all += 1;
      if (!object.holds(from.i, from.j, k)) continue;
      e.common += 1;
      if (seen++ % kSampleEvery == 0) e.samples.push_back(worldOf(grid, {from.i, from.j, k}));
    }
    ++c;  // the next pair
  }
  return out;
}

}  // namespace handlebody
