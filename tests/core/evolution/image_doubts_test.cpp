#include "core/evolution/image_doubts.h"

#include "core/evolution/active_contour.h"
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

//! A ball in the left half whose right half goes on for ever.
Volume halfOpenVolume() {
  return volumeByDistance(cubicGrid(41), 0, 100, [](const Vec3& p) {
    const double aside = std::hypot(p[1] - kCentre[1], p[2] - kCentre[2]);
    return p[0] < kCentre[0] ? (p - kCentre).norm() - kRadius : aside - 3 * kRadius;
  });
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

TEST_CASE("nothing speaks against a surface on the object's edge") {
  CHECK(imageDoubts(sphere(), imageOf(ballVolume())).empty());
}

TEST_CASE("a surface in the open is doubted with the part that has no edge") {
  const auto doubts = imageDoubts(sphere(), imageOf(constantVolume()));
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("100 % of the surface") && Contains("no edge"));
}

TEST_CASE("a neck is reported with its radius and the volumes before and behind it") {
  const auto doubts = imageDoubts(sphere(), imageOf(ballVolume(), neckCut()));
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("neck of radius 2.5 mm") && Contains("at least 12 ml") &&
                            Contains("fill 1.5 ml") && Contains("--range"));
}

TEST_CASE("a cut where the structure widens is reported as such") {
  NeckCut cut = *neckCut();
  cut.widens = true;
  const auto doubts = imageDoubts(sphere(), imageOf(ballVolume(), std::make_shared<NeckCut>(cut)));
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("grows wider than a radius of 2.5 mm") && Contains("at least 12 ml"));
}

TEST_CASE("a cut at a hole in a wall is reported as such") {
  NeckCut cut = *neckCut();
  cut.hole = true;
  const auto doubts = imageDoubts(sphere(), imageOf(ballVolume(), std::make_shared<NeckCut>(cut)));
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("at a hole of radius 2.5 mm in a thin wall") && Contains("at least 12 ml"));
}

TEST_CASE("a neck and a missing edge give a sentence each, without a full stop") {
  const auto doubts = imageDoubts(sphere(), imageOf(constantVolume(), neckCut()));
  REQUIRE(doubts.size() == 2);
  for (const std::string& doubt : doubts) CHECK(doubt.back() != '.');
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
  const std::vector<std::string> doubts = contour.doubts();
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("border of the field of view"));
}
