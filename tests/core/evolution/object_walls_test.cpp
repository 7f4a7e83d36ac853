// Finished objects as walls: the next one keeps clear of their meshes, and comes near.
#include <iostream>
#include <random>

#include "core/collision/body_contact.h"
#include "core/errors.h"
#include "core/evolution/size_field.h"
#include "core/evolution/wall_surface.h"
#include "core/evolution/walls.h"
#include "core/indices.h"
#include "core/mesh/shapes.h"
#include "tests/core/evolution/contour_support.h"
#include "tests/support/wall_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

WallObject object(const std::string& name, TriangleSoup mesh) {
  return {name, std::make_shared<const TriangleSoup>(std::move(mesh))};
}

Constraints behind(std::vector<WallObject> objects) { return {{{}, {}, std::move(objects)}, {}, {}}; }

//! The finest that a growth could want: ball A in the middle of a ball of 10 mm.
TriangleSoup ballInside(double radius, const Vec3& offset = Vec3::Zero()) {
  return icosphere(kMiddle + offset, radius, 1.5);
}

double bruteDistanceTo(const TriangleSoup& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return mesh.points[t[i]]; };
    least = std::min(least, bruteDistance(p, corner(0), corner(1), corner(2)));
  }
  return least;
}

//! Steps to the end. On the way no mesh may have a point in common with one of the objects.
TriangleSoup grownApart(ActiveContour& contour) {
  const std::vector<WallObject> objects = contour.constraints().walls.objects;
  const auto expectApart = [&](const TriangleSoup& mesh) {
    for (const WallObject& o : objects) REQUIRE(bodyContact(mesh, *o.mesh) == BodyContact::none);
  };
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    INFO("iteration " << contour.iteration());
    REQUIRE(contour.iteration() < 2000);
    const TriangleSoup mesh = contour.mesh().compact();
    REQUIRE(certify(mesh).passes());
    expectApart(mesh);
  }
  return contour.mesh().compact();
}

//! mm: the furthest that a vertex of `wall` which `counts` lies from the mesh.
template <typename F>
double widestGap(const TriangleSoup& wall, const TriangleSoup& mesh, F&& counts) {
  double widest = 0;
  for (const Vec3& p : wall.points)
    if (counts(p)) widest = std::max(widest, bruteDistanceTo(mesh, p));
  return widest;
}

bool always(const Vec3&) { return true; }

//! A ball with a cavity, a ball in that, and one beside.
struct ThreeBodies {
  TriangleSoup shell = hollow(ballInside(9), ballInside(4));
  TriangleSoup core = ballInside(2, Vec3(1, 0, 0)), beside = ballInside(1.5, Vec3(-11.5, 1, 0));
  std::mt19937 random{7};

  static TriangleSoup hollow(TriangleSoup mesh, const TriangleSoup& hole) {
    const int first = static_cast<int>(mesh.points.size());
    for (const Triangle& t : hole.triangles)
      mesh.triangles.push_back({t[0] + first, t[2] + first, t[1] + first});
    mesh.points.insert(mesh.points.end(), hole.points.begin(), hole.points.end());
    return mesh;
  }
  WallSurface surface(double cell) const {
    return {{object("shell", shell), object("core", core), object("beside", beside)}, cell};
  }
  Vec3 place() {
    std::uniform_real_distribution<double> u(-1, 1);
    const double x = u(random), y = u(random);
    return kMiddle + 14 * Vec3(x, y, u(random));
  }
  //! Indices of those that the triangle meets, by the detector of self-intersections.
  std::vector<int> metBy(const Vec3& a, const Vec3& b, const Vec3& c) const {
    std::vector<int> met;
    int index = 0;
    for (const TriangleSoup* mesh : {&shell, &core, &beside}) {
      TriangleSoup both = *mesh;
      const int first = static_cast<int>(both.points.size());
      both.points.insert(both.points.end(), {a, b, c});
      both.triangles.push_back({first, first + 1, first + 2});
      if (!findSelfIntersections(both.points, both.triangles).empty()) met.push_back(index);
      ++index;
    }
    return met;
  }
};

}  // namespace

TEST_CASE("where a place lies to a wall surface is what all of its triangles say", "[walls][objects]") {
  ThreeBodies bodies;
  const WallSurface surface = bodies.surface(GENERATE(0.3, 2.0, 50.0));
  REQUIRE(surface.parts().size() == 4);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = bodies.place();
    const double nearest = std::min({bruteDistanceTo(bodies.shell, p), bruteDistanceTo(bodies.core, p),
                                     bruteDistanceTo(bodies.beside, p)});
    if (nearest < 0.2) continue;  // the icospheres lie within the spheres by less
    const auto within = [&](const Vec3& offset, double r) { return (p - kMiddle - offset).norm() < r; };
    const bool inShell = within(Vec3::Zero(), 9) && !within(Vec3::Zero(), 4);
    const bool inCore = within(Vec3(1, 0, 0), 2), inBeside = within(Vec3(-11.5, 1, 0), 1.5);
    CHECK(surface.encloses(p) == (inShell || inCore || inBeside));
    CHECK(surface.objectAt(p) == (inShell ? 0 : inCore ? 1 : inBeside ? 2 : -1));
    const double expected = std::min(nearest, 1.7) * (surface.encloses(p) ? -1 : 1);
    CHECK(std::abs(surface.distance(p, 1.7) - expected) < 1e-9);
  }
}

TEST_CASE("which objects a triangle meets or comes near is what all of their triangles say",
          "[walls][objects]") {
  ThreeBodies bodies;
  const WallSurface surface = bodies.surface(GENERATE(0.3, 2.0, 50.0));
  int met = 0, near = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = bodies.place(), b = a + 0.1 * (bodies.place() - a), c = a + 0.1 * (bodies.place() - a);
    const std::vector<int> expected = bodies.metBy(a, b, c);
    std::vector<int> which;
    CHECK(surface.meets(a, b, c, &which) == !expected.empty());
    sortUnique(which);
    CHECK(which == expected);
    double least = 1e300;  // of a fine sampling: too large by a little
    for (int s = 0; s <= 8; ++s)
      for (int t = 0; s + t <= 8; ++t)
        least = std::min(least, std::abs(surface.distance(a + s / 8.0 * (b - a) + t / 8.0 * (c - a), 3)));
    if (expected.empty() && least > 0.7) CHECK(surface.clears(a, b, c, 0.3));
    if (least <= 0.3) CHECK_FALSE(surface.clears(a, b, c, 0.3));
    met += !expected.empty();
    near += least <= 0.3;
  }
  CHECK((met > 50 && met < 950 && near > met));
}

TEST_CASE("an object grows around a finished one without a point in common, half a voxel away at most",
          "[walls][objects]") {
  const double radius = GENERATE(0.2, 1.0, 2.0, 4.0, 6.5);
  const Direction direction = GENERATE(Direction::outward, Direction::both);
  Parameters p;
  p.direction = direction;
  const TriangleSoup inner = ballInside(radius, Vec3(1, 0.3, -0.2));
  ActiveContour contour(ballVolume(), {Seed{kMiddle + Vec3(0, 8, 0), 1.2}}, p,
                        behind({object("cyst", inner)}));
  const TriangleSoup outer = grownApart(contour);
  if (radius >= 1) CHECK(contour.stopReason() == StopReason::converged);  // else it may not come to rest
  const Certificate c = certify(outer);
  CHECK(c.components == 2);
  CHECK(c.cavities == 1);
  const double gap = widestGap(inner, outer, always);
  std::cout << "around a ball of " << radius << " mm: gap " << gap << " mm after " << contour.iteration()
            << " iterations\n";
  CHECK(gap <= 0.5);
}

TEST_CASE("an object fills the cavity of a finished one", "[walls][objects]") {
  const auto shellDistance = [](const Vec3& p) {
    return std::max(ballDistance(p), 5 - (p - kMiddle).norm());
  };
  const Volume volume = darkObject(cubicGrid(41), shellDistance);
  Parameters dark, bright;
  dark.range = IntensityRange{0, 110};
  ActiveContour outer(volume, {Seed{kMiddle + Vec3(0, 7.5, 0), 1.2}}, dark);
  while (outer.stopReason() == StopReason::running) outer.step();
  const TriangleSoup wall = outer.mesh().compact();
  REQUIRE(certify(wall).cavities == 1);
  bright.range = IntensityRange{110, 300};
  ActiveContour contour(volume, {Seed{kMiddle, 2.0}}, bright, behind({object("wall", wall)}));
  const TriangleSoup inner = grownApart(contour);
  CHECK(certify(inner).components == 1);
  const auto isCavity = [](const Vec3& q) { return (q - kMiddle).norm() < 7; };
  const double gap = widestGap(wall, inner, isCavity);
  std::cout << "in a cavity: gap " << gap << " mm\n";
  CHECK(gap <= 0.5);
  CHECK(widestGap(inner, wall, always) <= 0.5);
}

TEST_CASE("two bodies that overlap in the image share the place where the first one ends",
          "[walls][objects]") {
  // Two balls of one intensity that overlap: the first is a finished mesh, the second has to stop at it.
  const auto twoBalls = [](const Vec3& p) {
    return std::min((p - kMiddle + Vec3(6, 0, 0)).norm(), (p - kMiddle - Vec3(6, 0, 0)).norm()) - 8;
  };
  const TriangleSoup first = icosphere(kMiddle - Vec3(6, 0, 0), 8, GENERATE(1.0, 2.0, 4.0));
  ActiveContour contour(darkObject(cubicGrid(41), twoBalls), {Seed{kMiddle + Vec3(7, 0, 0), 3.0}}, {},
                        behind({object("first", first)}));
  const TriangleSoup second = grownApart(contour);
  // Near the rim of the second ball its own edge is rounded off.
  const auto gapBelow = [&](double r) {
    return widestGap(first, second, [r](const Vec3& q) { return (q - kMiddle - Vec3(6, 0, 0)).norm() < r; });
  };
  const double gap = gapBelow(6.5);
  std::cout << "overlapping: gap " << gap << " mm, at the rim " << gapBelow(7.5) << " mm\n";
  CHECK(gap <= 0.5);
}

TEST_CASE("a hollow of a single vertex in a finished object is filled, half a voxel away at most",
          "[walls][objects]") {
  const Vec3 place = kMiddle - Vec3(6, 0, 0), mouth = place + Vec3(8, 0, 0);
  TriangleSoup first = icosphere(place, 8, GENERATE(1.5, 2.0, 3.0));
  const auto away = [&](const Vec3& p) { return (p - mouth).norm(); };
  Vec3& deepest = *std::min_element(first.points.begin(), first.points.end(),
                                    [&](const Vec3& p, const Vec3& q) { return away(p) < away(q); });
  deepest.x() -= 0.8;
  const Vec3 hollow = deepest;
  const auto twoBalls = [](const Vec3& p) {
    return std::min((p - kMiddle + Vec3(6, 0, 0)).norm(), (p - kMiddle - Vec3(6, 0, 0)).norm()) - 8;
  };
  ActiveContour contour(darkObject(cubicGrid(41), twoBalls), {Seed{kMiddle + Vec3(7, 0, 0), 3.0}}, {},
                        behind({object("first", first)}));
  const double gap = bruteDistanceTo(grownApart(contour), hollow);
  std::cout << "at a hollow: gap " << gap << " mm\n";
  CHECK(gap <= 0.5);
}

TEST_CASE("edges are shorter before what is hollow, and nowhere else", "[walls][objects]") {
  const double voxel = 1, edge = 2;
  const auto wallsOf = [&](const TriangleSoup& mesh) {
    WallList list;
    list.objects = {object("first", mesh)};
    return Walls(list, cubicGrid(41), edge, 0.5);
  };
  const Walls ball = wallsOf(ballInside(8)),
              shell = wallsOf(ThreeBodies::hollow(ballInside(14), ballInside(4)));
  for (const double r : {8.2, 9.0, 12.0}) CHECK(ball.edgePart(kMiddle + Vec3(r, 0, 0)) == 1);
  CHECK(shell.edgePart(kMiddle + Vec3(14.2, 0, 0)) == 1);  // outside
  const double before = shell.edgePart(kMiddle + Vec3(3.8, 0, 0));
  CHECK(before < 0.8);
  CHECK(before * edge >= voxel);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> side(-20, 20), little(-1, 1);
  for (int i = 0; i < 20'000; ++i) {  // what moves a little asks for little else
    const Vec3 p = kMiddle + Vec3(side(random), side(random), side(random)) / 2;
    const Vec3 q = p + Vec3(little(random), little(random), little(random));
    const double most = SizeField::kGrade * (p - q).norm() / edge;
    CHECK(std::abs(shell.edgePart(p) - shell.edgePart(q)) <= most + 1e-12);
  }
}

TEST_CASE("finished objects far away change nothing", "[walls][objects]") {
  const auto run = [](const Constraints& constraints) {
    ActiveContour contour(torusVolume(), {Seed{kMiddle + Vec3(kTorusR, 0, 0), 3.0}}, {}, constraints);
    while (contour.stopReason() == StopReason::running) contour.step();
    return contour.mesh();
  };
  CHECK(isSame(run({}), run(behind({object("far", icosphere(Vec3(38, 38, 38), 1, 1))}))));
}

TEST_CASE("a seed in a finished object is refused by that object's name", "[walls][objects]") {
  const auto message = messageOf([] {
    ActiveContour(ballVolume(), {Seed{kMiddle, 2.0}}, {},
                  behind({object("far", icosphere(Vec3(38, 38, 38), 1, 1)), object("liver", ballInside(3))}));
  });
  CHECK(message == "The seed at 20,20,20 mm lies in the object 'liver', which is done already.");
  CHECK(messageOf([] {
          ActiveContour(ballVolume(), {Seed{kMiddle, 2.0}}, {}, behind({{"empty", nullptr}}));
        }) == "The object 'empty' has no mesh that could be a wall.");
}

TEST_CASE("a finished object put over a surface, or around or into it, is refused", "[walls][objects]") {
  const Seed seed{kMiddle, 4.0};
  Parameters p;
  p.direction = GENERATE(Direction::outward, Direction::both);
  ActiveContour contour(ballVolume(), {seed}, p);
  while (contour.stopReason() == StopReason::running) contour.step();
  const Mesh before = contour.mesh();
  const auto refusal = [&](const WallObject& wall) {
    return messageOf([&] { contour.change({{seed}, p, behind({wall})}); });
  };
  CHECK(refusal(object("over", ballInside(3, Vec3(9, 0, 0)))) ==
        "The object 'over' lies over surface that is already there: go back to before it came in there.");
  CHECK(refusal(object("in", ballInside(2))).find("within the surface") != std::string::npos);
  CHECK(refusal(object("around", ballInside(15))).find("'around' lies over surface") != std::string::npos);
  CHECK(isSame(contour.mesh(), before));
  CHECK(refusal(object("beside", icosphere(Vec3(38, 38, 38), 1, 1))).empty());
}

TEST_CASE("bodies meet, lie in each other or are apart", "[walls][objects]") {
  const TriangleSoup ball = ballInside(5);
  CHECK(bodyContact(ball, ballInside(5, Vec3(8, 0, 0))) == BodyContact::surfaces);
  CHECK(bodyContact(ball, ballInside(2)) == BodyContact::inside);
  CHECK(bodyContact(ballInside(2), ball) == BodyContact::inside);
  CHECK(bodyContact(ball, ballInside(2, Vec3(8, 0, 0))) == BodyContact::none);
  CHECK(bodyContact(ball, ball) == BodyContact::surfaces);
}
