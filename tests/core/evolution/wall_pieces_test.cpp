// Walls piece by piece: which of them a surface touches, and which it encloses.
#include "core/evolution/wall_pieces.h"

#include <algorithm>

#include "core/errors.h"
#include "core/evolution/wall_guard.h"
#include "core/indices.h"
#include "core/mesh/shapes.h"
#include "core/told_error.h"
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

WallList together(const std::vector<WallList>& walls) {
  WallList all;
  std::vector<std::size_t> voxels;
  for (const WallList& w : walls) {
    all.balls.insert(all.balls.end(), w.balls.begin(), w.balls.end());
    all.discs.insert(all.discs.end(), w.discs.begin(), w.discs.end());
    all.objects.insert(all.objects.end(), w.objects.begin(), w.objects.end());
    if (!w.map) continue;
    const std::vector<std::size_t> more = voxelsOf(w);
    voxels.insert(voxels.end(), more.begin(), more.end());
  }
  if (!voxels.empty()) all.map = mapOf(voxels);
  return all;
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

TEST_CASE("voxels of the map that share a corner are one piece, and two voxels away another one", "[walls]") {
  const std::size_t inside = voxel(29, 20, 20), across = voxel(30, 21, 20), apart = voxel(26, 20, 20),
                    corner = voxel(40, 40, 40);
  WallList list;
  list.map = mapOf({inside, across, apart, corner});
  const Occupied occupied = findOccupied(ball(), made(list));
  CHECK(voxelsOf(occupied.touched) == std::vector{inside, across});
  CHECK(voxelsOf(occupied.enclosed) == std::vector{apart});
  CHECK(occupied.touched.map->path == "walls.nrrd");
  CHECK(findOccupied(ball(), made({})).touched.empty());
}

TEST_CASE("a map of very many specks takes no more memory than one of few", "[walls]") {
  // A map of its own for each speck would be 20 GB.
  const int n = 201;
  const Grid grid = cubicGrid(n);
  const Vec3 middle = Vec3::Constant(100);
  std::vector<bool> flags(idx(n) * idx(n) * idx(n), false), within = flags;
  std::size_t specks = 0;
  for (int z = 0; z < n; z += 5)
    for (int y = 0; y < n; y += 5)
      for (int x = 0; x < n; x += 5) {
        const std::size_t i = (idx(z) * idx(n) + idx(y)) * idx(n) + idx(x);
        const double d = (Vec3(x, y, z) - middle).norm();
        flags[i] = d < 83 || d > 92;
        within[i] = d < 83;
        specks += within[i];
      }
  REQUIRE(specks > 15'000);
  WallList list;
  list.map = WallMap{"walls.nrrd", {}, std::make_shared<const std::vector<bool>>(std::move(flags)), {}};
  const Occupied occupied = findOccupied(Mesh(icosphere(middle, 88, 4)), Walls(list, grid, 4, 1));
  CHECK(occupied.touched.empty());
  CHECK(*occupied.enclosed.map->voxels == within);
}

TEST_CASE("the first place that is new is that of the first piece that is not wholly known", "[walls]") {
  const OneOfEach old = oneOfEachAt(kMiddle), fresh = oneOfEachAt(kMiddle + Vec3(6, 0, 0));
  const WallList known = together(old.all());
  CHECK_FALSE(placeOfFresh(known, known, kGrid));
  CHECK_FALSE(placeOfFresh({}, known, kGrid));
  CHECK(placeOfFresh(known, {}, kGrid) == kMiddle);
  for (const WallList& wall : fresh.all())
    CHECK(placeOfFresh(together({known, wall}), known, kGrid) == placeOf(wall, kGrid));
  // A piece that has become larger: its first voxel, also if that is known.
  WallList larger;
  larger.map = mapOf({voxel(3, 3, 3), voxel(20, 20, 20), voxel(21, 20, 20), voxel(22, 20, 20)});
  WallList before = old.map;
  before.map = mapOf({voxel(3, 3, 3), voxel(20, 20, 20), voxel(21, 20, 20)});
  CHECK(placeOfFresh(larger, before, kGrid) == kMiddle);
}

TEST_CASE("a new wall in the surface is refused also where one that it encloses is known", "[walls]") {
  const Vec3 place = kMiddle + Vec3(0, 5, 0);
  WallList known, both;
  known.map = mapOf({voxel(20, 20, 20)});
  both.map = mapOf({voxel(20, 20, 20), voxel(20, 25, 20)});
  WallGuard guard;
  guard.choose(known, kGrid, 1.5, 0.4);
  CHECK_NOTHROW(guard.putUp(ball(), known, false));
  guard.choose(both, kGrid, 1.5, 0.4);
  CHECK_THROWS_AS(guard.putUp(ball(), known, false), UsageError);
  // So it is where something else is touched, and all of the walls are looked at.
  WallList pushed = together({both, oneOfEachAt(kMiddle + Vec3(10, 0, 0)).ball});
  guard.choose(pushed, kGrid, 1.5, 0.4);
  try {
    guard.putUp(ball(), known, true);
    FAIL("it was not refused");
  } catch (const Told<UsageError>& refused) {
    CHECK(refused.finding().kind == FindingKind::wallWithin);
    CHECK(std::get<std::array<double, 3>>(*refused.finding().find("place")) == placeValue(place));
  }
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
    CHECK(without(passed.all()[kind], occupied.touched).empty());
    CHECK(without(occupied.touched, passed.all()[kind]).empty());
    CHECK(without(within.all()[kind], occupied.enclosed).empty());
    CHECK(without(occupied.enclosed, within.all()[kind]).empty());
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
