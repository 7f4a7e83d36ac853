// Walls piece by piece: which of them a surface touches, and which it encloses.
#include "core/evolution/wall_pieces.h"

#include <algorithm>

#include "core/indices.h"
#include "core/mesh/shapes.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

const Grid kGrid = cubicGrid(41);

//! Around the middle of the grid, 10 mm.
Mesh ball() { return Mesh(icosphere(kMiddle, 10, 1.5)); }

std::size_t voxel(int x, int y, int z) { return (idx(z) * 41 + idx(y)) * 41 + idx(x); }

WallMap mapOf(const std::vector<std::size_t>& voxels) {
  std::vector<bool> flags(41 * 41 * 41, false);
  for (const std::size_t v : voxels) flags[v] = true;
  return {"walls.nrrd", {}, std::make_shared<const std::vector<bool>>(std::move(flags))};
}

std::vector<std::size_t> voxelsOf(const WallList& walls) {
  std::vector<std::size_t> out;
  const std::vector<bool>& flags = *walls.map->voxels;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) out.push_back(i);
  return out;
}

WallObject objectAt(const Vec3& centre, double radius) {
  return {"object", std::make_shared<const TriangleSoup>(icosphere(centre, radius, 1))};
}

Walls made(const WallList& list) { return {list, kGrid, 1.5, 0.4}; }

//! One wall of each kind, all in the same place; the map has the voxels of a small plate.
struct OneOfEach {
  WallList ball, disc, object, map;
  std::vector<WallList> all() const { return {ball, disc, object, map}; }
};
OneOfEach oneOfEachAt(const Vec3& place) {
  OneOfEach out;
  out.ball.balls.push_back({place, 1});
  out.disc.discs.push_back({place, Vec3(0, 1, 0), 1.5});
  out.object.objects.push_back(objectAt(place, 1.5));
  const int x = static_cast<int>(place.x()), y = static_cast<int>(place.y()), z = static_cast<int>(place.z());
  out.map.map = mapOf({voxel(x, y, z), voxel(x + 1, y, z)});
  return out;
}

}  // namespace

TEST_CASE("walls come apart into a ball, a disc, an object each and the voxels that hang together",
          "[walls]") {
  WallList list;
  list.balls = {{kMiddle, 2}, {kMiddle + Vec3(5, 0, 0), 3}};
  list.discs = {{kMiddle, Vec3(1, 0, 0), 4}};
  list.objects = {objectAt(kMiddle + Vec3(0, 9, 0), 2)};
  // Two voxels that share a corner, one two voxels away from them, one in the grid's last corner.
  const std::vector<std::size_t> pair{voxel(3, 3, 3), voxel(4, 4, 4)};
  list.map = mapOf({pair[0], pair[1], voxel(6, 4, 4), voxel(40, 40, 40)});
  const std::vector<WallList> pieces = piecesOf(list, kGrid);
  REQUIRE(pieces.size() == 7);
  CHECK(pieces[0].balls == std::vector{list.balls[0]});
  CHECK(pieces[1].balls == std::vector{list.balls[1]});
  CHECK(pieces[2].discs == list.discs);
  CHECK(pieces[3].objects == list.objects);
  CHECK(voxelsOf(pieces[4]) == pair);
  CHECK(voxelsOf(pieces[5]) == std::vector{voxel(6, 4, 4)});
  CHECK(voxelsOf(pieces[6]) == std::vector{voxel(40, 40, 40)});
  CHECK(pieces[4].map->path == "walls.nrrd");
  const WallList whole = together(pieces);
  CHECK(whole.balls == list.balls);
  CHECK(whole.discs == list.discs);
  CHECK(whole.objects == list.objects);
  CHECK(voxelsOf(whole) == voxelsOf(list));
  CHECK(piecesOf({}, kGrid).empty());
  CHECK(together({}).empty());
}

TEST_CASE("what is new in walls is what the known ones do not hold, of each kind", "[walls]") {
  const OneOfEach old = oneOfEachAt(kMiddle), fresh = oneOfEachAt(kMiddle + Vec3(6, 0, 0));
  const WallList before = together(old.all());
  WallList now = together({together(old.all()), together(fresh.all())});
  CHECK(without(before, before).empty());
  CHECK(without(before, {}) == before);
  const WallList added = without(now, before);
  CHECK(added.balls == fresh.ball.balls);
  CHECK(added.discs == fresh.disc.discs);
  CHECK(added.objects == fresh.object.objects);
  CHECK(voxelsOf(added) == voxelsOf(fresh.map));
  now.map = old.map.map;
  now.map->path = "another.nrrd";  // with the same voxels: nothing is new
  CHECK_FALSE(without(now, before).map.has_value());
}

TEST_CASE("a point of a piece lies in it", "[walls]") {
  const OneOfEach walls = oneOfEachAt(kMiddle);
  CHECK(placeOf(walls.ball, kGrid) == kMiddle);
  CHECK(placeOf(walls.disc, kGrid) == kMiddle);
  CHECK(placeOf(walls.object, kGrid) == walls.object.objects[0].mesh->points[0]);
  CHECK(placeOf(walls.map, kGrid) == kMiddle);
}

TEST_CASE("a surface touches the walls it passes, encloses those within, and knows nothing of the others",
          "[walls]") {
  const Mesh mesh = ball();
  const OneOfEach passed = oneOfEachAt(kMiddle + Vec3(10, 0, 0)), within = oneOfEachAt(kMiddle),
                  beyond = oneOfEachAt(kMiddle - Vec3(0, 17, 0));
  for (std::size_t kind = 0; kind < 4; ++kind) {
    INFO("kind " << kind);
    const WallList list = together({passed.all()[kind], within.all()[kind], beyond.all()[kind]});
    const Walls walls = made(list);
    const Occupied occupied = findOccupied(mesh, walls);
    REQUIRE(occupied.touched.size() == 1);
    REQUIRE(occupied.enclosed.size() == 1);
    CHECK(without(passed.all()[kind], occupied.touched[0]).empty());
    CHECK(without(within.all()[kind], occupied.enclosed[0]).empty());
    CHECK(touchesAny(mesh, walls));
    CHECK_FALSE(touchesAny(mesh, made(together({within.all()[kind], beyond.all()[kind]}))));
    CHECK(enclosesAny(mesh, walls, kMiddle, 3));
    CHECK_FALSE(enclosesAny(mesh, walls, kMiddle - Vec3(0, 17, 0), 3));
  }
}

TEST_CASE("a hollow surface encloses what lies in its wall, not what lies in the cavity", "[walls]") {
  TriangleSoup shell = icosphere(kMiddle, 10, 1.5), cavity = icosphere(kMiddle, 5, 1);
  const int first = static_cast<int>(shell.points.size());
  shell.points.insert(shell.points.end(), cavity.points.begin(), cavity.points.end());
  for (const Triangle& t : cavity.triangles)
    shell.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  const Mesh mesh(shell);
  CHECK(enclosesAny(mesh, {kMiddle + Vec3(0, 0, 7.5)}));
  CHECK_FALSE(enclosesAny(mesh, {kMiddle, kMiddle + Vec3(0, 0, 12), Vec3(0, 0, 0)}));
  CHECK_FALSE(enclosesAny(mesh, {}));
}
