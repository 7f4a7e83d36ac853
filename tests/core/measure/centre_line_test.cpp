// Centre lines of tubes whose length, width and course are known.

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/measure/centre_line.h"
#include "core/measure/section_area.h"
#include "core/mesh/validity.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;

namespace {

using std::numbers::pi;
constexpr int kAround = 48;

struct Ring {
  Vec3 centre, u, v;  //!< u and v: half axes of the ellipse
};

//! A tube through rings, closed by a point at either end.
TriangleSoup tube(int rings, const std::function<Ring(double)>& at) {
  TriangleSoup s;
  for (int i = 0; i <= rings; ++i) {
    const Ring ring = at(static_cast<double>(i) / rings);
    for (int j = 0; j < kAround; ++j) {
      const double a = 2 * pi * (j + 0.5 * (i % 2)) / kAround;
      s.points.push_back(ring.centre + std::cos(a) * ring.u + std::sin(a) * ring.v);
    }
  }
  const auto id = [](int i, int j) { return i * kAround + j % kAround; };
  const int first = static_cast<int>(s.points.size());
  s.points.push_back(at(0).centre);
  s.points.push_back(at(1).centre);
  for (int j = 0; j < kAround; ++j) {
    s.triangles.push_back({first, id(0, j + 1), id(0, j)});
    s.triangles.push_back({first + 1, id(rings, j), id(rings, j + 1)});
    for (int i = 0; i < rings; ++i) {
      // Rows of odd number are turned by half an edge.
      if (i % 2 == 0) {
        s.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j)});
        s.triangles.push_back({id(i, j + 1), id(i + 1, j + 1), id(i + 1, j)});
      } else {
        s.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
        s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
      }
    }
  }
  if (examine(s).volume < 0)
    for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

//! Without the points within a radius of the ends, where a tube is no tube.
template <typename F>
void forMiddle(const CentreLine& line, double margin, F&& f) {
  int n = 0;
  for (const CentreLinePoint& p : line.points)
    if (p.along > margin && p.along < line.length - margin) {
      f(p);
      ++n;
    }
  CHECK(n >= 10);
}

}  // namespace

TEST_CASE("the line through a straight tube is its axis, and sections have its area", "[measure]") {
  const auto mesh = tube(60, [](double t) { return Ring{Vec3(2, 3, 60 * t), Vec3(5, 0, 0), Vec3(0, 5, 0)}; });
  REQUIRE(examine(mesh).oriented);
  const CentreLine line = centreLine(mesh, Vec3(5, 5, 10.3), Vec3(1, -1, 49.6));  // both off the axis
  REQUIRE(line.fault == CentreLineFault::none);
  CHECK(line.length == Approx(39.3).epsilon(0.01));
  forMiddle(line, 0, [](const CentreLinePoint& p) {
    CHECK((p.place - Vec3(2, 3, p.place.z())).norm() < 0.05);
    CHECK(p.radius == Approx(5).epsilon(0.01));
    CHECK(p.area.value() == Approx(pi * 25).epsilon(0.01));
    CHECK(p.equivalentDiameter() == Approx(10).epsilon(0.01));
    CHECK(std::abs(p.direction.z()) == Approx(1).epsilon(1e-3));
  });
}

TEST_CASE("the line through a bent tube keeps to the bend", "[measure]") {
  const double R = 20, r = 4;
  const auto at = [&](double t) {
    const double a = 1.5 * pi * t;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    return Ring{R * out, r * out, Vec3(0, 0, r)};
  };
  const TriangleSoup mesh = tube(180, at);
  const double from = 0.3, to = 4.3;
  const CentreLine line =
      centreLine(mesh, R * Vec3(std::cos(from), std::sin(from), 0), R * Vec3(std::cos(to), std::sin(to), 0));
  REQUIRE(line.fault == CentreLineFault::none);
  CHECK(line.length == Approx(R * (to - from)).epsilon(0.01));
  forMiddle(line, 0, [&](const CentreLinePoint& p) {
    CHECK(std::hypot(p.place.x(), p.place.y()) == Approx(R).epsilon(0.01));
    CHECK(p.area.value() == Approx(pi * r * r).epsilon(0.01));
  });
}

TEST_CASE("the line through a helix of changing width and elliptic section", "[measure]") {
  const double R = 15, climb = 8, turns = 1.25;
  const auto wide = [](double t) { return 2 + 1.5 * t; };
  const auto at = [&](double t) {
    const double a = 2 * pi * turns * t;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    const Vec3 along = Vec3(-R * std::sin(a), R * std::cos(a), climb).normalized();
    return Ring{R * out + Vec3(0, 0, climb * a), wide(t) * out, 1.6 * wide(t) * along.cross(out)};
  };
  const CentreLine line = centreLine(tube(440, at), at(0.05).centre, at(0.95).centre);
  REQUIRE(line.fault == CentreLineFault::none);
  const double angle = 2 * pi * turns * 0.9;
  CHECK(line.length == Approx(std::hypot(R, climb) * angle).epsilon(0.01));
  forMiddle(line, 3, [&](const CentreLinePoint& p) {
    const double t = 0.05 + 0.9 * p.along / line.length;
    CHECK(p.area.value() == Approx(pi * 1.6 * wide(t) * wide(t)).epsilon(0.01));
  });
}

TEST_CASE("in a torus the line takes the shorter way round", "[measure]") {
  const TriangleSoup mesh = zoo::torus(240, 96, 20, 5);
  const CentreLine line = centreLine(mesh, Vec3(18, 0, 1), Vec3(0, 22, -1));
  REQUIRE(line.fault == CentreLineFault::none);
  CHECK(line.length == Approx(20 * pi / 2).epsilon(0.01));
  CHECK(line.points.front().radius == Approx(5).epsilon(0.01));
}

TEST_CASE("the section of a tube with a wall is a ring, and the inner of two parts is not counted",
          "[measure]") {
  const auto pipe = [](double radius, double end) {
    return tube(20, [=](double t) {
      return Ring{Vec3(0, 0, end * (2 * t - 1)), Vec3(radius, 0, 0), Vec3(0, radius, 0)};
    });
  };
  TriangleSoup mesh = pipe(6, 20);
  const auto add = [&](const TriangleSoup& other, bool isCavity) {
    const int first = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (Triangle t : other.triangles) {
      if (isCavity) std::swap(t[1], t[2]);
      mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  };
  add(pipe(4, 18), true);
  add(pipe(2, 16), false);
  const Vec3 tilted = Vec3(0.1, 0, 1).normalized();
  CHECK(sectionArea(mesh, Vec3(5, 0, 0), tilted).value() == Approx(pi * 20 / tilted.z()).epsilon(0.01));
  CHECK(sectionArea(mesh, Vec3(0, 1, 0), tilted).value() == Approx(pi * 4 / tilted.z()).epsilon(0.01));
  CHECK_FALSE(sectionArea(mesh, Vec3(0, 3, 0), tilted).has_value());
  CHECK_FALSE(sectionArea(mesh, Vec3(0, 9, 0), tilted).has_value());
}

TEST_CASE("where there is no line the reason is told", "[measure]") {
  TriangleSoup mesh = icosphere(Vec3(0, 0, 0), 5, 1);
  const TriangleSoup other = icosphere(Vec3(20, 0, 0), 5, 1);
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  CHECK(centreLine(mesh, Vec3(0, 0, 0), Vec3(20, 0, 0)).fault == CentreLineFault::noWay);
  CHECK(centreLine(mesh, Vec3(10, 0, 0), Vec3(20, 0, 0)).fault == CentreLineFault::firstOutside);
  CHECK(centreLine(mesh, Vec3(0, 0, 0), Vec3(20, 9, 0)).fault == CentreLineFault::secondOutside);
  CHECK(centreLine(mesh, Vec3(0, 0, 0), Vec3(0.1, 0, 0)).fault == CentreLineFault::samePlace);
}
