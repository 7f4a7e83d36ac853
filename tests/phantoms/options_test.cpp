#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "tests/phantoms/helpers.h"

using namespace handlebody;
using namespace handlebody::phantomtest;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 centreOf(const Grid& grid) {
  return grid.toWorld(Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1) / 2);
}

// Voxels darker than half way that are joined to the voxel of the seed through faces.
int darkAroundSeed(const Phantom& phantom) {
  const Grid& grid = phantom.volume.grid;
  const std::vector<double> values = voxelsOf(phantom.volume);
  std::vector<char> met(values.size(), 0);
  const auto index = [&](const std::array<int, 3>& v) {
    return static_cast<std::size_t>(v[0] + grid.size[0] * (v[1] + grid.size[1] * v[2]));
  };
  const Vec3 seed = grid.toIndex(phantom.seed);
  std::vector<std::array<int, 3>> open;
  const auto visit = [&](const std::array<int, 3>& v) {
    for (std::size_t a = 0; a < 3; ++a)
      if (v[a] < 0 || v[a] >= grid.size[a]) return;
    if (met[index(v)] || values[index(v)] >= halfLevel(phantom.volume.type)) return;
    met[index(v)] = 1;
    open.push_back(v);
  };
  visit({static_cast<int>(std::lround(seed.x())), static_cast<int>(std::lround(seed.y())),
         static_cast<int>(std::lround(seed.z()))});
  int count = 0;
  while (!open.empty()) {
    const std::array<int, 3> v = open.back();
    open.pop_back();
    ++count;
    for (std::size_t a = 0; a < 3; ++a)
      for (int side : {-1, 1}) {
        std::array<int, 3> w = v;
        w[a] += side;
        visit(w);
      }
  }
  return count;
}

template <typename Change>
void expectRefused(const char* name, Change&& change) {
  PhantomOptions options;
  change(options);
  CHECK_THROWS_AS(makePhantom(name, options), UsageError);
}

}  // namespace

TEST_CASE("phantoms have their own size, and the extent stays when the spacing changes") {
  CHECK(makePhantom("cube").volume.grid.size == std::array<int, 3>{100, 100, 100});
  CHECK(makePhantom("cyst").volume.grid.size == std::array<int, 3>{199, 99, 171});
  PhantomOptions options;
  options.spacing = Vec3(2, 2, 2);
  const Grid coarse = makePhantom("cyst", options).volume.grid;
  CHECK(coarse.size == std::array<int, 3>{100, 50, 86});
  CHECK((centreOf(coarse) - Vec3(99, 49, 85)).norm() < 1e-12);
  options.spacing = Vec3(0.5, 1, 2);
  CHECK(makePhantom("torus", options).volume.grid.size == std::array<int, 3>{200, 100, 50});
}

TEST_CASE("a size widens or narrows the view around the same centre") {
  PhantomOptions options;
  options.noise = 0;
  const Phantom own = makePhantom("sphere", options);
  options.size = {70, 90, 64};
  const Phantom other = makePhantom("sphere", options);
  CHECK(other.volume.grid.size == options.size);
  CHECK((centreOf(other.volume.grid) - centreOf(own.volume.grid)).norm() < 1e-12);
  CHECK((other.seed - own.seed).norm() < 1e-12);
  const auto dark = [](const Phantom& p) {
    const std::vector<double> v = voxelsOf(p.volume);
    return std::count_if(v.begin(), v.end(), [](double x) { return x < 120; });
  };
  CHECK(dark(own) == dark(other));
}

TEST_CASE("a rotation is the direction matrix Rz Ry Rx about the centre of the volume") {
  PhantomOptions options;
  options.rotationDegrees = Vec3(90, 0, 90);
  const Grid grid = makePhantom("dumbbell", options).volume.grid;
  // Rx takes y to z; Rz leaves z there. Rz takes x to y.
  CHECK((grid.direction.col(1) - Vec3::UnitZ()).norm() < 1e-12);
  CHECK((grid.direction.col(0) - Vec3::UnitY()).norm() < 1e-12);
  CHECK((centreOf(grid) - centreOf(makePhantom("dumbbell").volume.grid)).norm() < 1e-12);
}

TEST_CASE("the voxels of a rotated phantom are those of the unrotated one") {
  PhantomOptions options;
  const std::vector<double> before = voxelsOf(makePhantom("torus", options).volume);
  options.rotationDegrees = Vec3(10, 20, 30);
  CHECK(voxelsOf(makePhantom("torus", options).volume) == before);
}

TEST_CASE("a bias of b makes the brightest background b times the darkest") {
  PhantomOptions options;
  options.noise = 0;
  options.type = VoxelType::float32;  // its zero is that of the gain
  options.bias = 1.6;
  const Phantom phantom = makePhantom("sphere", options);
  const std::vector<double> values = voxelsOf(phantom.volume);
  const std::vector<double> truth = voxelsOf(phantom.truth);
  double low = 1e9, high = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Vec3 p = phantom.volume.grid.toWorld(
        Vec3(static_cast<double>(i % 80), static_cast<double>(i / 80 % 80), static_cast<double>(i / 6400)));
    if (phantomDistance("sphere", options, p) < 2) continue;
    low = std::min(low, values[i]);
    high = std::max(high, values[i]);
  }
  CHECK(high / low == Approx(1.6).epsilon(0.01));
  double steepest = 0;
  for (std::size_t i = 0; i + 1 < 80; ++i) steepest = std::max(steepest, std::abs(values[i + 1] - values[i]));
  CHECK(steepest < 0.01);  // smooth: a sixtieth of the range from voxel to voxel
}

TEST_CASE("the two chambers of the wall are joined by the gap alone, and the truth does not know it") {
  PhantomOptions options;
  options.noise = 0;
  const Phantom closed = makePhantom("wall", options);
  const std::vector<double> truth = voxelsOf(closed.truth);
  const auto chamber = static_cast<int>(std::count(truth.begin(), truth.end(), 1.0));
  CHECK(darkAroundSeed(closed) == chamber);
  for (const int gap : {1, 2, 3}) {
    options.gapVoxels = gap;
    const Phantom open = makePhantom("wall", options);
    CHECK(darkAroundSeed(open) == 2 * chamber + 2 * gap * gap);  // the wall has two voxels
    CHECK(voxelsOf(open.truth) == truth);
    CHECK(open.genus == std::vector<int>{0});
  }
}

TEST_CASE("options without meaning are refused") {
  CHECK_THROWS_AS(makePhantom("cysts"), UsageError);
  CHECK_THROWS_AS(phantomSurface("", {}), UsageError);
  CHECK_THROWS_AS(phantomDistance("Cube", {}, Vec3(0, 0, 0)), UsageError);
  expectRefused("cube", [](PhantomOptions& o) { o.size = {-1, 100, 100}; });
  expectRefused("cube", [](PhantomOptions& o) { o.size = {100, 100, 60}; });  // cuts the object
  expectRefused("cube", [](PhantomOptions& o) { o.size = {2000, 2000, 2000}; });
  expectRefused("cube", [](PhantomOptions& o) { o.spacing = Vec3(1, 0, 1); });
  expectRefused("cube", [](PhantomOptions& o) { o.spacing = Vec3(1, -1, 1); });
  expectRefused("cube", [](PhantomOptions& o) { o.spacing = Vec3(1, kNan, 1); });
  expectRefused("cube", [](PhantomOptions& o) { o.spacing = Vec3(1, kInfinity, 1); });
  expectRefused("cube", [](PhantomOptions& o) { o.spacing = Vec3(1e-9, 1e-9, 1e-9); });
  expectRefused("cyst", [](PhantomOptions& o) { o.spacing = Vec3(1, 1, 6); });  // would lose the needle
  expectRefused("cube", [](PhantomOptions& o) { o.rotationDegrees = Vec3(kNan, 0, 0); });
  expectRefused("cube", [](PhantomOptions& o) { o.noise = kNan; });
  expectRefused("cube", [](PhantomOptions& o) { o.bias = 0.5; });
  expectRefused("cube", [](PhantomOptions& o) { o.bias = kInfinity; });
  expectRefused("cube", [](PhantomOptions& o) { o.gapVoxels = 1; });  // no wall
  expectRefused("wall", [](PhantomOptions& o) { o.gapVoxels = -1; });
  expectRefused("wall", [](PhantomOptions& o) { o.gapVoxels = 70; });
  expectRefused("cube", [](PhantomOptions& o) { o.type = VoxelType::float64; });
}

TEST_CASE("a refusal names the option") {
  PhantomOptions options;
  options.spacing = Vec3(1, 1, 6);
  try {
    makePhantom("cyst", options);
    FAIL("accepted");
  } catch (const UsageError& error) {
    CHECK(std::string(error.what()).find("--spacing") != std::string::npos);
  }
}
