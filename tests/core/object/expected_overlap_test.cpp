#include "core/object/expected_overlap.h"

#include <random>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

//! Regions told apart by their volumes (mm³) only.
LikelyRegions made(std::vector<double> likelihood, std::vector<std::vector<double>> overlap) {
  LikelyRegions out;
  for (std::size_t i = 0; i < likelihood.size(); ++i) {
    out.regions.emplace_back();
    out.regions.back().volume = static_cast<double>(i);
  }
  out.likelihood = std::move(likelihood);
  out.overlap = std::move(overlap);
  return out;
}

std::vector<int> order(const std::vector<OfferedRegion>& offered) {
  std::vector<int> out;
  for (const OfferedRegion& o : offered) out.push_back(static_cast<int>(o.region.volume));
  return out;
}

//! A dark ball of radius 9 in noise.
Volume ball() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 12);
  return volumeByIndex(cubicGrid(60), [&](int i, int j, int k) {
    return ((Vec3(i, j, k) - Vec3(30, 30, 30)).norm() < 9 ? 40 : 120) + normal(random);
  });
}

std::unique_ptr<ClickSearch> search(const Volume& volume, double reach, std::size_t most,
                                    const Vec3& click = Vec3(30, 30, 30)) {
  const CellGrid cells = cellsAround(volume.grid, click, reach, most);
  return std::make_unique<ClickSearch>(searchAround(volume, cells, click, nullptr, ObjectPolicy{}, 1));
}

bool holdsVoxel(const RankedRegion& r, int x, int y, int z) {
  const CellGrid& cells = r.search->image.cells;
  std::array<int, 3> c{x, y, z};
  for (std::size_t a = 0; a < 3; ++a) {
    c[a] -= cells.low[a];
    if (c[a] < 0) return false;
    c[a] /= cells.factor[a];
    if (c[a] >= cells.grid.size[a]) return false;
  }
  return r.holds(cells.at(c));
}

double diceByVoxels(const RankedRegion& a, const RankedRegion& b) {
  double both = 0, sum = 0;
  for (int z = 0; z < 60; ++z)
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) {
        const bool inA = holdsVoxel(a, x, y, z), inB = holdsVoxel(b, x, y, z);
        both += inA && inB;
        sum += inA + inB;
      }
  return 2 * both / sum;
}

}  // namespace

TEST_CASE("offered first is what shares most with all that may be meant, not the likeliest") {
  // Three sizes: the middle one is like both others, which are hardly like each other.
  const auto offered =
      offeredRegions(made({0.4, 0.25, 0.35}, {{1, 0.6, 0.2}, {0.6, 1, 0.6}, {0.2, 0.6, 1}}), {});
  REQUIRE(order(offered) == std::vector{1, 0, 2});  // then what adds most
  CHECK(offered[0].expected == Approx(0.4 * 0.6 + 0.25 + 0.35 * 0.6));
  CHECK(offered[1].expected == Approx(0.4 + 0.25 * 0.6 + 0.35 * 0.2));
}

TEST_CASE("of much the same regions the one with the best score is offered, once") {
  const auto offered = offeredRegions(
      made({0.3, 0.2, 0.3, 0.2},
           {{1, 0.9, 0.88, 0.1}, {0.9, 1, 0.95, 0.1}, {0.88, 0.95, 1, 0.1}, {0.1, 0.1, 0.1, 1}}),
      {});
  CHECK(order(offered) == std::vector{0, 3});
}

TEST_CASE("no more regions are offered than the policy says") {
  ObjectPolicy policy;
  policy.offered = 1;
  CHECK(offeredRegions(made({0.5, 0.5}, {{1, 0}, {0, 1}}), policy).size() == 1);
  CHECK(offeredRegions({}, policy).empty());
}

TEST_CASE("overlaps are those of the voxels, also between regions of different searches and cells") {
  const Volume volume = ball();
  std::vector<std::unique_ptr<ClickSearch>> searches;
  searches.push_back(search(volume, 16, 1'000'000));
  searches.push_back(search(volume, 100, 40'000));
  REQUIRE(searches[1]->image.cells.factor != std::array{1, 1, 1});
  std::vector<RankedRegion> ranked = rankRegions(searches, {});
  ObjectPolicy policy;
  policy.likely = 12;
  const LikelyRegions likely = likelyRegions(ranked, policy);
  REQUIRE(likely.regions.size() == 12);
  std::size_t acrossSearches = 0;
  double sum = 0;
  for (std::size_t i = 0; i < likely.regions.size(); ++i) {
    sum += likely.likelihood[i];
    for (std::size_t j = 0; j < likely.regions.size(); ++j) {
      const RankedRegion &a = likely.regions[i], &b = likely.regions[j];
      CHECK(likely.overlap[i][j] == likely.overlap[j][i]);
      acrossSearches += a.search != b.search;
      CHECK(likely.overlap[i][j] == Approx(diceByVoxels(a, b)).margin(1e-9));
    }
  }
  CHECK(sum == Approx(1));
  CHECK(acrossSearches > 0);
}

TEST_CASE("a click near the rim of a region lowers its score, and hardly one in its middle") {
  const Volume volume = ball();
  const auto lowered = [&](const Vec3& click) {
    std::vector<std::unique_ptr<ClickSearch>> searches;
    searches.push_back(search(volume, 100, 1'000'000, click));
    std::vector<RankedRegion> ranked = rankRegions(searches, {});
    const LikelyRegions likely = likelyRegions(ranked, {});
    const double radius = 9, wanted = 4.0 / 3 * 3.14159265 * radius * radius * radius;
    const RankedRegion* like = &likely.regions[0];  // the ball
    for (const RankedRegion& r : likely.regions)
      if (std::abs(r.volume - wanted) < std::abs(like->volume - wanted)) like = &r;
    CHECK(like->volume == Approx(wanted).epsilon(0.1));
    for (const RankedRegion& r : ranked)
      if (r.map == like->map && r.rung == like->rung) return r.score - like->score;
    return -1.0;
  };
  CHECK(lowered(Vec3(30, 30, 30)) == 0);
  // Two of nine mm deep: 0.4 log(0.5 / 0.2), to a cell.
  const double nearRim = lowered(Vec3(37, 30, 30));
  CHECK(nearRim > 0.15);
  CHECK(nearRim < 0.65);
}
