// The leak alarm: passages that a surface comes through.
#include "core/evolution/leak_alarm.h"

#include <algorithm>
#include <numeric>

#include "core/evolution/history.h"
#include "core/evolution/space_tree.h"
#include "core/indices.h"
#include "core/mesh/shapes.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

constexpr double kWallX = 20, kChamberHalf = 9;

//! mm from two chambers of 18 mm, 3 mm apart, with a hole of this radius in between. Voxels of 1 mm.
double chambers(const Vec3& p, double hole) {
  const auto box = [](const Vec3& q, const Vec3& half) {
    const Vec3 d = q.cwiseAbs() - half;
    return d.cwiseMax(0.0).norm() + std::min(0.0, d.maxCoeff());
  };
  const Vec3 half = Vec3::Constant(kChamberHalf);
  const double shift = kChamberHalf + 1.5;
  const Vec3 q = p - Vec3(kWallX, 20, 20);
  const double both = std::min(box(q + Vec3(shift, 0, 0), half), box(q - Vec3(shift, 0, 0), half));
  const double tube = std::max(std::hypot(q.y(), q.z()) - hole, std::abs(q.x()) - 4);
  return hole > 0 ? std::min(both, tube) : both;
}

ActiveContour growing(double hole, Constraints constraints = {}, Vec3 seed = Vec3(10, 18, 21)) {
  Parameters p;
  p.range = IntensityRange{-1e9, 100};
  return ActiveContour(darkObject(cubicGrid(41), [hole](const Vec3& q) { return chambers(q, hole); }),
                       {Seed{seed, 3.0}}, p, std::move(constraints));
}

std::vector<Leak> leaksOf(ActiveContour& contour) {
  std::vector<Leak> leaks;
  while (contour.stopReason() == StopReason::running)
    for (const Leak& leak : contour.step().leaks) leaks.push_back(leak);
  return leaks;
}

double furthestX(const Mesh& mesh) {
  double x = -1e300;
  for (const Vec3& p : mesh.compact().points) x = std::max(x, p.x());
  return x;
}

}  // namespace

TEST_CASE("spaces merge at their passages, and a space before or behind is as wide as its widest ball",
          "[leaks]") {
  // A row: radii of two spaces with a narrow passage, in a layer of cells that are no part of the region.
  const std::array<int, 3> size{13, 3, 3};
  std::vector<float> radius(13 * 9, 0.0f);
  const std::vector<float> row{3, 5, 6, 4, 1, 0.5f, 1, 4, 7, 4, 2};
  std::copy(row.begin(), row.end(), radius.begin() + 13 * 4 + 1);
  const auto cell = [](std::size_t i) { return static_cast<std::uint32_t>(13 * 4 + 1 + i); };
  SpaceTree tree(size, radius);
  NarrowRule rule;
  const std::vector<std::uint32_t> left{cell(2)}, right{cell(8)}, passage{cell(5)};
  const std::vector<Merging> found = tree.merge(left, rule);
  REQUIRE(found.size() == 1);
  CHECK(found[0].level == 0.5);
  CHECK(found[0].at == cell(5));
  CHECK(found[0].before == 6);
  CHECK(found[0].behind == 7);
  CHECK(found[0].peak == cell(8));
  CHECK(tree.behindWhich(cell(8)) == 1);
  CHECK(tree.behindWhich(cell(2)) == 0);
  CHECK(tree.merge(right, rule).at(0).behind == 6);
  rule.narrow = 0.08;  // 0.5 of 6 is more
  CHECK(tree.merge(left, rule).empty());
}

TEST_CASE("a space that opens into one four times as wide is told, also where nothing narrows it",
          "[leaks]") {
  const std::array<int, 3> size{13, 3, 3};
  std::vector<float> radius(13 * 9, 0.0f);
  const std::vector<float> row{1.5f, 1.75f, 1.5f, 1.5f, 3, 5, 6, 7, 6, 4, 2};
  std::copy(row.begin(), row.end(), radius.begin() + 13 * 4 + 1);
  const auto cell = [](std::size_t i) { return static_cast<std::uint32_t>(13 * 4 + 1 + i); };
  SpaceTree tree(size, radius);
  const std::vector<std::uint32_t> thin{cell(1)}, wide{cell(7)};
  const std::vector<Merging> found = tree.merge(thin, {});
  REQUIRE(found.size() == 1);
  CHECK(found[0].isWidening);
  CHECK(found[0].before == 1.75);
  CHECK(found[0].behind == 7);
  CHECK(tree.behindWhich(cell(7)) == 1);
  CHECK(tree.merge(wide, {}).empty());
  NarrowRule rule;
  rule.widening = 4.1;
  CHECK(tree.merge(thin, rule).empty());
}

namespace {

//! A tube of this radius that opens into a box of 30 mm.
std::vector<Leak> leaksOutOf(double radius) {
  const auto tubeAndBox = [radius](const Vec3& p) {
    const Vec3 d = (p - Vec3(40, 20, 20)).cwiseAbs() - Vec3::Constant(15);
    const double box = d.cwiseMax(0.0).norm() + std::min(0.0, d.maxCoeff());
    const double tube = std::max(std::hypot(p.y() - 20, p.z() - 20) - radius, std::abs(p.x() - 16) - 12);
    return std::min(box, tube);
  };
  Grid grid = cubicGrid(41);
  grid.size[0] = 61;
  Parameters p;
  p.range = IntensityRange{-1e9, 100};
  ActiveContour contour(darkObject(grid, tubeAndBox), {Seed{Vec3(10, 20, 20), 2.0}}, p);
  return leaksOf(contour);
}

}  // namespace

TEST_CASE("the alarm comes where the surface comes out of a tube into a space more than four times as wide",
          "[leaks]") {
  const std::vector<Leak> leaks = leaksOutOf(2.5);
  REQUIRE(leaks.size() == 1);
  CHECK(leaks[0].passage.isWidening);
  CHECK(leaks[0].passage.behind > 13);
  CHECK(leaks[0].passage.before < 3.5);
  CHECK(std::abs(leaks[0].place.x() - 25) < 6);  // the box begins at 25 mm
  CHECK(leaksOutOf(5).empty());
}

TEST_CASE("the alarm comes when the surface comes out of a hole, tells the passage, and comes once",
          "[leaks]") {
  ActiveContour contour = growing(2.5);
  int out = -1;
  std::vector<Leak> leaks;
  while (contour.stopReason() == StopReason::running) {
    for (const Leak& leak : contour.step().leaks) leaks.push_back(leak);
    if (out < 0 && furthestX(contour.mesh()) > kWallX + 1.5) out = contour.iteration();
  }
  REQUIRE(out > 0);
  REQUIRE(leaks.size() == 1);
  CHECK(std::abs(leaks[0].iteration - out) <= 5);
  CHECK((leaks[0].place - Vec3(kWallX, 20, 20)).norm() < 2);
  CHECK(std::abs(leaks[0].disc.normal.normalized().x()) > 0.95);
  CHECK(leaks[0].disc.radius > 2.5);
  CHECK(leaks[0].disc.radius < 5.5);
  CHECK(leaks[0].passage.before > 7);
  CHECK(leaks[0].passage.behind > 7);
  CHECK(leaks[0].passage.radius < 3.2);
  CHECK(sentence(leaks[0]).find("passage") != std::string::npos);
}

TEST_CASE("no alarm without a passage, nor where the passage is wide, nor for a click in each space",
          "[leaks]") {
  ActiveContour closed = growing(0), wide = growing(6);
  CHECK(leaksOf(closed).empty());
  CHECK(leaksOf(wide).empty());
  CHECK(furthestX(wide.mesh()) > kWallX + 10);
  Parameters p;
  p.range = IntensityRange{-1e9, 100};
  ActiveContour both(darkObject(cubicGrid(41), [](const Vec3& q) { return chambers(q, 2.5); }),
                     {Seed{Vec3(10, 18, 21), 3.0}, Seed{Vec3(30, 22, 19), 3.0}}, p);
  CHECK(leaksOf(both).empty());
}

TEST_CASE("the alarm comes again where its iteration is made again, and once", "[leaks][history]") {
  History history(growing(2.5));
  while (history.stopReason() == StopReason::running) history.advance();
  std::vector<int> alarms;
  for (const StepReport& s : history.steps())
    if (!s.leaks.empty()) alarms.push_back(s.iteration);
  REQUIRE(alarms.size() == 1);
  history.goTo(alarms[0] - 1);
  ActiveContour again = history.shown();
  CHECK(again.step().leaks.size() == 1);
  CHECK(again.step().leaks.empty());
}

TEST_CASE("a wall put across the passage that the alarm tells keeps the surface in, and no alarm comes again",
          "[leaks][walls][history]") {
  History history(growing(2.5));
  while (history.steps().back().leaks.empty()) history.advance();
  const Leak leak = history.steps().back().leaks[0];
  const auto free = history.lastFree({{}, {}, {}, {leak.disc}});
  REQUIRE(free.has_value());
  CHECK(*free < leak.iteration);
  history.goTo(*free);
  Request request = history.shown().request();
  request.constraints.walls.discs.push_back(leak.disc);
  history.change(request);
  while (history.stopReason() == StopReason::running) {
    history.advance();
    CHECK(history.steps().back().leaks.empty());
  }
  CHECK(furthestX(history.shown().mesh()) < kWallX + 1.5);
  CHECK(std::abs(volumeOf(history.shown().mesh()) / std::pow(2 * kChamberHalf, 3) - 1) < 0.05);
}

TEST_CASE("copies of an alarm share what they found in the image, until it is another image", "[leaks]") {
  const Volume volume = darkObject(cubicGrid(41), [](const Vec3& q) { return chambers(q, 2.5); });
  const ObjectImage image(std::make_shared<SmoothedVolume>(volume, 0), IntensityRange{-1e9, 100}, 20);
  const ActiveContour contour = growing(2.5);
  const std::vector<Vec3> seeds{Vec3(10, 18, 21)};
  const LeakAlarm::Scene scene{image, nullptr, seeds, 1};
  LeakAlarm first;
  LeakAlarm copy = first;  // as the keyframe of the seeds is
  first.look(contour.mesh(), {}, scene);
  copy.look(contour.mesh(), {}, scene);
  CHECK(first.map() != nullptr);
  CHECK(copy.map() == first.map());
  LeakAlarm other = first;
  other.forget();
  other.look(contour.mesh(), {}, scene);
  CHECK(other.map() != first.map());
}

namespace {

//! Voxels of 1 mm, too many to be looked at as a whole: balls of 18 and 28 mm with a tube of 3.2 mm between
//! them, from 78 to 82 mm along x.
const Vec3 kNearBall(60, 55, 55), kFarBall(110, 55, 55);
const ObjectImage& twoBalls() {
  static const ObjectImage image = [] {
    Grid grid;
    grid.size = {170, 110, 110};
    const Volume volume = volumeByIndex(grid, [](int i, int j, int k) {
      const Vec3 p(i, j, k);
      const bool isTube = i >= 60 && i <= 110 && std::hypot(j - 55, k - 55) < 3.2;
      return (p - kNearBall).norm() < 18 || (p - kFarBall).norm() < 28 || isTube ? 20 : 200;
    });
    return ObjectImage(std::make_shared<SmoothedVolume>(volume, 0), IntensityRange{-1e9, 100}, 20);
  }();
  return image;
}

//! A small ball at x in the first ball, with a tip that reaches through the tube.
Mesh ballWithTip(double x, double tip) {
  TriangleSoup ball = icosphere(Vec3(x, 55, 55), 4, 3);
  std::max_element(ball.points.begin(), ball.points.end(), [](const Vec3& a, const Vec3& b) {
    return a.x() < b.x();
  })->x() = tip;
  return Mesh(ball);
}

//! The tips at which a surface is told that grows from there by 1 mm a step.
std::vector<double> toldTips(LeakAlarm& alarm, double x, double from, double to) {
  std::vector<double> told;
  const std::vector<Vec3> seeds{kNearBall};
  for (double tip = from; tip < to; ++tip) {
    const Mesh mesh = ballWithTip(x, tip);
    std::vector<int> all(idx(mesh.vertexSlots()));
    std::iota(all.begin(), all.end(), 0);
    for (std::size_t n = alarm.look(mesh, all, {twoBalls(), nullptr, seeds, 1}).size(); n > 0; --n)
      told.push_back(tip);
  }
  return told;
}

}  // namespace

TEST_CASE("a leak is told once wherever the box around the surface ends, before or behind the passage",
          "[leaks]") {
  for (double x = 50; x <= 70; ++x) {  // the first box ends 28 mm further
    INFO("from " << x);
    LeakAlarm alarm;
    const std::vector<double> tips = toldTips(alarm, x, x + 5, 135);
    REQUIRE(tips.size() == 1);
    CHECK(tips[0] > 79);
    CHECK(tips[0] < 92);
  }
}

TEST_CASE("where the surface lies at the first look is no leak when the box is widened", "[leaks]") {
  LeakAlarm alarm;
  CHECK(toldTips(alarm, 60, 87, 135).empty());
  LeakAlarm forgetful;
  CHECK(toldTips(forgetful, 60, 65, 90).size() == 1);
  forgetful.forget();
  CHECK(toldTips(forgetful, 60, 90, 135).empty());
}
