#include "core/evolution/image_warnings.h"

#include <Eigen/Geometry>
#include <numeric>

#include "core/evolution/active_contour.h"
#include "core/evolution/object_image.h"
#include "core/mesh/shapes.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByDistance;
using testing::volumeByIndex;

namespace {

const Vec3 kCentre(20, 20, 20);
constexpr double kRadius = 12;

Mesh sphere(const Vec3& centre = kCentre) { return Mesh(icosphere(centre, kRadius, 1)); }

//! As a force sees a dark object of 0 in a background of 100: half-way at 50.
ObjectImage imageOf(Volume volume, std::shared_ptr<const NeckCut> neck = nullptr) {
  return ObjectImage(std::make_shared<SmoothedVolume>(std::move(volume), 0),
                     {-std::numeric_limits<double>::infinity(), 50}, 50, nullptr, std::move(neck));
}

Volume ballVolume() {
  return volumeByDistance(cubicGrid(41), 0, 100,
                          [](const Vec3& p) { return (p - kCentre).norm() - kRadius; });
}

Volume constantVolume() {
  return volumeByIndex(cubicGrid(41), [](int, int, int) { return 10; });
}

//! A ball in a wall that has a gap where it is seen from the middle at less than `angle` from +x: there the
//! object goes on to the border of the volume.
Volume gapVolume(double angle) {
  return volumeByDistance(cubicGrid(41), 0, 100, [angle](const Vec3& p) {
    const Vec3 q = p - kCentre;
    const double aside = std::hypot(q[1], q[2]);
    const double cone = q[0] > 0 ? std::cos(angle) * aside - std::sin(angle) * q[0] : aside;
    return std::min(q.norm() - kRadius, cone);
  });
}

//! A ball in the left half whose right half goes on for ever.
Volume halfOpenVolume() {
  return volumeByDistance(cubicGrid(41), 0, 100, [](const Vec3& p) {
    const double aside = std::hypot(p[1] - kCentre[1], p[2] - kCentre[2]);
    return p[0] < kCentre[0] ? (p - kCentre).norm() - kRadius : aside - 3 * kRadius;
  });
}

double partWithoutEdge(const Mesh& mesh, const ObjectImage& image) {
  return surfaceSupport(mesh, image).withoutEdge;
}

std::vector<std::string> warningsOf(const Mesh& mesh, const ObjectImage& image) {
  return sentences(imageWarnings(mesh, image, surfaceSupport(mesh, image)));
}

//! Calls f(middle, area, support) for each face of a surface in an image.
template <typename F>
void forEachSupport(const Mesh& mesh, const SurfaceSupport& support, F&& f) {
  const TriangleSoup soup = mesh.compact();
  REQUIRE(support.faces.size() == soup.triangles.size());
  const auto corner = [&](const Triangle& t, std::size_t c) { return soup.points[t[c]]; };
  for (std::size_t i = 0; i < support.faces.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const Vec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    f(Vec3((a + b + c) / 3), (b - a).cross(c - a).norm() / 2, support.faces[i]);
  }
}

std::shared_ptr<const NeckCut> neckCut() {
  auto neck = std::make_shared<NeckCut>();
  neck->neckRadius = 2.5;
  neck->keptVolume = 1500;
  neck->cutVolume = 12000;
  neck->barrier = std::make_shared<Barrier>(std::array<int, 3>{0, 0, 0}, std::array<int, 3>{1, 1, 1},
                                            std::vector<unsigned char>{0});
  return neck;
}

}  // namespace

TEST_CASE("no part of a surface on the object's edge is without an edge") {
  CHECK(partWithoutEdge(sphere(), imageOf(ballVolume())) == 0);
}

TEST_CASE("all of a surface in an image of one value is without an edge") {
  CHECK(partWithoutEdge(sphere(), imageOf(constantVolume())) == 1);
}

TEST_CASE("half of a surface whose object goes on behind one half is without an edge") {
  CHECK(partWithoutEdge(sphere(), imageOf(halfOpenVolume())) == Approx(0.5).margin(0.05));
}

TEST_CASE("where the surface ends beyond the border of the volume it does not count") {
  // A quarter of the ball lies beyond it, where no intensity says anything. The ring within half a voxel of
  // the border, 3 % of the ball, has the border itself for an edge.
  CHECK(partWithoutEdge(sphere(Vec3(20, 20, 5)), imageOf(constantVolume())) == Approx(1).margin(0.05));
}

TEST_CASE("a surface of which much lies on the border of the volume is doubted, in the middle of it none") {
  const auto warningsAt = [](const Vec3& centre) {
    const ObjectImage image = imageOf(volumeByDistance(
        cubicGrid(41), 0, 100, [centre](const Vec3& p) { return (p - centre).norm() - kRadius; }));
    return warningsOf(sphere(centre), image);
  };
  CHECK(warningsAt(kCentre).empty());
  const std::vector<std::string> warnings = warningsAt(Vec3(20, 20, 5));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::Matchers::Contains("lies on the border of the volume"));
}

TEST_CASE("a wall with a gap leaves the surface without an edge at the gap and nowhere else") {
  const double angle = 0.6, rim = 1.5 / kRadius;  // the look across a face reaches a voxel to either side
  const Mesh mesh = sphere();
  int atGap = 0, elsewhere = 0;
  forEachSupport(mesh, surfaceSupport(mesh, imageOf(gapVolume(angle))),
                 [&](const Vec3& middle, double, FaceSupport support) {
                   const Vec3 q = middle - kCentre;
                   const double off = std::acos(q[0] / q.norm());
                   CAPTURE(middle.transpose(), off);
                   if (off < angle - rim) CHECK(support == FaceSupport::none);
                   if (off > angle + rim) CHECK(support == FaceSupport::edge);
                   (off < angle - rim ? atGap : elsewhere) += 1;
                 });
  CHECK(atGap > 50);
  CHECK(elsewhere > 50);
}

TEST_CASE("the part without an edge is that of the faces without one, by area") {
  Mesh mesh = sphere();
  for (int v = 0; v < mesh.vertexSlots(); ++v) {  // faces of unlike sizes, on either side of the gap
    Vec3 p = mesh.position(v) - kCentre;
    p[0] += 0.03 * (kRadius * kRadius - p[0] * p[0]);
    mesh.setPosition(v, kCentre + kRadius * p.normalized());
  }
  const SurfaceSupport support = surfaceSupport(mesh, imageOf(gapVolume(0.6)));
  double without = 0, all = 0;
  int faces = 0;
  forEachSupport(mesh, support, [&](const Vec3&, double area, FaceSupport face) {
    all += area;
    if (face != FaceSupport::none) return;
    without += area;
    ++faces;
  });
  CHECK(support.withoutEdge == Approx(without / all));
  CHECK(support.withoutEdge != Approx(faces / static_cast<double>(mesh.faceCount())).epsilon(0.02));
}

TEST_CASE("faces are numbered as in the compacted mesh, whatever was deleted before them") {
  TriangleSoup both = icosphere(kCentre, 1, 1);
  const TriangleSoup ball = icosphere(kCentre, kRadius, 1);
  const int points = static_cast<int>(both.points.size()), faces = static_cast<int>(both.triangles.size());
  both.points.insert(both.points.end(), ball.points.begin(), ball.points.end());
  for (const Triangle& t : ball.triangles)
    both.triangles.push_back({t[0] + points, t[1] + points, t[2] + points});
  Mesh mesh(both);
  std::vector<int> small(faces);
  std::iota(small.begin(), small.end(), 0);
  mesh.removeFaces(small);
  for (int v = 0; v < points; ++v) mesh.removeVertex(v);
  const ObjectImage image = imageOf(gapVolume(0.6));
  CHECK(surfaceSupport(mesh, image).faces == surfaceSupport(Mesh(ball), image).faces);
}

TEST_CASE("nothing speaks against a surface on the object's edge") {
  CHECK(warningsOf(sphere(), imageOf(ballVolume())).empty());
}

TEST_CASE("a surface in the open is doubted with the part that has no edge") {
  const auto warnings = warningsOf(sphere(), imageOf(constantVolume()));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Contains("100 % of the surface") && Contains("no edge"));
}

TEST_CASE("a neck is reported with its radius and the volumes before and behind it") {
  const auto warnings = warningsOf(sphere(), imageOf(ballVolume(), neckCut()));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Contains("neck of radius 2.5 mm") && Contains("at least 12 ml") &&
                              Contains("fill 1.5 ml") && Contains("--range"));
}

TEST_CASE("a cut where the structure widens is reported as such") {
  NeckCut cut = *neckCut();
  cut.widens = true;
  const auto warnings = warningsOf(sphere(), imageOf(ballVolume(), std::make_shared<NeckCut>(cut)));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Contains("grows wider than a radius of 2.5 mm") && Contains("at least 12 ml"));
}

TEST_CASE("a cut at a hole in a wall is reported as such") {
  NeckCut cut = *neckCut();
  cut.hole = true;
  const auto warnings = warningsOf(sphere(), imageOf(ballVolume(), std::make_shared<NeckCut>(cut)));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Contains("at a hole of radius 2.5 mm in a thin wall") && Contains("at least 12 ml"));
}

TEST_CASE("a neck and a missing edge give a sentence each, without a full stop") {
  const auto warnings = warningsOf(sphere(), imageOf(constantVolume(), neckCut()));
  REQUIRE(warnings.size() == 2);
  for (const std::string& warning : warnings) CHECK(warning.back() != '.');
}

TEST_CASE("a surface that is held at a hole in a wall has no edge there and nowhere else") {
  // Two chambers with a wall of 2 mm between them, and a square hole of 6 mm in it.
  const Vec3 hole(40, 24, 24);
  Grid grid = cubicGrid(48);
  grid.size[0] = 80;
  const Volume volume = volumeByIndex(grid, [&](int i, int j, int k) {
    const double across = std::max(std::abs(j - hole[1]), std::abs(k - hole[2]));
    const double left = std::max({across - 18, 8.0 - i, i - 39.0});
    const double right = std::max({across - 18, 41.0 - i, i - 72.0});
    const double between = std::max(across - 3, std::abs(i - hole[0]) - 3);
    const double t = std::clamp(std::min({left, right, between}) + 0.5, 0.0, 1.0);
    return 20 + 180 * t + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  });
  ActiveContour contour(volume, {Seed{Vec3(20, 24, 24), 4.0}}, {});
  while (contour.stopReason() == StopReason::running) contour.step();
  const SurfaceSupport support = contour.support();
  double atHole = 0, elsewhere = 0;
  forEachSupport(contour.mesh(), support, [&](const Vec3& middle, double area, FaceSupport face) {
    CAPTURE(middle.transpose());
    const double off = std::hypot(middle[1] - hole[1], middle[2] - hole[2]);
    if (off < 1.5 && middle[0] > 36) {
      CHECK(face == FaceSupport::none);
      atHole += area;
    }
    if ((middle - hole).norm() > 6) {
      CHECK(face == FaceSupport::edge);
      elsewhere += area;
    }
  });
  CHECK(atHole > 3);
  CHECK(elsewhere > 4000);  // the left chamber's walls are 7056 mm² less its rounded edges
  CHECK(elsewhere < 7056);  // the right one was not entered
  CHECK(support.withoutEdge > 0);
}

TEST_CASE("a surface that ends at the border of the field of view is doubted") {
  // The ball's upper half was not seen: padding of one value.
  const Volume cut = volumeByIndex(cubicGrid(41), [&](int i, int j, int k) {
    const double d = (Vec3(i, j, k) - kCentre).norm() - kRadius;
    return k > 20 ? 0.0
                  : 20 + 80 * std::clamp(d + 0.5, 0.0, 1.0) + 0.01 * std::sin(i + 37.1 * j + 1234.5 * k);
  });
  ActiveContour contour(cut, {Seed{Vec3(20, 20, 14), 4.0}}, {});
  while (contour.stopReason() == StopReason::running) contour.step();
  const std::vector<std::string> warnings = sentences(contour.warnings(contour.support()));
  REQUIRE(warnings.size() == 2);
  CHECK_THAT(warnings[0], Contains("where the image shows no edge"));
  CHECK_THAT(warnings[1], Contains("border of the field of view"));
}
