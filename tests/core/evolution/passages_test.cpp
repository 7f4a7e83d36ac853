// The map of narrow passages: what spares it work changes nothing.
#include "core/evolution/passages.h"

#include <random>

#include "core/evolution/space_tree.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

constexpr int kSide = 24;

//! The radii of the largest balls, roughly, of a few balls and bars at random.
std::vector<float> randomSpaces(std::mt19937& random) {
  std::uniform_real_distribution<double> place(3, kSide - 4), wide(1.5, 9);
  struct Ball {
    Vec3 centre;
    double radius;
  };
  std::vector<Ball> balls;
  for (int n = std::uniform_int_distribution<int>(1, 6)(random); n > 0; --n)
    balls.push_back({Vec3(place(random), place(random), place(random)), wide(random)});
  std::vector<float> radius(kSide * kSide * kSide, 0.0f);
  for (int z = 1; z < kSide - 1; ++z)
    for (int y = 1; y < kSide - 1; ++y)
      for (int x = 1; x < kSide - 1; ++x) {
        double most = 0;
        for (const Ball& b : balls) most = std::max(most, b.radius - (Vec3(x, y, z) - b.centre).norm());
        radius[(z * kSide + y) * kSide + x] = static_cast<float>(most);
      }
  return radius;
}

//! Two boxes with a hole between them, in noise.
ObjectImage twoChambers() {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 40);
  const auto inBox = [](int i, int j, int k, int first) {
    return i >= first && i < first + 36 && j >= 20 && j < 70 && k >= 20 && k < 70;
  };
  const Volume volume = volumeByIndex(cubicGrid(91), [&](int i, int j, int k) {
    const bool isHole = i >= 40 && i < 60 && std::hypot(j - 45, k - 45) < 4;
    return (inBox(i, j, k, 6) || inBox(i, j, k, 50) || isHole ? 50 : 150) + noise(random);
  });
  return ObjectImage(std::make_shared<SmoothedVolume>(volume, 0.7), {-1e300, 100}, 90);
}

}  // namespace

TEST_CASE("where it is sure that no passage is narrow the tree of spaces tells none", "[leaks]") {
  std::mt19937 random(11);
  const std::array<int, 3> size{kSide, kSide, kSide};
  int sure = 0, told = 0;
  for (int run = 0; run < 400; ++run) {
    const std::vector<float> radius = randomSpaces(random);
    std::vector<std::uint32_t> starts;
    for (int n = 0; n < 1 + run % 2; ++n)
      starts.push_back(std::uniform_int_distribution<std::uint32_t>(0, kSide * kSide * kSide - 1)(random));
    starts.push_back(
        static_cast<std::uint32_t>(std::max_element(radius.begin(), radius.end()) - radius.begin()));
    if (run % 4 == 0) starts.pop_back();
    NarrowRule rule;
    rule.narrow = run % 3 == 0 ? 0.8 : 0.41;
    const bool isSure = surelyTellsNothing(size, radius, starts, rule);
    const bool tells = !SpaceTree(size, radius).merge(starts, rule).empty();
    CHECK(!(isSure && tells));
    sure += isSure;
    told += tells;
  }
  CHECK(sure > 40);
  CHECK(told > 10);
}

TEST_CASE("all that is wide hangs together by a corner, too", "[leaks]") {
  const std::array<int, 3> size{7, 7, 7};
  std::vector<float> radius(343, 0.0f);
  const auto cell = [](int x, int y, int z) { return static_cast<std::uint32_t>((z * 7 + y) * 7 + x); };
  const std::vector<std::uint32_t> start{cell(3, 3, 3)};
  radius[start[0]] = 3;
  for (int corner = 0; corner < 26; ++corner) {
    const int n = corner < 13 ? corner : corner + 1;
    const std::uint32_t beside = cell(2 + n % 3, 2 + n / 3 % 3, 2 + n / 9);
    radius[beside] = 3;
    CHECK(surelyTellsNothing(size, radius, start, {}));
    radius[beside] = 0;
  }
  radius[cell(5, 3, 3)] = 3;
  CHECK(!surelyTellsNothing(size, radius, start, {}));
}

TEST_CASE("the map of passages is the same with any number of threads", "[leaks]") {
  const ObjectImage image = twoChambers();
  const VoxelBox box{{0, 0, 0}, {90, 90, 90}};
  const std::vector<Vec3> starts{Vec3(20, 45, 45)};
  const PassageMap one(image, nullptr, box, starts, 1);
  REQUIRE(one.passages().size() == 1);
  for (const int threads : {2, 3, 8}) {
    const PassageMap map(image, nullptr, box, starts, threads);
    REQUIRE(map.passages().size() == 1);
    CHECK(map.passages()[0].place == one.passages()[0].place);
    CHECK(map.passages()[0].radius == one.passages()[0].radius);
    CHECK(map.passages()[0].behind == one.passages()[0].behind);
    int different = 0;
    for (int i = 0; i < 91 * 91 * 91; ++i) {
      const Vec3 place(i % 91, i / 91 % 91, i / (91 * 91));
      different += map.behindWhich(place) != one.behindWhich(place);
    }
    CHECK(different == 0);
  }
}

TEST_CASE("the voxels of a row are held as each by itself") {
  const ObjectImage image = twoChambers();
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(0, 90);
  for (int run = 0; run < 200; ++run) {
    const int x = any(random), y = any(random), z = any(random), n = 91 - x;
    std::vector<std::uint8_t> held(n, 7);
    image.holdsRow({x, y, z}, n, held.data());
    int different = 0;
    for (int i = 0; i < n; ++i) different += held[i] != (image.holds({x + i, y, z}) ? 1 : 0);
    CHECK(different == 0);
  }
}
