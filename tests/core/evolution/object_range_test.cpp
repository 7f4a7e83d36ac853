#include "core/evolution/object_range.h"

#include <random>

#include "core/errors.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByDistance;
using testing::volumeByIndex;

namespace {

const Vec3 kCentre(16, 16, 16);

double ball(const Vec3& p) { return (p - kCentre).norm() - 9; }

//! So that no value repeats and none is taken for padding: small beside every step here.
double texture(int i, int j, int k) { return 0.2 * std::sin(i + 37.1 * j + 1234.5 * k); }

//! A ball of one value in a background of another, with an edge of one voxel.
Volume ballVolume(double inside, double outside) {
  return volumeByIndex(cubicGrid(33), [&](int i, int j, int k) {
    const double t = std::clamp(ball(Vec3(i, j, k)) + 0.5, 0.0, 1.0);
    return inside + t * (outside - inside) + texture(i, j, k);
  });
}

std::vector<Seed> seedAt(const Vec3& p) { return {Seed{p, {}}}; }

double boundaryOf(const ObjectChoice& c) { return c.object == ObjectKind::dark ? c.range.high : c.range.low; }

}  // namespace

TEST_CASE("the boundary level of a two-valued image with blurred edges lies half-way") {
  for (const auto& [inside, outside] :
       {std::pair(0.0, 100.0), std::pair(100.0, 0.0), std::pair(-40.0, 300.0), std::pair(1000.0, 900.0)}) {
    CAPTURE(inside, outside);
    const ObjectChoice c = chooseObject(ballVolume(inside, outside), seedAt(kCentre), {});
    const double step = std::abs(outside - inside);
    CHECK(c.object == (inside < outside ? ObjectKind::dark : ObjectKind::bright));
    CHECK(boundaryOf(c) == Approx((inside + outside) / 2).margin(0.1 * step));
    CHECK(c.level == Approx(inside).margin(0.01 * step));
    CHECK(c.contrast == Approx(step / 2).margin(0.1 * step));
    CHECK(std::isinf(c.object == ObjectKind::dark ? c.range.low : c.range.high));
  }
}

TEST_CASE("the boundary level is half-way also where the background is one value throughout") {
  const Volume volume = volumeByDistance(cubicGrid(33), 0, 100, ball);
  CHECK(chooseObject(volume, seedAt(kCentre), {}).range.high == Approx(50).margin(10));
}

TEST_CASE("asking for what is there gives the same as the automatic choice") {
  const Volume volume = ballVolume(20, 120);
  Parameters dark;
  dark.object = ObjectKind::dark;
  const ObjectChoice asked = chooseObject(volume, seedAt(kCentre), dark);
  const ObjectChoice automatic = chooseObject(volume, seedAt(kCentre), {});
  CHECK(asked.range.high == automatic.range.high);
  CHECK(asked.contrast == automatic.contrast);
}

TEST_CASE("a bright object is not found in a dark one") {
  Parameters bright;
  bright.object = ObjectKind::bright;
  CHECK_THROWS_AS(chooseObject(ballVolume(20, 120), seedAt(kCentre), bright), SeedError);
}

TEST_CASE("the level survives noise, and noise is smoothed away") {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 25);
  const Volume volume = volumeByIndex(cubicGrid(33), [&](int i, int j, int k) {
    return 100 * std::clamp(ball(Vec3(i, j, k)) + 0.5, 0.0, 1.0) + noise(random);
  });
  const ObjectChoice noisy = chooseObject(volume, seedAt(kCentre), {});
  CHECK(noisy.object == ObjectKind::dark);
  CHECK(noisy.range.high == Approx(50).margin(12));
  CHECK(noisy.volume->sigma() > chooseObject(ballVolume(0, 100), seedAt(kCentre), {}).volume->sigma());
}

TEST_CASE("noise that hides the boundary at the first smoothing is smoothed more") {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 160);
  const auto middle = Vec3::Constant(32);
  const Volume volume = volumeByIndex(cubicGrid(65), [&](int i, int j, int k) {
    return 100 * std::clamp((Vec3(i, j, k) - middle).norm() - 23.5, 0.0, 1.0) + noise(random);
  });
  Parameters first;
  first.smoothing = 1;
  CHECK_THROWS_AS(chooseObject(volume, seedAt(middle), first), SeedError);
  const ObjectChoice c = chooseObject(volume, seedAt(middle), {});
  CHECK(c.object == ObjectKind::dark);
  CHECK(c.volume->sigma() > 1);
  CHECK(boundaryOf(c) == Approx(50).margin(15));
}

TEST_CASE("an object that fills most of a large volume without reaching its border is no leak") {
  std::minstd_rand random(5);
  std::uniform_real_distribution<double> noise(-40, 40);
  const auto middle = Vec3::Constant(112);
  const Volume volume = volumeByIndex(cubicGrid(225), [&](int i, int j, int k) {
    return 100 * std::clamp((Vec3(i, j, k) - middle).lpNorm<Eigen::Infinity>() - 99.5, 0.0, 1.0) +
           noise(random);
  });
  CHECK(boundaryOf(chooseObject(volume, seedAt(middle), {})) == Approx(50).margin(15));
}

TEST_CASE("smoothing that was asked for is used") {
  for (double sigma : {0.0, 0.8, 2.0}) {
    Parameters p;
    p.smoothing = sigma;
    CHECK(chooseObject(ballVolume(0, 100), seedAt(kCentre), p).volume->sigma() == sigma);
    p.range = IntensityRange{-10, 50};
    CHECK(chooseObject(ballVolume(0, 100), seedAt(kCentre), p).volume->sigma() == sigma);
  }
}

TEST_CASE("a range that was asked for is used as it is, with the contrast to its nearer end") {
  Parameters p;
  p.range = IntensityRange{-100, 30};
  const ObjectChoice c = chooseObject(ballVolume(0, 100), seedAt(kCentre), p);
  CHECK(c.range.low == -100);
  CHECK(c.range.high == 30);
  CHECK(c.object == ObjectKind::dark);
  CHECK(c.contrast == Approx(30).margin(0.5));
}

TEST_CASE("a seed outside the volume is refused with a sentence that says where it is") {
  try {
    chooseObject(ballVolume(0, 100), seedAt(Vec3(16, 16, 40)), {});
    FAIL("no error");
  } catch (const SeedError& e) {
    CHECK(std::string(e.what()).find("40.0") != std::string::npos);
    CHECK(std::string(e.what()).find("outside the volume") != std::string::npos);
  }
  const double nan = std::nan("");
  CHECK_THROWS_AS(chooseObject(ballVolume(0, 100), seedAt(Vec3(nan, 1, 1)), {}), SeedError);
}

TEST_CASE("one seed outside among several is refused") {
  CHECK_THROWS_AS(chooseObject(ballVolume(0, 100), {Seed{kCentre, {}}, Seed{Vec3(-9, 0, 0), {}}}, {}),
                  SeedError);
}

TEST_CASE("no seed at all is refused") {
  CHECK_THROWS_AS(chooseObject(ballVolume(0, 100), {}, {}), UsageError);
}

TEST_CASE("a seed out of the range is refused") {
  Parameters p;
  p.range = IntensityRange{80, 120};
  CHECK_THROWS_AS(chooseObject(ballVolume(0, 100), seedAt(kCentre), p), SeedError);
}

TEST_CASE("an image without a boundary is refused") {
  const Volume constant = volumeByIndex(cubicGrid(20), [](int, int, int) { return 7; });
  CHECK_THROWS_AS(chooseObject(constant, seedAt(Vec3(10, 10, 10)), {}), SeedError);
}

TEST_CASE("an empty range, one that holds no voxel and one without meaning are refused") {
  const double nan = std::nan("");
  for (const IntensityRange& range :
       {IntensityRange{50, 40}, IntensityRange{200, 300}, IntensityRange{nan, 10}, IntensityRange{0, nan}}) {
    Parameters p;
    p.range = range;
    CHECK_THROWS_AS(chooseObject(ballVolume(0, 100), seedAt(kCentre), p), UsageError);
  }
}

TEST_CASE("two chambers joined by a gap have the boundary of their wall, not that of the gap") {
  // Two balls of radius 9, 3 mm apart, joined by a channel of one voxel that smoothing half fills.
  Grid grid = cubicGrid(33);
  grid.size[0] = 54;
  const auto chambers = [](const Vec3& p) {
    const double balls = std::min((p - Vec3(16, 16, 16)).norm(), (p - Vec3(37, 16, 16)).norm()) - 9;
    const double channel = std::hypot(p.y() - 16, p.z() - 16) - 1;
    return std::min(balls, std::max(channel, std::abs(p.x() - 26.5) - 3));
  };
  const Volume volume = volumeByIndex(grid, [&](int i, int j, int k) {
    return 100 * std::clamp(chambers(Vec3(i, j, k)) + 0.5, 0.0, 1.0) + texture(i, j, k);
  });
  const ObjectChoice c = chooseObject(volume, seedAt(Vec3(16, 16, 16)), {});
  CHECK(c.object == ObjectKind::dark);
  CHECK(c.range.high == Approx(50).margin(10));
}

TEST_CASE("a leak into a far larger dark space does not decide the level") {
  // A small chamber in a wall of 100; outside of the wall everything is 60 and dark beside it.
  const Volume chamber = volumeByIndex(cubicGrid(40), [](int i, int j, int k) {
    const double r = (Vec3(i, j, k) - Vec3(12, 20, 20)).norm();
    return (r < 7 ? 0 : r < 10 ? 100 : 60) + texture(i, j, k);
  });
  const ObjectChoice c = chooseObject(chamber, seedAt(Vec3(12, 20, 20)), {});
  CHECK(c.object == ObjectKind::dark);
  CHECK(c.range.high > 30);
  CHECK(c.range.high < 75);
}

TEST_CASE("what fills the field of view up to its padding is refused, unless its kind is given") {
  const Vec3 blob(8, 16, 16);
  const auto inView = [&](double inside, double outside) {
    return volumeByIndex(cubicGrid(33), [&](int i, int j, int k) {
      const Vec3 p(i, j, k);
      if ((p - kCentre).norm() > 14) return 0.0;
      const double t = std::clamp((p - blob).norm() - 3.5, 0.0, 1.0);
      return inside + t * (outside - inside) + texture(i, j, k);
    });
  };
  const Volume darkView = inView(120, 20);
  const std::vector<Seed> seeds = seedAt(kCentre + Vec3(4, 0, 0));
  CHECK_THROWS_AS(chooseObject(darkView, seeds, {}), SeedError);
  Parameters dark;
  dark.object = ObjectKind::dark;
  CHECK(chooseObject(darkView, seeds, dark).object == ObjectKind::dark);
  // The blob has a boundary of its own.
  CHECK(chooseObject(darkView, seedAt(blob), {}).object == ObjectKind::bright);
}
