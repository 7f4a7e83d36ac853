#include "core/object/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

constexpr std::array<int, 3> kSize{19, 7, 23};  // more lines than are read at once, and fewer
const Vec3 kSpacing(0.7, 1.0, 2.5);

//! Cell by cell against every marked one.
void expectExact(const std::vector<std::uint8_t>& mask) {
  const std::vector<float> found = distanceTo(kSize, kSpacing, mask);
  const auto place = [](std::size_t i) {
    const std::size_t x = i % 19, y = i / 19 % 7, z = i / (19 * 7);
    return Vec3(
        Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)).cwiseProduct(kSpacing));
  };
  for (std::size_t i = 0; i < mask.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < mask.size(); ++j)
      if (mask[j]) nearest = std::min(nearest, (place(i) - place(j)).norm());
    if (std::isinf(nearest))
      CHECK(std::isinf(found[i]));
    else
      CHECK(found[i] == Approx(nearest).margin(1e-5));
  }
}

}  // namespace

TEST_CASE("the distance to marked cells is that to the nearest, in a grid of unequal spacings") {
  std::mt19937 random(3);
  for (const double part : {0.002, 0.05, 0.9}) {
    std::bernoulli_distribution marked(part);
    std::vector<std::uint8_t> mask(19 * 7 * 23);
    for (auto& m : mask) m = marked(random);
    expectExact(mask);
  }
}

TEST_CASE("where nothing is marked every distance is infinite, and none where all is") {
  expectExact(std::vector<std::uint8_t>(19 * 7 * 23, 0));
  expectExact(std::vector<std::uint8_t>(19 * 7 * 23, 1));
}

TEST_CASE("distances are the same bits with any number of threads") {
  std::mt19937 random(8);
  std::bernoulli_distribution marked(0.001);
  const std::array<int, 3> size{131, 70, 90};
  std::vector<std::uint8_t> mask(131 * 70 * 90);
  for (auto& m : mask) m = marked(random);
  const std::vector<float> one = distanceTo(size, kSpacing, mask);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  for (const int threads : {2, 3, 8}) CHECK(distanceTo(size, kSpacing, mask, kNone, threads) == one);
}

TEST_CASE("the greatest distance is that of the furthest cell that has one") {
  std::mt19937 random(5);
  for (const double part : {0.0, 0.002, 0.05, 1.0}) {
    std::bernoulli_distribution marked(part);
    std::vector<std::uint8_t> mask(19 * 7 * 23);
    for (auto& m : mask) m = marked(random);
    float most = 0;
    for (const float d : distanceTo(kSize, kSpacing, mask))
      if (std::isfinite(d)) most = std::max(most, d);
    CHECK(greatestDistanceTo(kSize, kSpacing, mask) == static_cast<double>(most));
  }
}

TEST_CASE("up to a limit distances are the same bits as without one, beyond it they are told to be further") {
  std::mt19937 random(6);
  std::bernoulli_distribution marked(0.00003);
  const std::array<int, 3> size{40, 50, 60};
  std::vector<std::uint8_t> mask(40 * 50 * 60);
  for (auto& m : mask) m = marked(random);
  const std::vector<float> all = distanceTo(size, kSpacing, mask);
  constexpr double kLimit = 41;
  const std::vector<float> near = distanceTo(size, kSpacing, mask, kLimit);
  std::size_t beyond = 0, wrong = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    beyond += all[i] > kLimit;
    wrong += all[i] <= kLimit ? near[i] != all[i] : near[i] <= kLimit;
  }
  CHECK(beyond > 0);
  CHECK(wrong == 0);
}
