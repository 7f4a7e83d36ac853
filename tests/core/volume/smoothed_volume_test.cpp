#include "core/volume/smoothed_volume.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

// Bricks are 32 voxels wide: this grid has 3 × 2 × 2 of them.
Grid manyBricks() {
  Grid grid;
  grid.size = {70, 40, 37};
  grid.spacing = Vec3(1, 0.8, 1.5);
  return grid;
}

Volume randomVolume(const Grid& grid, unsigned seed) {
  std::mt19937 random(seed);
  return volumeByIndex(grid, [&](int, int, int) { return static_cast<double>(random() % 1000); });
}

std::vector<double> weights(double sigma) {
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> w;
  double sum = 0;
  for (int t = -radius; t <= radius; ++t) {
    w.push_back(std::exp(-0.5 * t * t / (sigma * sigma)));
    sum += w.back();
  }
  for (double& x : w) x /= sum;
  return w;
}

//! The Gaussian, cut at three standard deviations, at one voxel: the sum over all voxels it reaches; the
//! border's values repeat beyond it.
double directly(const Volume& volume, double sigma, int i, int j, int k) {
  const Grid& g = volume.grid;
  const std::vector<double> wx = weights(sigma / g.spacing[0]), wy = weights(sigma / g.spacing[1]),
                            wz = weights(sigma / g.spacing[2]);
  const auto reach = [](const std::vector<double>& w) { return static_cast<int>(w.size() / 2); };
  const auto clampTo = [&](int x, std::size_t a) { return std::clamp(x, 0, g.size[a] - 1); };
  double sum = 0;
  for (int c = 0; c < static_cast<int>(wz.size()); ++c)
    for (int b = 0; b < static_cast<int>(wy.size()); ++b)
      for (int a = 0; a < static_cast<int>(wx.size()); ++a) {
        const int x = clampTo(i + a - reach(wx), 0), y = clampTo(j + b - reach(wy), 1),
                  z = clampTo(k + c - reach(wz), 2);
        sum += wx[a] * wy[b] * wz[c] *
               static_cast<double>(volume.data<float>()[(z * g.size[1] + y) * g.size[0] + x]);
      }
  return sum;
}

std::vector<std::array<int, 3>> allVoxels(const Grid& grid) {
  std::vector<std::array<int, 3>> voxels;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) voxels.push_back({i, j, k});
  return voxels;
}

}  // namespace

TEST_CASE("without smoothing every voxel keeps its value") {
  const Volume volume = randomVolume(manyBricks(), 1);
  const SmoothedVolume smoothed(volume, 0);
  std::size_t n = 0;
  for (const auto& [i, j, k] : allVoxels(volume.grid))
    REQUIRE(smoothed.at(i, j, k) == volume.data<float>()[n++]);
}

TEST_CASE("a constant image stays constant under smoothing, up to its border") {
  const SmoothedVolume smoothed(volumeByIndex(manyBricks(), [](int, int, int) { return 250; }), 1.7);
  // Three sums of about ten products in single precision.
  for (const auto& [i, j, k] : allVoxels(manyBricks()))
    REQUIRE(smoothed.at(i, j, k) == Approx(250).epsilon(3e-6));
}

TEST_CASE("smoothing keeps a linear ramp away from the border") {
  const auto ramp = [](int i, int j, int k) { return 2.0 * i - 3.0 * j + 5.0 * k + 100; };
  const SmoothedVolume smoothed(volumeByIndex(cubicGrid(44), ramp), 1.5);
  for (int k = 5; k < 39; ++k)
    for (int j = 5; j < 39; ++j)
      for (int i = 5; i < 39; ++i) REQUIRE(smoothed.at(i, j, k) == Approx(ramp(i, j, k)).margin(1e-3));
}

TEST_CASE("the response to an impulse sums to one and is the same in all directions of space") {
  Grid grid = cubicGrid(48);
  grid.spacing = Vec3(1, 1, 0.5);
  const SmoothedVolume smoothed(
      volumeByIndex(grid, [](int i, int j, int k) { return i == 31 && j == 32 && k == 24; }), 1.2);
  double sum = 0;
  for (const auto& [i, j, k] : allVoxels(grid)) sum += static_cast<double>(smoothed.at(i, j, k));
  CHECK(sum == Approx(1).epsilon(1e-5));
  CHECK(smoothed.at(33, 32, 24) == Approx(static_cast<double>(smoothed.at(31, 30, 24))));
  // Two voxels of 1 mm, four of 0.5 mm: the same part of the value at the middle.
  CHECK(smoothed.at(33, 32, 24) == Approx(static_cast<double>(smoothed.at(31, 32, 28))).epsilon(1e-5));
}

TEST_CASE("smoothed values are finite whatever the voxels are") {
  const Grid grid = cubicGrid(20);
  void *single = nullptr, *wide = nullptr;
  const Volume singles = makeVolume(grid, VoxelType::float32, &single),
               wides = makeVolume(grid, VoxelType::float64, &wide);
  using Float = std::numeric_limits<float>;
  using Double = std::numeric_limits<double>;
  const std::array<float, 4> floats{Float::max(), -Float::max(), Float::quiet_NaN(), -Float::infinity()};
  const std::array<double, 4> doubles{Double::max(), -1e39, Double::quiet_NaN(), Double::infinity()};
  // Blocks of each: neighbours of one sign are what overflows when they are added.
  for (std::size_t i = 0; i < grid.voxelCount(); ++i) {
    const std::size_t block = i / 5 % 5;
    static_cast<float*>(single)[i] = block == 4 ? 7 : floats[block];
    static_cast<double*>(wide)[i] = block == 4 ? 7 : doubles[block];
  }
  for (const double sigma : {0.0, 1.5})
    for (const Volume& volume : {singles, wides}) {
      const SmoothedVolume smoothed(volume, sigma);
      for (const auto& [i, j, k] : allVoxels(grid)) REQUIRE(std::isfinite(smoothed.at(i, j, k)));
      REQUIRE(std::isfinite(smoothed.sample(Vec3(2.5, 3.5, 4.5))));
    }
}

TEST_CASE("smoothing in bricks equals the sum over the whole image, also across the borders of bricks") {
  const Volume volume = randomVolume(manyBricks(), 2);
  const double sigma = 1.6;
  const SmoothedVolume smoothed(volume, sigma);
  for (int i : {0, 1, 30, 31, 32, 33, 63, 64, 69})
    for (int j : {0, 17, 31, 32, 39})
      for (int k : {0, 31, 32, 36})
        REQUIRE(static_cast<double>(smoothed.at(i, j, k)) ==
                Approx(directly(volume, sigma, i, j, k)).margin(2e-3));  // values up to 1000 in floats
}

TEST_CASE("smoothed values are the same bits whoever asks first, forwards, backwards or from threads") {
  const Volume volume = randomVolume(manyBricks(), 3);
  const auto voxels = allVoxels(volume.grid);
  const SmoothedVolume forwards(volume, 1), backwards(volume, 1), threaded(volume, 1);
  std::vector<float> first, second(voxels.size());
  for (const auto& [i, j, k] : voxels) first.push_back(forwards.at(i, j, k));
  for (std::size_t n = voxels.size(); n-- > 0;)
    second[n] = backwards.at(voxels[n][0], voxels[n][1], voxels[n][2]);
  CHECK(first == second);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 3; ++t)
      threads.emplace_back([&, t] {
        for (std::size_t n = t; n < voxels.size(); n += 3)
          second[n] = threaded.at(voxels[n][0], voxels[n][1], voxels[n][2]);
      });
  }
  CHECK(first == second);
}

TEST_CASE("trilinear sampling is exact on multilinear functions, also between bricks") {
  const auto f = [](double x, double y, double z) {
    return 3 + 2 * x - y + 4 * z + x * y - 2 * y * z + x * z + 0.5 * x * y * z;
  };
  const Grid grid = manyBricks();
  const SmoothedVolume smoothed(volumeByIndex(grid, f), 0);
  std::mt19937 random(4);
  // Quarters and voxel values of less than 24 bits: nothing is rounded.
  const auto coordinate = [&](int size) {
    return 0.25 * static_cast<double>(random() % static_cast<unsigned>(4 * size - 3));
  };
  for (int n = 0; n < 5000; ++n) {
    const Vec3 p(coordinate(70), coordinate(40), coordinate(37));
    REQUIRE(smoothed.sample(p) == f(p.x(), p.y(), p.z()));
  }
  for (double x = 30.75; x <= 33; x += 0.125)
    REQUIRE(smoothed.sample(Vec3(x, 31.5, 31.5)) == f(x, 31.5, 31.5));
}

TEST_CASE("a sample outside the image is the nearest one on its border") {
  const Volume volume = randomVolume(manyBricks(), 5);
  const SmoothedVolume smoothed(volume, 1);
  CHECK(smoothed.sample(Vec3(-7, 3.5, 90)) == smoothed.sample(Vec3(0, 3.5, 36)));
  CHECK(smoothed.sample(Vec3(69.4, -0.1, 2)) == smoothed.sample(Vec3(69, 0, 2)));
  CHECK(smoothed.sample(Vec3(69, 39, 36)) == static_cast<double>(smoothed.at(69, 39, 36)));
}

TEST_CASE("an image of one slice can be smoothed and sampled") {
  Grid grid;
  grid.size = {9, 9, 1};
  const SmoothedVolume smoothed(volumeByIndex(grid, [](int i, int, int) { return 10 * i; }), 0);
  CHECK(smoothed.sample(Vec3(4.5, 3.25, 0)) == 45);
  CHECK(smoothed.sample(Vec3(4.5, 3.25, 0.4)) == 45);
}

TEST_CASE("padding counts as the wall value, as if the voxels held it") {
  const Grid grid = cubicGrid(40);
  const auto image = [&](double padding) {
    return volumeByIndex(
        grid, [padding](int i, int j, int k) { return i < 4 ? padding : 1 + i + 40.0 * j + 1600.0 * k; });
  };
  const Volume volume = image(-3000);
  const auto view = FieldOfView::find(volume);
  REQUIRE(view != nullptr);
  const SmoothedVolume walled(volume, 1.5, view, 777), replaced(image(777), 1.5), plain(volume, 1.5);
  for (const auto& [i, j, k] : allVoxels(grid)) REQUIRE(walled.at(i, j, k) == replaced.at(i, j, k));
  CHECK(walled.at(5, 20, 20) > plain.at(5, 20, 20));
  CHECK(walled.isPadding(0));
  CHECK_FALSE(plain.isPadding(0));
}
