#include "core/volume/intensity_statistics.h"

#include <algorithm>
#include <random>

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

TEST_CASE("a quantile of many equal values is that value") {
  CHECK(quantile(std::vector<float>(200'000, -2.5F), 0.3) == -2.5);
}
