#include "core/evolution/history.h"

#include <atomic>
#include <chrono>
#include <random>
#include <thread>

#include "core/cancellation.h"
#include "core/errors.h"
#include "tests/core/evolution/contour_support.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

constexpr double kSeedX = 20 + kTorusR;

ActiveContour torusContour(const Parameters& parameters = {}) {
  return ActiveContour(torusVolume(), {{Vec3(kSeedX, 20, 20), 3.0}}, parameters);
}

//! The meshes of every iteration of a run that never went back.
std::vector<Mesh> straightRun(ActiveContour contour) {
  std::vector<Mesh> meshes{contour.mesh()};
  while (contour.stopReason() == StopReason::running) {
    contour.step();
    meshes.push_back(contour.mesh());
  }
  return meshes;
}

void runToEnd(History& history) {
  while (history.stopReason() == StopReason::running) history.advance();
}

//! A keyframe at every `n`-th millisecond of computing at most.
HistoryLimits every(double milliseconds) {
  HistoryLimits limits;
  limits.redoSeconds = milliseconds / 1000;
  return limits;
}

}  // namespace

TEST_CASE("a copy of a contour goes on as the original does", "[history]") {
  ActiveContour contour = torusContour();
  for (int i = 0; i < 25; ++i) contour.step();
  ActiveContour copy = contour;
  while (contour.stopReason() == StopReason::running) {
    const StepReport a = contour.step(), b = copy.step();
    REQUIRE(isSame(contour.mesh(), copy.mesh()));
    REQUIRE(a.events.size() == b.events.size());
  }
  CHECK(copy.stopReason() == contour.stopReason());
}

TEST_CASE("any iteration comes back bit for bit, in any order", "[history]") {
  const std::vector<Mesh> expected = straightRun(torusContour());
  History history(torusContour(), every(1));
  runToEnd(history);
  REQUIRE(history.lastIteration() + 1 == static_cast<int>(expected.size()));
  REQUIRE(history.keyframes() > 3);
  std::mt19937 random(7);
  std::uniform_int_distribution<int> any(0, history.lastIteration());
  for (int jump = 0; jump < 60; ++jump) {
    const int target = any(random);
    history.goTo(target);
    INFO("iteration " << target);
    REQUIRE(history.iteration() == target);
    REQUIRE(isSame(history.shown().mesh(), expected[target]));
  }
  CHECK(history.lastIteration() + 1 == static_cast<int>(expected.size()));
}

TEST_CASE("stepping on from an earlier iteration shows what was recorded", "[history]") {
  const std::vector<Mesh> expected = straightRun(torusContour());
  History history(torusContour());
  runToEnd(history);
  const std::size_t steps = history.steps().size(), events = history.events().size();
  history.goTo(10);
  for (int i = 11; i <= history.lastIteration(); ++i) {
    history.advance();
    REQUIRE(isSame(history.shown().mesh(), expected[i]));
  }
  CHECK(history.stopReason() == StopReason::converged);
  CHECK(history.steps().size() == steps);
  CHECK(history.events().size() == events);
}

TEST_CASE("other parameters from an iteration on drop what came after, and are done again exactly",
          "[history]") {
  Parameters other;
  other.curvature = 0.6;
  other.edgeLength = 1.5;
  ActiveContour straight = torusContour();
  for (int i = 0; i < 20; ++i) straight.step();
  straight.changeParameters(other);
  const std::vector<Mesh> expected = straightRun(straight);

  History history(torusContour(), every(1));
  for (int i = 0; i < 40; ++i) history.advance();
  history.goTo(20);
  history.changeParameters(other);
  CHECK(history.lastIteration() == 20);
  CHECK(history.parameters() == other);
  runToEnd(history);
  REQUIRE(history.lastIteration() - 20 + 1 == static_cast<int>(expected.size()));
  for (int target : {20, history.lastIteration(), 21, 30, 25, 20, 22}) {
    history.goTo(target);
    INFO("iteration " << target);
    REQUIRE(isSame(history.shown().mesh(), expected[target - 20]));
  }
  REQUIRE(history.changes().size() == 1);
  CHECK(history.changes()[0].iteration == 20);
  CHECK(history.changes()[0].parameters == other);
  history.goTo(19);
  CHECK(history.parameters() == Parameters{});
}

TEST_CASE("the parameters of before, given again, undo a change at the same iteration", "[history]") {
  Parameters other;
  other.balloon = 0.5;
  History history(torusContour());
  for (int i = 0; i < 15; ++i) history.advance();
  history.changeParameters(other);
  history.changeParameters({});
  CHECK(history.changes().empty());
  history.goTo(10);
  history.changeParameters({});
  CHECK(history.lastIteration() == 15);
  runToEnd(history);
  CHECK(isSame(history.shown().mesh(), straightRun(torusContour()).back()));
}

TEST_CASE("parameters that are refused change nothing", "[history]") {
  History history(torusContour());
  for (int i = 0; i < 15; ++i) history.advance();
  history.goTo(10);
  Parameters wrong;
  wrong.balloon = -1;
  CHECK_THROWS_AS(history.changeParameters(wrong), UsageError);
  wrong = {};
  wrong.range = IntensityRange{190, 300};  // the seed is not in it
  CHECK_THROWS_AS(history.changeParameters(wrong), SeedError);
  CHECK(history.lastIteration() == 15);
  CHECK(history.parameters() == Parameters{});
  runToEnd(history);
  CHECK(isSame(history.shown().mesh(), straightRun(torusContour()).back()));
}

TEST_CASE("more iterations let a growth go on that had reached its limit", "[history]") {
  Parameters few;
  few.maxIterations = 12;
  History history(torusContour(few));
  runToEnd(history);
  CHECK(history.stopReason() == StopReason::maxIterations);
  history.changeParameters({});
  CHECK(history.stopReason() == StopReason::running);
  runToEnd(history);
  CHECK(history.stopReason() == StopReason::converged);
  CHECK(isSame(history.shown().mesh(), straightRun(torusContour()).back()));
}

TEST_CASE("a converged surface wakes when the range grows, and follows the new boundary", "[history]") {
  // A ball in a softer shell: the first range ends at the ball, the second at the shell.
  const Volume volume = volumeByIndex(cubicGrid(41), [](int i, int j, int k) {
    const double r = (Vec3(i, j, k) - kMiddle).norm();
    return (r < 7 ? 20 : r < 12 ? 60 : 200) + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  });
  Parameters narrow, wide;
  narrow.range = IntensityRange{-100, 40};
  wide.range = IntensityRange{-100, 130};
  History history(ActiveContour(volume, {{kMiddle, 3.0}}, narrow));
  runToEnd(history);
  const double before = history.steps().back().volume;
  history.changeParameters(wide);
  runToEnd(history);
  CHECK(history.stopReason() == StopReason::converged);
  CHECK(before == Approx(4.0 / 3 * M_PI * 343).epsilon(0.1));
  CHECK(history.steps().back().volume == Approx(4.0 / 3 * M_PI * 1728).epsilon(0.1));
  CHECK(certify(history.shown().mesh().compact()).passes());
}

TEST_CASE("a prepared image leads to the same mesh as one that is chosen anew", "[history]") {
  Parameters other;
  other.range = IntensityRange{-100, 90};
  other.curvature = 0.4;
  const ActiveContour prepared = torusContour(other);
  ActiveContour chosen = torusContour(), taken = torusContour();
  for (ActiveContour* c : {&chosen, &taken})
    for (int i = 0; i < 10; ++i) c->step();
  chosen.changeParameters(other);
  taken.change(prepared);
  CHECK(taken.parameters().range == chosen.parameters().range);
  CHECK(taken.parameters().smoothing == chosen.parameters().smoothing);
  CHECK(isSame(straightRun(taken).back(), straightRun(chosen).back()));
}

TEST_CASE("a change that leaves the image is the same with a prepared contour, also after a click on the way",
          "[history]") {
  // A thin tube, from which the edge length comes, and a wide one, where a click is put later.
  Grid grid;
  grid.size = {90, 36, 36};
  const Volume volume = darkObject(grid, [](const Vec3& p) {
    const double radius = std::clamp(2.2 + 0.6 * (p.x() - 40), 2.2, 8.2);
    return std::max(std::hypot(p.y() - 18, p.z() - 18) - radius, std::abs(p.x() - 45) - 37);
  });
  const std::vector<Seed> first{{Vec3(18, 18, 18)}}, both{first[0], {Vec3(70, 18, 18)}};
  Parameters p;
  p.range = IntensityRange{-1e9, 110};
  ActiveContour contour(volume, first, p);
  for (int i = 0; i < 8; ++i) contour.step();
  contour.change({both, p, {}});
  for (int i = 0; i < 4; ++i) contour.step();
  REQUIRE_FALSE(contour.correction()->beganAnew);
  Parameters curved = p, longer = p;
  curved.curvature = 0.3;
  longer.maxIterations = 2000;
  for (const Parameters& other : {curved, longer}) {
    const ActiveContour prepared(volume, both, other);
    REQUIRE(prepared.parameters().edgeLength != contour.parameters().edgeLength);
    ActiveContour chosen = contour, taken = contour;
    chosen.changeParameters(other);
    taken.change(prepared);
    CHECK(taken.parameters().edgeLength == chosen.parameters().edgeLength);
    CHECK(isSame(straightRun(taken).back(), straightRun(chosen).back()));
  }
}

TEST_CASE("a contour begun again with other parameters is as a new one", "[history]") {
  ActiveContour contour = torusContour();
  for (int i = 0; i < 10; ++i) contour.step();
  Parameters sameImage, otherImage;
  sameImage.edgeLength = 1.3;
  otherImage.range = IntensityRange{-100, 90};
  for (const Parameters& p : {sameImage, otherImage}) {
    const ActiveContour again = contour.restarted(p, {});
    CHECK(again.iteration() == 0);
    CHECK(isSame(straightRun(again).back(), straightRun(torusContour(p)).back()));
  }
}

TEST_CASE("the choice of the image gives up when it is cancelled", "[history]") {
  const std::atomic<bool> cancelled{true};
  const CancelScope scope(cancelled);
  CHECK_THROWS_AS(torusContour(), Cancelled);
}

TEST_CASE("a step that is cancelled anywhere inside leaves no trace", "[history]") {
  ActiveContour contour = torusContour();
  std::atomic<bool> cancelled{false};
  std::atomic<int> delay{0};  // microseconds; 0: there is nothing to cancel
  std::jthread canceller([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const int wait = delay.exchange(0);
      if (wait == 0) continue;
      std::this_thread::sleep_for(std::chrono::microseconds(wait));
      cancelled = true;
    }
  });
  int broken = 0;
  for (int tries = 0; contour.stopReason() == StopReason::running; ++tries) {
    const int before = contour.iteration();
    const CancelScope scope(cancelled);
    if (tries % 3 == 0) delay = 1 + tries * 37 % 300;
    if (tries % 3 == 1) cancelled = true;
    try {
      contour.step();
    } catch (const Cancelled&) {
      CHECK(contour.iteration() == before);
      ++broken;
    }
    while (tries % 3 == 0 && !cancelled) std::this_thread::yield();
    cancelled = false;
  }
  CHECK(broken > 10);
  CHECK(isSame(contour.mesh(), straightRun(torusContour()).back()));
}

TEST_CASE("a step that is cancelled leaves its vertices in the order that they had", "[history]") {
  constexpr int kOrderedFrom = 4500;  // vertices
  Parameters fine;
  fine.edgeLength = 0.5;
  ActiveContour contour(ballVolume(), {{kMiddle, 3.0}}, fine);
  while (contour.mesh().vertexSlots() < kOrderedFrom) {
    REQUIRE(contour.stopReason() == StopReason::running);
    contour.step();
  }
  ActiveContour brokenOff = contour;
  {
    const std::atomic<bool> cancelled{true};
    const CancelScope scope(cancelled);
    CHECK_THROWS_AS(brokenOff.step(), Cancelled);
  }
  CHECK(isSame(brokenOff.mesh(), contour.mesh()));
  // What is asked for now finds the same mesh in both.
  Parameters coarser = fine;
  coarser.edgeLength = 0.6;
  for (ActiveContour* c : {&brokenOff, &contour}) {
    c->changeParameters(coarser);
    c->step();
  }
  CHECK(isSame(brokenOff.mesh(), contour.mesh()));
}

TEST_CASE("an event of the past tells its stages without disturbing the history", "[history]") {
  History history(torusContour());
  runToEnd(history);
  int handles = 0;
  for (const Event& e : history.events()) {
    REQUIRE(e.trace.handleFaces.empty());
    if (e.kind != EventKind::handleInserted) continue;
    ++handles;
    const std::vector<Event> traced = history.traced(e.iteration);
    bool found = false;
    for (const Event& t : traced)
      found = found || (t.kind == e.kind && t.location == e.location && !t.trace.handleFaces.empty() &&
                        t.loopSizes == e.loopSizes);
    CHECK(found);
  }
  CHECK(handles >= 1);
  CHECK(history.iteration() == history.lastIteration());
}

TEST_CASE("a history keeps to its memory and is as exact with fewer keyframes", "[history]") {
  const std::vector<Mesh> expected = straightRun(torusContour());
  HistoryLimits tight = every(0);  // a keyframe at every iteration, if the memory allowed it
  tight.memory = 12 * torusContour().memory() + 12 * expected.back().memory();
  History history(torusContour(), tight);
  runToEnd(history);
  CHECK(history.memory() <= tight.memory);
  CHECK(history.keyframes() < expected.size() / 2);
  for (int target : {1, 33, 17, history.lastIteration(), 0, history.lastIteration() - 1}) {
    history.goTo(target);
    REQUIRE(isSame(history.shown().mesh(), expected[target]));
  }
}

TEST_CASE("stepping back across a click is exact, and what was grown after it is dropped by another one",
          "[history]") {
  const std::vector<Seed> more{{Vec3(kSeedX, 20, 20), 3.0}, {Vec3(20 - kTorusR, 20, 20), {}}},
      other{{Vec3(kSeedX, 20, 20), 3.0}, {Vec3(20, 20 + kTorusR, 20), {}, true}};
  ActiveContour straight = torusContour();
  std::vector<Mesh> expected;
  for (int i = 0; i < 20; ++i, straight.step()) expected.push_back(straight.mesh());
  straight.change({more, {}});
  REQUIRE(straight.correction()->fronts == 1);
  const std::vector<Mesh> after = straightRun(straight);
  expected.push_back(torusContour().mesh());  // at 20: as it was before the click
  expected.insert(expected.end(), after.begin() + 1, after.end());

  History history(torusContour(), every(1));
  for (int i = 0; i < 30; ++i) history.advance();
  history.goTo(20);
  expected[20] = history.shown().mesh();
  history.change({more, {}});
  CHECK(history.lastIteration() == 20);
  CHECK(history.seeds() == more);
  runToEnd(history);
  REQUIRE(history.lastIteration() + 1 == static_cast<int>(expected.size()));
  for (int target : {20, history.lastIteration(), 21, 30, 19, 25, 20, 5, 22}) {
    history.goTo(target);
    INFO("iteration " << target);
    REQUIRE(isSame(history.shown().mesh(), expected[target]));
  }
  REQUIRE(history.changes().size() == 1);
  CHECK(history.changes()[0].iteration == 20);
  CHECK(history.changes()[0].seeds == more);
  REQUIRE(history.corrections().size() == 1);
  CHECK(history.corrections()[0].what.fronts == 1);
  history.goTo(19);
  CHECK(history.seeds() == torusContour().requestedSeeds());

  history.goTo(25);
  history.change({other, {}});
  CHECK(history.lastIteration() == 25);
  CHECK(history.corrections().size() == 2);
  history.change({more, {}});
  CHECK(history.changes().size() == 1);
}
