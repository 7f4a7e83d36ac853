// How much a result changes when clicks, smoothing and noise do.

#include "core/sensitivity/sensitivity.h"

#include <set>

#include "core/errors.h"
#include "core/indices.h"
#include "core/mesh/shapes.h"
#include "core/volume/field_of_view.h"
#include "core/volume/not_a_number.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! A ball of radius 10 mm in the middle, 20 in 200, with white noise besides.
Volume noisyBall(double noise, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  return withNoise(ballVolume(), noise, random);
}

struct Result {
  TriangleSoup mesh;
  GrownFrom from;
};

Result grow(const Volume& volume, const Parameters& parameters = {}) {
  ActiveContour contour(volume, {{kMiddle, 4.0}}, parameters);
  while (contour.stopReason() == StopReason::running) contour.step();
  return {contour.mesh().compact(), {volume, contour.request(), contour.parameters()}};
}

double deviationOf(const std::vector<double>& values) {
  double mean = 0, squares = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace

TEST_CASE("perturbed runs of a ball keep its topology, and their volumes are about those of other noise") {
  const Result result = grow(noisyBall(30));
  const Sensitivity s = sensitivityOf(result.mesh, result.from, 8, 2);
  REQUIRE(s.runs.size() == 8);
  CHECK(s.grown == 8);
  CHECK(s.sameTopology == 8);
  CHECK(s.by.noise == Approx(30).epsilon(0.15));
  CHECK(s.mean == Approx(kBallVolume).epsilon(0.03));
  CHECK(s.least <= s.mean);
  CHECK(s.most >= s.mean);
  REQUIRE(s.spread.size() == result.mesh.points.size());
  CHECK(s.meanSpread > 0);
  CHECK(s.meanSpread < 0.5);
  CHECK(s.spread95 >= s.meanSpread);
  CHECK(s.largestSpread >= s.spread95);
  std::vector<double> volumes;
  double distance = 0;  // the spread, a root mean square over the runs, is more than their mean, but not much
  for (const PerturbedRun& r : s.runs) {
    volumes.push_back(r.volume);
    distance += r.distance / 8;
  }
  CHECK(s.deviation == Approx(deviationOf(volumes)));
  CHECK(s.meanSpread >= distance);
  CHECK(s.meanSpread < 1.6 * distance);

  std::vector<double> others;
  for (unsigned seed = 2; seed < 10; ++seed) others.push_back(examine(grow(noisyBall(30, seed)).mesh).volume);
  const double really = deviationOf(others);
  CHECK(s.deviation > really / 3);
  CHECK(s.deviation < really * 5);
}

TEST_CASE("more noise moves the surface more, at the same smoothing") {
  Parameters parameters;
  parameters.smoothing = 1;
  const auto spreadAt = [&](double noise) {
    const Result result = grow(noisyBall(noise), parameters);
    return sensitivityOf(result.mesh, result.from, 4, 1).meanSpread;
  };
  CHECK(spreadAt(40) > 1.5 * spreadAt(5));
}

TEST_CASE("perturbed runs are the same on any number of threads") {
  const Result result = grow(noisyBall(20));
  const Sensitivity one = sensitivityOf(result.mesh, result.from, 3, 1);
  const Sensitivity two = sensitivityOf(result.mesh, result.from, 3, 2);
  CHECK(one.spread == two.spread);
  CHECK(one.mean == two.mean);
  CHECK(one.runs[0].volume != one.runs[1].volume);
}

TEST_CASE("runs that leave no surface are told, and do not count") {
  Result result = grow(ballVolume());
  result.from.request.parameters.range = IntensityRange{-1e6, -1e5};  // nothing there has such a value
  const Sensitivity s = sensitivityOf(result.mesh, result.from, 2, 1);
  CHECK(s.grown == 0);
  CHECK_FALSE(s.runs[0].failure.empty());
  CHECK(sentence(s.runs[0].why) == s.runs[0].failure);
  CHECK(s.mean == 0);
  const auto warnings = sentences(sensitivityWarnings(s));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("2 of 2 runs leave no surface") != std::string::npos);
}

TEST_CASE("doubts about another topology and a volume that changes") {
  Sensitivity s;
  s.runs.resize(10);
  s.grown = 10;
  s.sameTopology = 7;
  s.mean = s.least = s.most = s.result = 100;
  s.deviation = 25;
  const auto warnings = sentences(sensitivityWarnings(s));
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].find("3 of 10 runs have another topology") != std::string::npos);
  CHECK(warnings[1].find("25 %") != std::string::npos);
  s.sameTopology = 10;
  s.deviation = 5;
  CHECK(sensitivityWarnings(s).empty());
}

TEST_CASE("a result whose volume is far beyond those of all runs is doubted, one a little beyond is not") {
  Sensitivity s;
  s.runs.resize(3);
  s.grown = s.sameTopology = 3;
  s.mean = 7100;
  s.least = 7000;
  s.most = 7200;
  for (const double fine : {6500.0, 7100.0, 7900.0}) {
    s.result = fine;
    CHECK(sensitivityWarnings(s).empty());
  }
  for (const double doubtful : {6000.0, 9000.0}) {
    s.result = doubtful;
    const auto warnings = sensitivityWarnings(s);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].kind == FindingKind::volumeBesideRuns);
    CHECK(warnings[0].number("volume_ml") == Approx(doubtful / 1000));
    CHECK(warnings[0].number("least_ml") == Approx(7));
    CHECK(warnings[0].number("most_ml") == Approx(7.2));
  }
}

TEST_CASE("a growth with a constraint that names an iteration is not perturbed") {
  Constraints walls, vetoes, pins, edits;
  walls.walls.balls.push_back({Vec3(1, 1, 1), 1});
  CHECK_NOTHROW(requireRepeatable(walls));
  vetoes.vetoes.push_back({});
  CHECK_THROWS_AS(requireRepeatable(vetoes), UsageError);
  pins.pins.push_back({});
  CHECK_THROWS_AS(requireRepeatable(pins), UsageError);
  edits.edits.push_back({});
  CHECK_THROWS_AS(requireRepeatable(edits), UsageError);
  Result result = grow(ballVolume());
  result.from.request.constraints = vetoes;
  CHECK_THROWS_AS(sensitivityOf(result.mesh, result.from, 1, 1), UsageError);
}

TEST_CASE("a growth from a surface without a click is perturbed, and what was given as it is is not") {
  const Volume volume = noisyBall(20);
  Constraints constraints;
  constraints.start.emplace();
  constraints.start->path = "ball.stl";
  constraints.start->mesh = std::make_shared<const TriangleSoup>(icosphere(kMiddle, 6, 1.5));
  constraints.start->inside = kMiddle;
  ActiveContour contour(volume, {}, {}, constraints);
  while (contour.stopReason() == StopReason::running) contour.step();
  GrownFrom from{volume, contour.request(), contour.parameters()};
  REQUIRE(from.request.seeds.empty());
  const Sensitivity s = sensitivityOf(contour.mesh().compact(), from, 2, 1);
  CHECK(s.by.noise == Approx(20).epsilon(0.15));
  CHECK(s.grown == 2);
  CHECK(s.sameTopology == 2);
  from.request.constraints.start->isDone = true;
  CHECK_THROWS_AS(sensitivityOf(contour.mesh().compact(), from, 2, 1), UsageError);
}

TEST_CASE("noise leaves padding as it is, is rounded and clamped to the voxels' type") {
  Grid grid = cubicGrid(20);
  void* buffer = nullptr;
  Volume volume = makeVolume(grid, VoxelType::uint8, &buffer);
  auto* voxels = static_cast<std::uint8_t*>(buffer);
  for (int k = 0, v = 0; k < 20; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i, ++v)
        voxels[v] = i < 5 ? 0 : static_cast<std::uint8_t>(250 - (v * 7 + k) % 3);
  std::mt19937_64 random(3);
  const Volume noisy = withNoise(volume, 10, random);
  const auto* out = noisy.data<std::uint8_t>();
  int changed = 0, clamped = 0;
  for (int v = 0; v < 8000; ++v) {
    if (v % 20 < 5) CHECK(out[v] == 0);
    changed += out[v] != voxels[v];
    clamped += out[v] == 255;
    if (v % 20 >= 5) CHECK(out[v] > 180);
  }
  CHECK(changed > 5000);
  CHECK(clamped > 1000);
}

TEST_CASE("voxels that were not a number are still known after noise that goes below their mark") {
  const Grid grid = cubicGrid(20);
  const auto isNone = [](int v) {  // away from the border, or it would be padding as it is
    const auto isMiddle = [](int i) { return i > 7 && i < 12; };
    return isMiddle(v % 20) && isMiddle(v / 20 % 20) && isMiddle(v / 400);
  };
  void* buffer = nullptr;
  const Volume volume = makeVolume(grid, VoxelType::float32, &buffer);
  auto* voxels = static_cast<float*>(buffer);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> any(-100, 100);
  float least = 200;
  for (int v = 0; v < 8000; ++v) least = std::min(least, voxels[v] = any(random));
  for (int v = 0; v < 8000; ++v)
    if (isNone(v)) voxels[v] = notANumberBelow(least);
  const Volume noisy = withNoise(volume, 30, random);
  const auto* out = noisy.data<float>();
  REQUIRE(*std::min_element(out, out + 8000) < least - 30);
  const auto view = FieldOfView::find(noisy);
  REQUIRE(view);
  for (int v = 0; v < 8000; ++v) CHECK(view->isPadding(idx(v)) == isNone(v));
}

TEST_CASE("clicks move by a voxel at most and stay in the volume") {
  Grid grid = cubicGrid(10);
  grid.spacing = Vec3(1, 2, 5);
  Request request;
  request.seeds = {{Vec3(0, 0, 45), {}}, {Vec3(4, 8, 20), 3.0}};
  request.parameters.range = IntensityRange{10, 20};
  ResolvedParameters used;
  used.smoothing = 2;
  used.edgeLength = 1.5;
  std::mt19937_64 random(7);
  double furthest = 0;
  std::set<double> smoothings, lows, highs;
  for (int n = 0; n < 200; ++n) {
    const Request p = perturbed(request, used, grid, {1, 0.2, 3}, random);
    for (std::size_t s = 0; s < 2; ++s) {
      const Vec3 by = grid.toIndex(p.seeds[s].centre) - grid.toIndex(request.seeds[s].centre);
      CHECK(by.cwiseAbs().maxCoeff() <= 1 + 1e-9);
      furthest = std::max(furthest, by.cwiseAbs().maxCoeff());
      const Vec3 index = grid.toIndex(p.seeds[s].centre);
      CHECK(index.minCoeff() >= -1e-9);
      CHECK(index.maxCoeff() <= 9 + 1e-9);
    }
    CHECK(p.seeds[1].radius == 3.0);
    CHECK(std::abs(*p.parameters.smoothing - 2) <= 0.4);
    CHECK(std::abs(p.parameters.range->low - 10) <= 3);
    CHECK(p.parameters.range->low < p.parameters.range->high);
    CHECK(p.parameters.edgeLength == 1.5);
    smoothings.insert(*p.parameters.smoothing);
    lows.insert(p.parameters.range->low);
    highs.insert(p.parameters.range->high);
    CHECK(std::abs(p.parameters.range->high - 20) <= 3);
  }
  CHECK(furthest > 0.9);
  CHECK(smoothings.size() > 100);
  CHECK(lows.size() > 100);
  CHECK(highs.size() > 100);
}
