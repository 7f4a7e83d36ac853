#include "core/mesh/plane_section.h"

#include <cmath>
#include <map>
#include <tuple>

#include "core/mesh/shapes.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

using Segments = std::vector<std::array<Vec3, 2>>;

Segments cut(const TriangleSoup& mesh, const Vec3& normal, double offset) {
  Segments section;
  planeSection(mesh.points, mesh.triangles, normal, offset, section);
  return section;
}

}  // namespace

TEST_CASE("A plane cuts a sphere in a circle", "[plane_section]") {
  const Vec3 centre(3, -2, 7), normal = Vec3(1, 2, 2) / 3;
  constexpr double kRadius = 10, kEdge = 1, kOff = 4;
  const double offset = normal.dot(centre) + kOff;
  const Segments section = cut(icosphere(centre, kRadius, kEdge), normal, offset);
  // Points of a flat triangle with corners on the sphere lie at most this far inside it (sagitta of the
  // circumcircle of a triangle with edges of kEdge, whose radius is kEdge / sqrt(3)).
  const double sagitta = kRadius - std::sqrt(kRadius * kRadius - kEdge * kEdge / 3);
  const Vec3 middle = centre + kOff * normal;
  double length = 0;
  for (const auto& [from, to] : section) {
    CHECK(std::abs(normal.dot(from) - offset) < 1e-12);
    CHECK((from - centre).norm() <= kRadius + 1e-12);
    CHECK((from - centre).norm() >= kRadius - sagitta - 1e-12);
    CHECK((middle - from).dot(normal) == Approx(0).margin(1e-12));
    length += (to - from).norm();
  }
  const double circumference = 2 * M_PI * std::sqrt(kRadius * kRadius - kOff * kOff);
  CHECK(length < circumference);
  CHECK(length > 0.99 * circumference);
}

TEST_CASE("A plane cuts a closed mesh in closed lines", "[plane_section]") {
  // Through points of the mesh too: z = 0 holds some of an icosphere's.
  for (double offset : {0.0, 0.3, -2.0, 4.9}) {
    std::map<std::tuple<double, double, double>, int> ends;
    for (const auto& segment : cut(icosphere(Vec3::Zero(), 5, 1), Vec3::UnitZ(), offset))
      for (const Vec3& end : segment) ++ends[{end.x(), end.y(), end.z()}];
    CHECK_FALSE(ends.empty());
    for (const auto& [place, count] : ends) CHECK(count % 2 == 0);
  }
}

TEST_CASE("A plane that only touches a mesh from below, or misses it, cuts nothing", "[plane_section]") {
  TriangleSoup tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}};
  tetrahedron.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  CHECK(cut(tetrahedron, Vec3::UnitZ(), 0).empty());
  CHECK(cut(tetrahedron, Vec3::UnitZ(), -0.1).empty());
  CHECK(cut(tetrahedron, Vec3::UnitZ(), 1.1).empty());
  CHECK(cut(tetrahedron, Vec3::UnitZ(), 0.5).size() == 3);
}

TEST_CASE("The section of a mesh replaces what was there", "[plane_section]") {
  Segments section(7);
  std::vector<int> crossed(7);
  planeSection({}, {}, Vec3::UnitX(), 0, section, &crossed);
  CHECK(section.empty());
  CHECK(crossed.empty());
}

TEST_CASE("Each segment of a section lies in the triangle that is named for it", "[plane_section]") {
  const TriangleSoup mesh = icosphere(Vec3(3, -2, 7), 10, 2);
  Segments section;
  std::vector<int> crossed;
  planeSection(mesh.points, mesh.triangles, Vec3::UnitZ(), 8, section, &crossed);
  REQUIRE(crossed.size() == section.size());
  REQUIRE_FALSE(section.empty());
  for (std::size_t i = 0; i < section.size(); ++i) {
    const Triangle& t = mesh.triangles[crossed[i]];
    const Vec3 corner = mesh.points[t[0]];
    const Vec3 u = mesh.points[t[1]] - corner, v = mesh.points[t[2]] - corner;
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
    for (const Vec3& end : section[i]) {
      const Vec3 to = end - corner;  // written as a u + b v (Cramer's rule)
      const double a = (vv * u.dot(to) - uv * v.dot(to)) / determinant;
      const double b = (uu * v.dot(to) - uv * u.dot(to)) / determinant;
      CHECK((a * u + b * v - to).norm() < 1e-9);
      CHECK(std::min(a, b) > -1e-9);
      CHECK(a + b < 1 + 1e-9);
    }
  }
}
