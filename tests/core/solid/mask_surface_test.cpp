#include "core/solid/mask_surface.h"

#include <numeric>

#include "core/collision/certify.h"
#include "core/errors.h"
#include "tests/core/solid/voxel_topology.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

void requireSurfaceOf(const Mask& mask) {
  const VoxelTopology counted = voxelTopology(mask);
  const TriangleSoup surface = maskSurface(mask);
  if (counted.components == 0) {
    REQUIRE(surface.triangles.empty());
    return;
  }
  const Certificate c = certify(surface);
  REQUIRE(c.boundsBody());
  REQUIRE(c.cavities == counted.cavities);
  REQUIRE(c.components == counted.components + counted.cavities);
  REQUIRE(std::accumulate(c.genus.begin(), c.genus.end(), 0) == counted.tunnels);
}

Mask box(int nx, int ny, int nz) {
  Mask mask;
  mask.grid.size = {nx, ny, nz};
  mask.inside.assign(mask.grid.voxelCount(), 1);
  return mask;
}

}  // namespace

TEST_CASE("each of the 256 cells has a certified surface with the topology of its voxels", "[solid]") {
  for (int inside = 0; inside < 256; ++inside) {
    INFO(inside);
    Mask mask = box(2, 2, 2);
    for (std::size_t corner = 0; corner < 8; ++corner) mask.inside[corner] = inside >> corner & 1;
    requireSurfaceOf(mask);
  }
}

TEST_CASE("random masks have certified surfaces with the topology of their voxels", "[solid]") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    INFO(seed);
    const int n = 3 + static_cast<int>(seed % 6);
    Mask mask = randomMask({n, n + 1, n + 2}, 0.1 + 0.1 * (seed % 9), seed);
    if (seed % 2 == 1) makeOblique(mask.grid);
    requireSurfaceOf(mask);
  }
}

TEST_CASE("two voids at the ends of a cell's diagonal are one, and the object around them a ring",
          "[solid]") {
  Mask mask = box(2, 2, 2);
  mask.inside[0] = mask.inside[7] = 0;
  CHECK(voxelTopology(mask) == VoxelTopology{1, 0, 1});
  requireSurfaceOf(mask);
}

TEST_CASE("a single voxel is an octahedron of a sixth of its volume", "[solid]") {
  Mask mask = box(1, 1, 1);
  mask.grid.spacing = Vec3(1, 2, 3);
  const Certificate c = certify(maskSurface(mask));
  CHECK(c.faces == 8);
  CHECK(c.volume == Approx(1.0));  // 6 mm³ / 6
}

TEST_CASE("a block's surface runs through the sides of its voxels", "[solid]") {
  const TriangleSoup surface = maskSurface(box(5, 4, 3));
  Vec3 low = surface.points[0], high = low;
  for (const Vec3& p : surface.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  CHECK(low == Vec3(-0.5, -0.5, -0.5));
  CHECK(high == Vec3(4.5, 3.5, 2.5));
  // Bevelled at 45° along the edges: there and at the corners half, and five sixths, of a voxel's share is
  // missing. The prisms along an edge have a cross-section of 1/8, the corner pieces are of 1/2³ - 1/48.
  const double corners = 8 * (1.0 / 8 - 1.0 / 48);
  CHECK(certify(surface).volume == Approx(60 - 4 * (4 + 3 + 2) / 8.0 - corners));
}

TEST_CASE("a surface of too many triangles is refused", "[solid]") {
  CHECK_THROWS_AS(maskSurface(randomMask({20, 20, 20}, 0.5, 1), 1000), InputError);
  CHECK_NOTHROW(maskSurface(box(5, 5, 5), 1000));
}

TEST_CASE("a mask keeps the object's box and takes voxels beyond it as outside", "[solid]") {
  void* buffer = nullptr;
  Grid grid;
  grid.size = {6, 7, 8};
  makeOblique(grid);
  const Volume labels = makeVolume(grid, VoxelType::int16, &buffer);
  auto* v = static_cast<std::int16_t*>(buffer);
  v[2 + 6 * (3 + 7 * 4)] = 5;
  v[4 + 6 * (3 + 7 * 5)] = 5;
  v[0] = -1;
  const Mask mask = maskOf(labels, 5);
  CHECK(mask.grid.size == std::array<int, 3>{3, 1, 2});
  CHECK(mask.count() == 2);
  CHECK(mask.holds(grid.toWorld(Vec3(2, 3, 4))));
  CHECK(mask.holds(grid.toWorld(Vec3(4.4, 3.4, 4.6))));
  CHECK_FALSE(mask.holds(grid.toWorld(Vec3(2, 3, 5))));
  CHECK_FALSE(mask.holds(grid.toWorld(Vec3(2, 2, 4))));
  CHECK(maskOf(labels, std::nullopt).count() == 3);
  CHECK(maskOf(labels, 4).count() == 0);
  CHECK(maskSurface(maskOf(labels, 4)).triangles.empty());
}
