#include "core/evolution/stop_decision.h"

#include <memory>

#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/test_volume.h"

using namespace handlebody;

namespace {

StopFacts growing() { return {10, 100, 42, 80, false}; }
StopReason converged() { return StopReason::converged; }
StopReason notAsked() {
  FAIL("nothing has come to rest");
  return StopReason::running;
}

//! So many steps in which nothing moves and nothing happens.
void rest(StopDecision& stop, const StopFacts& facts, int steps) {
  for (int i = 0; i < steps; ++i) stop.afterStep(facts, {false, true, 0}, converged);
}
int stepsToRest(StopDecision stop, const StopFacts& facts) {
  int steps = 0;
  for (; steps < 1000 && stop.reason() == StopReason::running; ++steps) rest(stop, facts, 1);
  return steps;
}

}  // namespace

TEST_CASE("a contour runs until its limit of iterations, or until it has rested for a while") {
  StopDecision stop;
  StopFacts facts = growing();
  stop.begin(facts);
  stop.afterStep(facts, {false, false, 5}, notAsked);
  CHECK(stop.reason() == StopReason::running);
  const int steps = stepsToRest(stop, facts);
  CHECK(steps > 1);
  CHECK(steps < 100);
  facts.iteration = facts.maxIterations;
  stop.afterStep(facts, {false, false, 5}, notAsked);
  CHECK(stop.reason() == StopReason::maxIterations);
}

TEST_CASE("without iterations nothing runs, a given surface is done, and an empty one is empty") {
  StopFacts facts = growing();
  facts.maxIterations = facts.iteration = 0;
  StopDecision none;
  none.begin(facts);
  CHECK(none.reason() == StopReason::maxIterations);
  facts.isGiven = true;
  StopDecision given;
  given.begin(facts);
  CHECK(given.reason() == StopReason::given);
  facts.faces = facts.vertices = 0;
  given.afterStep(facts, {false, false, 0}, notAsked);
  CHECK(given.reason() == StopReason::empty);
}

TEST_CASE("what rests goes on to an edit; at the limit of the iterations only to the next step's") {
  StopFacts facts = growing();
  facts.nextEdit = 20;
  StopDecision stop;
  rest(stop, facts, 10);
  CHECK(stop.reason() == StopReason::running);
  facts.iteration = facts.maxIterations = 18;
  stop.change(facts, false);
  CHECK(stop.reason() == StopReason::maxIterations);
  facts.iteration = facts.maxIterations = 19;
  stop.change(facts, false);
  CHECK(stop.reason() == StopReason::running);
  facts.nextEdit = std::nullopt;
  stop.afterStep(facts, {true, false, 0}, converged);
  CHECK(stop.reason() == StopReason::converged);  // at rest before the edit, and after it
}

TEST_CASE("what has stopped goes on after a change that wakes it, or with more iterations") {
  StopFacts facts = growing();
  StopDecision stop;
  rest(stop, facts, 10);
  REQUIRE(stop.reason() == StopReason::converged);
  stop.change(facts, false);
  CHECK(stop.reason() == StopReason::converged);
  stop.forgetLocks();
  stop.change(facts, true);
  CHECK(stop.reason() == StopReason::running);
  CHECK(stepsToRest(stop, facts) == stepsToRest(StopDecision(), facts));
  facts.maxIterations = facts.iteration;
  stop.change(facts, false);
  CHECK(stop.reason() == StopReason::maxIterations);
  ++facts.maxIterations;
  stop.change(facts, false);
  CHECK(stop.reason() == StopReason::running);
}

TEST_CASE("a surface that would move is stuck if all of it rests for good, frozen if a part does") {
  const Mesh mesh(zoo::moved(zoo::scaled(zoo::sphere(4), 5), Vec3(20, 20, 20)));
  const Volume volume = testing::volumeByIndex(testing::cubicGrid(41), [](int, int, int) { return 0; });
  const auto smoothed = std::make_shared<SmoothedVolume>(volume, 0);
  MotionSettings motion;
  const auto reason = [&](const ObjectImage& image, double radius) {
    LockedRegions resting;
    if (radius > 0) resting.add(mesh.position(0), radius, 1);
    return reasonOfRest(mesh, image, motion, resting, 1);
  };
  const ObjectImage endless(smoothed, {-1, 1}, 1);
  CHECK(reason(endless, 0) == StopReason::converged);
  CHECK(reason(endless, 3) == StopReason::frozen);
  CHECK(reason(endless, 100) == StopReason::stuck);
}
