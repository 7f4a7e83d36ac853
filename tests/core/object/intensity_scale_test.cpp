#include "core/object/intensity_scale.h"

#include <limits>
#include <random>

#include "core/object/object_model.h"
#include "core/object/work_cells.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

constexpr double kBackground = 400, kPeak = 20000, kWidth = 7;  // intensities, voxels
const Vec3 kHot(24, 24, 24);

//! A hot spot without a plateau.
double spot(const Vec3& p) {
  return kBackground + kPeak * std::exp(-(p - kHot).squaredNorm() / (2 * kWidth * kWidth));
}

//! Noise of `proportional` times the signal, and `constant` besides.
Volume noisy(double (*signal)(const Vec3&), double proportional, double constant) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 1);
  return volumeByIndex(cubicGrid(64), [&](int i, int j, int k) {
    const double s = signal(Vec3(i, j, k));
    return s + (proportional * s + constant) * normal(random);
  });
}

IntensityScale scaleOf(const Volume& volume) {
  const ObjectPolicy policy;
  const CellGrid cells = cellsAround(volume.grid, kHot, policy.reach, policy.wideCells);
  return IntensityScale::of(makeCells(volume, cells, nullptr), policy);
}

}  // namespace

TEST_CASE("logarithms where noise grows with the signal and nothing has a plateau") {
  const IntensityScale scale = scaleOf(noisy(spot, 0.05, 0));
  REQUIRE(scale.isLogarithmic());
  for (const double v : {500.0, 3000.0, 20000.0}) CHECK(scale.from(scale.to(v)) == Approx(v));
  // Far above the floor a ratio is a step, wherever it is.
  CHECK(scale.to(20000) - scale.to(10000) == Approx(std::log(2)).epsilon(0.05));
  CHECK(scale.to(10000) - scale.to(5000) == Approx(std::log(2)).epsilon(0.1));
  CHECK(std::isfinite(scale.to(-1e9)));
  CHECK(scale.to(-1e9) < scale.to(kBackground));
}

TEST_CASE("intensities stay as they are in noise that is the same everywhere, and where there is a plateau") {
  CHECK_FALSE(scaleOf(noisy(spot, 0, 300)).isLogarithmic());
  const auto plateau = [](const Vec3& p) { return p[0] < 32 ? kPeak : kPeak / (p[0] - 30); };
  CHECK_FALSE(scaleOf(noisy(plateau, 0.05, 0)).isLogarithmic());
  const IntensityScale asIs;
  CHECK(asIs.to(-12.5) == -12.5);
  CHECK(asIs.from(-12.5) == -12.5);
}

TEST_CASE("a hot spot is taken as far as it stands out of what is around it, not only its core") {
  const auto model = findObject(noisy(spot, 0.05, 0), {{{kHot + Vec3(2, 0, 0), {}}}, {}}, nullptr);
  REQUIRE(model);
  const double radius = std::cbrt(0.75 / 3.14159265 * model->candidates[0].volume);
  // Half of the maximum is reached at 1.18 widths; twice the background at 2.8.
  CHECK(radius > 1.7 * kWidth);
  CHECK(radius < 3.5 * kWidth);
  CHECK(model->low > kBackground);
  CHECK(model->low < 0.5 * kPeak);
  CHECK(model->rise < 0);
}

TEST_CASE("an open bound stays open on either scale") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const IntensityScale& scale : {scaleOf(noisy(spot, 0.05, 0)), IntensityScale()}) {
    CHECK(scale.from(-kInfinity) == -kInfinity);
    CHECK(scale.from(kInfinity) == kInfinity);
  }
}

TEST_CASE("on the scale of logarithms, too, a region goes into finer cells with its surface") {
  const Volume volume = noisy(spot, 0.05, 0);
  const IntensityScale scale = scaleOf(volume);
  REQUIRE(scale.isLogarithmic());
  const ObjectPolicy policy;
  WorkCells fine(volume, nullptr, policy);
  fine.reach({kHot, policy.reach});
  const WorkImage work = fine.image(scale);
  const CellGrid coarse = cellsAround(volume.grid, kHot, policy.reach, 40'000);
  REQUIRE(coarse.factor != work.cells().factor);
  std::vector<std::unique_ptr<ClickSearch>> searches;
  searches.push_back(
      std::make_unique<ClickSearch>(searchAround(volume, coarse, kHot, nullptr, policy, 1, scale)));
  std::vector<RankedRegion> ranked = rankRegions(searches, policy);
  std::erase_if(ranked, [](const RankedRegion& r) { return r.isStar(); });
  const std::vector<RankedRegion> best = distinctRegions(ranked, 1, policy);
  REQUIRE(best.size() == 1);
  const double volumeThere = static_cast<double>(regionOn(work, best[0]).count());  // voxels of 1 mm³
  CHECK(volumeThere == Approx(best[0].volume).epsilon(0.1));
}
