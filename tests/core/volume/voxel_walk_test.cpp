#include "core/volume/voxel_walk.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

constexpr std::array<std::array<int, 3>, 5> kBoxes{{{4, 3, 5}, {1, 1, 1}, {7, 1, 1}, {1, 5, 2}, {2, 2, 2}}};

std::array<int, 3> placeOf(const std::array<int, 3>& size, std::size_t voxel) {
  const int number = static_cast<int>(voxel);
  return {number % size[0], number / size[0] % size[1], number / (size[0] * size[1])};
}

}  // namespace

TEST_CASE("the neighbours of a voxel by its faces are those one step away, each once, with their axis") {
  for (const auto& size : kBoxes) {
    const std::size_t count = idx(size[0]) * idx(size[1]) * idx(size[2]);
    for (std::size_t v = 0; v < count; ++v) {
      const auto c = placeOf(size, v);
      std::set<std::size_t> found, expected;
      forFaceNeighbours(size, v, [&](std::size_t w, std::size_t axis) {
        REQUIRE(w < count);
        CHECK(found.insert(w).second);
        CHECK(std::abs(placeOf(size, w)[axis] - c[axis]) == 1);
      });
      for (std::size_t w = 0; w < count; ++w) {
        const auto d = placeOf(size, w);
        int apart = 0;
        for (std::size_t a = 0; a < 3; ++a) apart += std::abs(d[a] - c[a]);
        if (apart == 1) expected.insert(w);
      }
      CHECK(found == expected);
    }
  }
}

TEST_CASE("values between centres are exact for what is linear along each axis, and constant beyond") {
  const auto value = [](const Vec3& p) { return (2 + p.x()) * (1 - 3 * p.y()) * (0.5 + p.z()); };
  std::mt19937 random(5);
  const auto upTo = [&](double most) { return std::uniform_real_distribution<double>(-1, most + 1)(random); };
  for (const auto& size : kBoxes) {
    std::vector<float> values;
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x) values.push_back(static_cast<float>(value(Vec3(x, y, z))));
    const Vec3 last(size[0] - 1, size[1] - 1, size[2] - 1);
    for (int i = 0; i < 50; ++i) {
      const Vec3 p(upTo(last.x()), upTo(last.y()), upTo(last.z()));
      const Vec3 inside = p.cwiseMax(Vec3::Zero()).cwiseMin(last);
      CHECK(trilinear(values.data(), size, p) == Approx(value(inside)).margin(1e-9));
    }
  }
}

TEST_CASE("a value without weight does not count, not even one that is infinite") {
  const std::vector<float> values{3, std::numeric_limits<float>::infinity()};
  CHECK(trilinear(values.data(), {2, 1, 1}, Vec3(0, 0, 0)) == 3);
  CHECK(std::isinf(trilinear(values.data(), {2, 1, 1}, Vec3(0.5, 0, 0))));
}
