#include "sample_volumes/noise.h"

#include <cmath>
#include <numbers>

#include "tests/phantoms/helpers.h"

using namespace handlebody;
using namespace handlebody::phantoms;
using namespace handlebody::phantomtest;

namespace {

struct Moments {
  double mean = 0, deviation = 0, kurtosis = 0;
};

template <typename Values>
Moments momentsOf(const Values& values) {
  Moments m;
  const auto n = static_cast<double>(values.size());
  for (double v : values) m.mean += v / n;
  double second = 0, fourth = 0;
  for (double v : values) {
    const double square = (v - m.mean) * (v - m.mean);
    second += square / n;
    fourth += square * square / n;
  }
  m.deviation = std::sqrt(second);
  m.kurtosis = fourth / (second * second);
  return m;
}

Grid cubeGrid(int n) {
  Grid grid;
  grid.size = {n, n, n};
  return grid;
}

}  // namespace

TEST_CASE("normal numbers have the moments of the normal distribution and their halves are independent") {
  std::vector<double> values, products;
  for (std::uint64_t i = 0; i < 200000; ++i) {
    const auto [x, y] = normalPair(42, i);
    values.push_back(x);
    values.push_back(y);
    products.push_back(x * y);
  }
  const Moments m = momentsOf(values);
  // Five standard errors of 400,000 numbers: 1/sqrt(n), 1/sqrt(2n), sqrt(24/n).
  CHECK(std::abs(m.mean) < 0.008);
  CHECK(m.deviation == Approx(1).margin(0.006));
  CHECK(m.kurtosis == Approx(3).margin(0.04));
  CHECK(std::abs(momentsOf(products).mean) < 0.012);
}

TEST_CASE("normal numbers of neighbouring counters and seeds are uncorrelated") {
  double counters = 0, seeds = 0;
  constexpr int kCount = 100000;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    counters += normalPair(1, i).first * normalPair(1, i + 1).first / kCount;
    seeds += normalPair(1, i).first * normalPair(2, i).first / kCount;
  }
  CHECK(std::abs(counters) < 0.016);  // five standard errors
  CHECK(std::abs(seeds) < 0.016);
}

TEST_CASE("the speckle envelope is Rayleigh distributed before compression") {
  const std::vector<float> envelope = speckleEnvelope(cubeGrid(96), Vec3(1.5, 1.5, 0.7), 5);
  const Moments m = momentsOf(envelope);
  const double pi = std::numbers::pi;
  CHECK(m.mean / m.deviation == Approx(std::sqrt(pi / (4 - pi))).epsilon(0.02));  // 1.91
  CHECK(m.mean == Approx(std::sqrt(pi / 4)).epsilon(0.02));                       // mean square 1
  std::vector<double> compressed;
  for (float a : envelope) compressed.push_back(compressedSpeckle(a));
  const Moments c = momentsOf(compressed);
  CHECK(std::abs(c.mean) < 0.02);
  CHECK(c.deviation == Approx(1).epsilon(0.02));
}

TEST_CASE("speckle is as long as the point spread function along each axis, in mm") {
  Grid grid = cubeGrid(96);
  grid.spacing = Vec3(0.5, 1, 1);
  const Vec3 spread(1.5, 1.5, 0.7);
  const std::vector<float> envelope = speckleEnvelope(grid, spread, 9);
  std::vector<double> intensity;
  for (float a : envelope) intensity.push_back(static_cast<double>(a) * a);
  const std::array<std::size_t, 3> step{1, 96, 96 * 96};
  for (int axis = 0; axis < 3; ++axis) {
    // The intensity's correlation is the square of the field's: exp(-x²/(2σ²)) at x mm.
    const std::size_t lag = step[axis];
    double sum = 0;
    for (std::size_t i = 0; i + lag < intensity.size(); ++i)
      sum += (intensity[i] - 1) * (intensity[i + lag] - 1);
    const double x = grid.spacing[axis] / spread[axis];
    CHECK(sum / static_cast<double>(intensity.size()) == Approx(std::exp(-x * x / 2)).margin(0.04));
  }
}

TEST_CASE("the noise of a phantom has the promised standard deviation on every scale") {
  const double contrast[] = {120, 1000, 0.5};
  const VoxelType types[] = {VoxelType::uint8, VoxelType::int16, VoxelType::float32};
  for (int k = 0; k < 3; ++k)
    for (const char* name : {"torus", "cyst"}) {
      INFO(name << " " << voxelTypeName(types[k]));
      PhantomOptions options;
      options.type = types[k];
      options.noise = 0.08;  // so small that 8 bit do not clip it
      if (name == std::string("cyst")) options.spacing = Vec3(2, 2, 2);
      const std::vector<double> noisy = voxelsOf(makePhantom(name, options).volume);
      options.noise = 0;
      const std::vector<double> clean = voxelsOf(makePhantom(name, options).volume);
      std::vector<double> noise;
      for (std::size_t i = 0; i < noisy.size(); ++i) noise.push_back(noisy[i] - clean[i]);
      const Moments m = momentsOf(noise);
      CHECK(m.deviation / contrast[k] == Approx(0.08).epsilon(0.03));
      CHECK(std::abs(m.mean) / contrast[k] < 0.002);
    }
}
