#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/phantoms/helpers.h"

using namespace handlebody;
using namespace handlebody::phantomtest;

namespace {

PhantomOptions noiseFree(VoxelType type = VoxelType::uint8) {
  PhantomOptions options;
  options.noise = 0;
  options.type = type;
  return options;
}

double diceOfThreshold(const Phantom& phantom) {
  const std::vector<double> values = voxelsOf(phantom.volume);
  const std::vector<double> truth = voxelsOf(phantom.truth);
  double both = 0, sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool dark = values[i] < halfLevel(phantom.volume.type);
    both += dark && truth[i] > 0;
    sum += dark + truth[i];
  }
  return 2 * both / sum;
}

// Mean distance (mm) of the half-level crossings along the grid's rows to the ideal surface.
double meanCrossingDistance(const Phantom& phantom, const PhantomOptions& options) {
  const std::vector<double> values = voxelsOf(phantom.volume);
  const Grid& grid = phantom.volume.grid;
  const double half = halfLevel(phantom.volume.type);
  double sum = 0;
  int count = 0;
  std::size_t i = 0;
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x, ++i) {
        if (x + 1 == grid.size[0] || (values[i] < half) == (values[i + 1] < half)) continue;
        const double t = (half - values[i]) / (values[i + 1] - values[i]);
        sum += std::abs(phantomDistance(phantom.name, options, grid.toWorld(Vec3(x + t, y, z))));
        ++count;
      }
  return sum / count;
}

bool sameVoxels(const Volume& a, const Volume& b) {
  return a.type == b.type && a.grid.voxelCount() == b.grid.voxelCount() &&
         std::memcmp(a.voxels.get(), b.voxels.get(), a.grid.voxelCount() * bytesPerVoxel(a.type)) == 0;
}

}  // namespace

TEST_CASE("a voxel is labelled if and only if its centre lies inside the ideal surface") {
  for (const std::string& name : phantomNames())
    for (const PhantomOptions& options : {PhantomOptions{}, oblique()}) {
      INFO(name);
      const Phantom phantom = makePhantom(name, options);
      const Grid& grid = phantom.truth.grid;
      RandomPoints random(11);
      int wrong = 0;
      for (int i = 0; i < 20000; ++i) {
        Vec3 voxel;
        std::size_t offset = 0;
        for (int a = 2; a >= 0; --a) {
          const int n = grid.size[a];
          voxel[a] = std::floor(random.uniform(0, n));
          offset = offset * static_cast<std::size_t>(n) + static_cast<std::size_t>(voxel[a]);
        }
        const double d = phantomDistance(name, options, grid.toWorld(voxel));
        // 1e-9 mm: the way through the world frame rounds.
        if (std::abs(d) > 1e-9) wrong += (d < 0) != (phantom.truth.data<std::uint8_t>()[offset] == 1);
      }
      CHECK(wrong == 0);
    }
}

TEST_CASE("the seed ball lies inside the object, wherever the volume is") {
  for (const std::string& name : phantomNames())
    for (const PhantomOptions& options : {PhantomOptions{}, oblique()}) {
      INFO(name);
      const Phantom phantom = makePhantom(name, options);
      REQUIRE(phantom.seedRadius > 0);
      RandomPoints random(2);
      double highest = phantomDistance(name, options, phantom.seed);
      for (int i = 0; i < 200; ++i)
        highest = std::max(
            highest,
            phantomDistance(name, options,
                            phantom.seed + phantom.seedRadius * random.inBox(Vec3(1, 1, 1)).normalized()));
      CHECK(highest < 0);
    }
}

TEST_CASE("thresholding the noise-free volume half way gives the truth label") {
  for (const std::string& name : phantomNames()) {
    INFO(name);
    // The wall's second chamber is dark and no part of the object: its Dice is 2·1/(2 + 1).
    const double expected = name == "wall" ? 2.0 / 3 : 1;
    // The cyst's intensity falls with depth by ±1/8 of the contrast, which moves the level by up to an eighth
    // of the ramp: 29,000 mm² of surface on 480,000 mm³, 0.06 mm on average.
    // The tree's tubes have 2/3 mm² of surface per mm³; half a grey value of 120 is 0.005 mm, which its Dice
    // shows.
    const double tolerance = name == "cyst" ? 0.004 : name == "tree" ? 0.002 : 0.001;
    CHECK(std::abs(diceOfThreshold(makePhantom(name, noiseFree())) - expected) < tolerance);
  }
}

TEST_CASE("the half-way level lies on the ideal surface for every voxel type and spacing") {
  for (const VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float32})
    for (const char* name : {"torus", "sphere", "genus3", "cube"}) {
      INFO(name << " " << voxelTypeName(type));
      PhantomOptions options = noiseFree(type);
      CHECK(meanCrossingDistance(makePhantom(name, options), options) < 0.05);
      options.spacing = Vec3(0.5, 1, 2);
      options.rotationDegrees = Vec3(-10, 80, 33);
      CHECK(meanCrossingDistance(makePhantom(name, options), options) < 0.05);
    }
}

TEST_CASE("all voxel types show the same image on their own scale") {
  PhantomOptions options;
  const std::vector<double> bytes = voxelsOf(makePhantom("sphere", options).volume);
  options.type = VoxelType::int16;
  const std::vector<double> words = voxelsOf(makePhantom("sphere", options).volume);
  options.type = VoxelType::float32;
  const std::vector<double> floats = voxelsOf(makePhantom("sphere", options).volume);
  double worst = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double contrast = (floats[i] - 0.25) / 0.5;
    worst = std::max({worst, std::abs(words[i] - (-200 + 1000 * contrast)),
                      std::abs(bytes[i] - std::clamp(60 + 120 * contrast, 0.0, 255.0))});
  }
  CHECK(worst <= 0.501);                                        // rounding to whole numbers
  CHECK(*std::min_element(words.begin(), words.end()) < -300);  // the object's noise around -200
}

TEST_CASE("the same options give the same voxels, another random seed gives others") {
  for (const char* name : {"cyst", "torus"}) {
    PhantomOptions options;
    options.spacing = Vec3(2, 2, 2);
    const Phantom first = makePhantom(name, options);
    CHECK(sameVoxels(first.volume, makePhantom(name, options).volume));
    options.randomSeed = 2;
    const Phantom other = makePhantom(name, options);
    CHECK_FALSE(sameVoxels(first.volume, other.volume));
    CHECK(sameVoxels(first.truth, other.truth));
  }
}

TEST_CASE("the needle is brighter than the tissue around the cyst and deeper tissue is darker") {
  const Phantom phantom = makePhantom("cyst", noiseFree());
  const auto at = [&](const Vec3& fromCentre) {
    const Vec3 index = phantom.volume.grid.toIndex(Vec3(99, 49, 85) + fromCentre);
    const auto n = [&](int a) { return static_cast<std::size_t>(std::lround(index[a])); };
    return phantom.volume.data<std::uint8_t>()[n(0) + 199 * (n(1) + 99 * n(2))];
  };
  CHECK(at({14, 0, 4}) > at({14, -48, 60}) + 40);     // in the cyst
  CHECK(at({7, -46, -7}) > at({-60, -46, -7}) + 40);  // on its way out at the front
  CHECK(at({-90, 0, -80}) > at({-90, 0, 80}) + 20);
}
