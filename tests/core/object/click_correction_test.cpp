#include "core/object/click_correction.h"

#include <random>

#include "core/object/relabel.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

constexpr double kNoise = 6;
const Vec3 kLeft(16, 20, 20), kRight(44, 20, 20);

//! Nothing but noise.
WorkImage silentImage() {
  Grid grid = cubicGrid(41);
  grid.size[0] = 61;
  std::mt19937 random(7);
  std::normal_distribution<double> normal(50, kNoise);
  const Volume volume = volumeByIndex(grid, [&](int, int, int) { return normal(random); });
  const CellGrid cells = cellsAround(volume.grid, Vec3(30, 20, 20), 100, 1'000'000);
  WorkImage work{makeCells(volume, cells, nullptr), {}};
  work.values = smoothed(cells, work.image.values, 0.6);
  return work;
}

//! Balls of 10 mm, joined by a bar.
Region joinedBalls(const WorkImage& work, double barRadius) {
  Region out{std::vector<std::uint8_t>(work.cells().count(), 0)};
  const auto& n = work.cells().grid.size;
  forBox({{0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}}, [&](const std::array<int, 3>& c) {
    const Vec3 p(c[0], c[1], c[2]);
    const bool isBar = std::hypot(p[1] - 20, p[2] - 20) <= barRadius && p[0] > kLeft[0] && p[0] < kRight[0];
    out.inside[work.cells().at(c)] = (p - kLeft).norm() < 10 || (p - kRight).norm() < 10 || isBar;
  });
  return out;
}

CellClick clickAt(const WorkImage& work, const Vec3& place) {
  return {place, work.cells().at(work.cells().nearest(place)), 1};
}

//! Where nothing is found.
class NoRegions : public RegionSource {
 public:
  std::vector<RankedRegion> rank(const std::vector<CellClick>&, const std::vector<CellClick>&) override {
    return {};
  }
  std::vector<std::shared_ptr<const Region>> onImage(const std::vector<OfferedRegion>&) override {
    return {};
  }
  ClickSearches searchesAround(const Vec3&) const override { return {}; }
};

}  // namespace

TEST_CASE("a surface that settles does not let go of what hangs on something thin") {
  const WorkImage work = silentImage();
  const ObjectPolicy policy;
  const GivenClick first{clickAt(work, kLeft), true};
  const GivenClick click{clickAt(work, Vec3(16, 20, 28)), false};
  const auto holdsRight = [&](const Region& r) { return r.inside[clickAt(work, kRight).cell] != 0; };
  for (const double bar : {1.0, 4.0}) {
    const Region before = joinedBalls(work, bar);
    const double depth = depthBehindSurface(work, before, click.click.cell);
    REQUIRE(depth < policy.shallow * deepestInside(work, before));
    const std::vector<GivenClick> done{first, click};
    const Region alone = settled(
        work, before, {click.click, depth, 1000, kNoise, {first.click}, {click.click}, false}, policy);
    const bool comesApart = !holdsRight(tidied(work, alone, done, policy));
    REQUIRE(comesApart == (bar < 2));
    NoRegions nothing;
    Corrected corrected{before, done};
    correct({nothing, work, kNoise, policy, 1}, corrected, depth);
    CAPTURE(bar);
    CHECK(holdsRight(corrected.region));
    CHECK(isTrue(corrected.region, click));
    // Elsewhere it settles, if it may: the far ball shrinks, as nothing but noise holds it.
    int farther = 0;
    for (std::size_t i = 0; i < before.inside.size(); ++i)
      farther += work.cells().cellOf(i)[0] > 40 && corrected.region.inside[i] != before.inside[i];
    CHECK((farther > 0) == !comesApart);
  }
}

TEST_CASE("a click just half as deep as the object's deepest place only moves the surface") {
  const WorkImage work = silentImage();
  const GivenClick first{clickAt(work, kLeft), true}, click{clickAt(work, Vec3(16, 20, 25)), false};
  const Region before = joinedBalls(work, 4);
  const double deepest = deepestInside(work, before);
  const auto looksFor = [&](double depth) {
    class Counting : public NoRegions {
     public:
      std::vector<RankedRegion> rank(const std::vector<CellClick>&, const std::vector<CellClick>&) override {
        ++asked;
        return {};
      }
      int asked = 0;
    } source;
    Corrected corrected{before, {first, click}};
    correct({source, work, kNoise, {}, 1}, corrected, depth);
    return source.asked > 0;
  };
  CHECK_FALSE(looksFor(0.5 * deepest));
  CHECK_FALSE(looksFor(0.5 * deepest + 1e-7));  // distances in cells, one of them in single precision
  CHECK(looksFor(0.5 * deepest + 0.01));
}
