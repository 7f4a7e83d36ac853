#include "core/io/meshes/mesh_io.h"
#include "tests/io/io_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

Grid roomyGrid() {
  Grid grid = obliqueGrid();
  grid.size = {61, 37, 23};
  return grid;
}

Vec3 centreOf(const Grid& grid) {
  return grid.toWorld(Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1) / 2);
}

template <typename F>
void forEachVoxel(const Volume& label, F&& f) {
  const auto* at = label.data<std::uint8_t>();
  for (int k = 0; k < label.grid.size[2]; ++k)
    for (int j = 0; j < label.grid.size[1]; ++j)
      for (int i = 0; i < label.grid.size[0]; ++i) f(Vec3(i, j, k), *at++ != 0);
}

TriangleSoup box(const Vec3& low, const Vec3& high) {
  TriangleSoup s;
  for (int c = 0; c < 8; ++c)
    s.points.push_back(
        Vec3(c & 1 ? high.x() : low.x(), c & 2 ? high.y() : low.y(), c & 4 ? high.z() : low.z()));
  s.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return s;
}

void append(TriangleSoup& to, const TriangleSoup& from, bool inwards) {
  const int base = static_cast<int>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (const Triangle& t : from.triangles)
    to.triangles.push_back(inwards ? Triangle{base + t[0], base + t[2], base + t[1]}
                                   : Triangle{base + t[0], base + t[1], base + t[2]});
}

}  // namespace

TEST_CASE("a rasterized sphere holds exactly the voxel centres inside it, up to its facets") {
  const Grid grid = roomyGrid();
  const double radius = 13.7;
  const Vec3 centre = centreOf(grid) + Vec3(0.11, -0.07, 0.23);
  const TriangleSoup mesh = sphere(centre, radius, 6);
  const Volume label = rasterize(mesh, grid);
  // Facets lie between the sphere of their midpoints and the sphere of their vertices.
  const double inner = radius * (1 - 2e-3);
  forEachVoxel(label, [&](const Vec3& index, bool inside) {
    const double r = (grid.toWorld(index) - centre).norm();
    if (r < inner) REQUIRE(inside);
    if (r > radius) REQUIRE_FALSE(inside);
  });
}

TEST_CASE("a rasterized sphere has the analytic volume") {
  Grid grid = obliqueGrid();
  grid.size = {120, 120, 120};
  grid.spacing = Vec3(0.1, 0.1, 0.1);
  const double radius = 5;
  const Volume label = rasterize(sphere(centreOf(grid), radius, 6), grid);
  double volume = 0;
  forEachVoxel(label, [&](const Vec3&, bool inside) { volume += inside ? grid.voxelVolume() : 0; });
  // 31,400 surface voxels err by half a voxel each at most, and mostly cancel: 0.1 % is ten times what is
  // left.
  CHECK(volume == Approx(4.0 / 3 * M_PI * radius * radius * radius).epsilon(1e-3));
}

TEST_CASE("rasterize agrees with the winding number, with a cavity and a second component") {
  const Grid grid = roomyGrid();
  TriangleSoup mesh = sphere(centreOf(grid), 11, 3);
  append(mesh, sphere(centreOf(grid) + Vec3(1, 2, -1), 5, 2), true);
  append(mesh, sphere(centreOf(grid) + Vec3(0.5, 2, -1), 2, 1), false);
  const Volume label = rasterize(mesh, grid);
  int count = 0;
  forEachVoxel(label, [&](const Vec3& index, bool inside) {
    if (static_cast<int>(index.x() + 3 * index.y() + 7 * index.z()) % 5 != 0) return;
    count += inside;
    REQUIRE((windingNumber(mesh, grid.toWorld(index)) > 0.5) == inside);
  });
  CHECK(count > 100);
}

TEST_CASE("lines through vertices, edges and within faces leave no streaks") {
  Grid grid;
  grid.size = {12, 12, 12};
  // All faces on voxel centres: the half-open rule takes each centre on a lower face, none on an upper one,
  // or the other way round along y and z; never a streak.
  const Volume label = rasterize(box(Vec3(2, 3, 4), Vec3(8, 9, 10)), grid);
  int count = 0;
  forEachVoxel(label, [&](const Vec3& p, bool inside) {
    count += inside;
    const bool within = p.x() > 2 && p.x() < 8 && p.y() > 3 && p.y() < 9 && p.z() > 4 && p.z() < 10;
    const bool outside = p.x() < 2 || p.x() > 8 || p.y() < 3 || p.y() > 9 || p.z() < 4 || p.z() > 10;
    if (within) REQUIRE(inside);
    if (outside) REQUIRE_FALSE(inside);
  });
  CHECK(count == 6 * 6 * 6);
  // An octahedron with its vertices and edges on grid lines.
  const Volume octahedron = rasterize(sphere(Vec3(6, 6, 6), 4, 0), grid);
  forEachVoxel(octahedron, [&](const Vec3& p, bool inside) {
    const double norm = (p - Vec3(6, 6, 6)).cwiseAbs().sum();
    if (norm < 4 - 1e-9) REQUIRE(inside);
    if (norm > 4 + 1e-9) REQUIRE_FALSE(inside);
  });
}

TEST_CASE("a mesh that leaves the grid is cut at its faces") {
  Grid grid;
  grid.size = {10, 10, 10};
  const Volume all = rasterize(box(Vec3(-5, -5, -5), Vec3(30, 30, 30)), grid);
  forEachVoxel(all, [](const Vec3&, bool inside) { REQUIRE(inside); });
  const Volume none = rasterize(box(Vec3(-5, -5, -5), Vec3(-1, 30, 30)), grid);
  forEachVoxel(none, [](const Vec3&, bool inside) { REQUIRE_FALSE(inside); });
  const Volume half = rasterize(sphere(Vec3(0, 4.5, 4.5), 3, 4), grid);
  forEachVoxel(half, [](const Vec3& p, bool inside) {
    const double r = (p - Vec3(0, 4.5, 4.5)).norm();
    if (r < 2.95) REQUIRE(inside);
    if (r > 3) REQUIRE_FALSE(inside);
  });
}
