#include "core/volume/intensity_statistics.h"

#include <algorithm>
#include <array>
#include <random>

#include "core/volume/not_a_number.h"
#include "tests/support/catch.h"

using namespace handlebody;

TEST_CASE("a quantile is the value at its rank, of few values and of many, of either sign") {
  std::mt19937 random(4);
  for (const std::size_t count : {1UL, 1000UL, 300'000UL}) {
    for (const float width : {1e-4F, 30.F, 1e30F}) {
      std::normal_distribution<float> value(0.3F * width, width);
      std::vector<float> values(count);
      for (float& v : values) v = value(random);
      std::vector<float> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      for (const double q : {0.0, 0.01, 0.5, 0.99, 1.0}) {
        const auto rank = static_cast<std::size_t>(q * static_cast<double>(count - 1));
        CHECK(quantile(values, q) == static_cast<double>(sorted[rank]));
      }
    }
  }
}

TEMPLATE_TEST_CASE("voxels that were not a number in their file are in no statistics", "", float, double) {
  Grid grid;
  grid.size = {10, 10, 3};
  void* buffer = nullptr;
  const Volume volume =
      makeVolume(grid, sizeof(TestType) == 4 ? VoxelType::float32 : VoxelType::float64, &buffer);
  auto* voxels = static_cast<TestType*>(buffer);
  // Two thirds of the volume; the rest are 1 to 100.
  for (int i = 0; i < 300; ++i)
    voxels[i] = i % 3 == 0 ? static_cast<TestType>(i / 3 + 1) : notANumberBelow(TestType{1});
  const std::array percents{0.0, 50.0, 100.0};
  const IntensityStatistics s = intensityStatistics(volume, percents);
  CHECK(s.minimum == 1);
  CHECK(s.maximum == 100);
  CHECK(s.mean == Approx(50.5));
  CHECK(s.percentiles == std::vector<double>{1, 50, 100});
}

TEST_CASE("a quantile of many equal values is that value") {
  CHECK(quantile(std::vector<float>(200'000, -2.5F), 0.3) == -2.5);
}
