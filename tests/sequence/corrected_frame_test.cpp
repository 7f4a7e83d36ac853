// Frames that were corrected by hand, and the surfaces beyond that start from them.

#include <algorithm>
#include <set>
#include <string>

#include "tests/sequence/beating_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

const WallBall kWall{kMiddle + Vec3(10, 0, 0), 4};

//! 9 mm in frame 2, half a millimetre more in each after it, and less before.
Volume frameOf(int frame) { return balls({{kMiddle, 8 + 0.5 * frame}}); }

GrownFrame grownInFrame2() {
  GrownFrame grown = growIn(frameOf(2), 2, {{{kMiddle}}, {}, {}});
  grown.settings.grownFrame = 2;
  return grown;
}

double nearestToWall(const FrameResult& r) {
  double least = 1e9;
  for (const Vec3& p : r.mesh.points) least = std::min(least, (p - kWall.centre).norm());
  return least;
}

Constraints walled() {
  Constraints constraints;
  constraints.walls.balls.push_back(kWall);
  return constraints;
}

//! Frame 3 with a wall from the start.
FrameCorrection walledIn3(const GrownFrame& grown) {
  FrameCorrection correction{3, carriedRequest(grown.settings, 3)};
  correction.request.constraints = walled();
  return correction;
}

FrameCarrier carrierOf(const GrownFrame& grown) { return {grown.settings, hooksOf(frameOf)}; }

}  // namespace

TEST_CASE("a corrected frame is grown as its correction says, and those beyond it are carried with that") {
  GrownFrame grown = grownInFrame2();
  grown.settings.corrections.push_back(walledIn3(grown));
  const FrameCarrier carrier = carrierOf(grown);
  const std::vector<FrameResult> up = carryThrough(carrier, grown.result, 5),
                                 down = carryThrough(carrier, grown.result, 0);
  REQUIRE(up.size() == 3);
  for (const FrameResult& r : up) {
    INFO("frame " << r.frame);
    CHECK(r.isTrusted());
    CHECK(r.under.walls == walled().walls);
    CHECK(nearestToWall(r) > kWall.radius);
  }
  // On the other side of the frame that was grown nothing has changed.
  REQUIRE(down.size() == 2);
  for (const FrameResult& r : down) {
    CHECK(r.under.walls.empty());
    CHECK(nearestToWall(r) < kWall.radius);
  }
  // Nor on the way back from the last frame, where a frame starts from another surface.
  const FrameResult back = carrier.carry(up[1], 3);
  CHECK(back.from == 4);
  CHECK(back.frame == 3);
}

TEST_CASE("a correction that was stopped by hand ends there, and is not told as unfinished") {
  GrownFrame grown = grownInFrame2();
  FrameCorrection correction = walledIn3(grown);
  correction.request.constraints = {};
  correction.request.parameters.maxIterations = 1;
  grown.settings.corrections = {correction};
  const FrameResult limited = carrierOf(grown).carry(grown.result, 3);
  REQUIRE(limited.faults.size() == 1);
  CHECK(limited.faults[0].fault == FrameFault::unfinished);
  grown.settings.corrections[0].stopAt = 1;
  const FrameResult stopped = carrierOf(grown).carry(grown.result, 3);
  CHECK(stopped.iterations == 1);
  CHECK(stopped.faults.empty());
  CHECK(stopped.mesh.points == limited.mesh.points);
}

TEST_CASE("what is changed on the way holds from that iteration on, and in the frames beyond") {
  GrownFrame grown = grownInFrame2();
  FrameCorrection correction{3, carriedRequest(grown.settings, 3)};
  const Parameters parameters = correction.request.parameters;
  correction.changes = {{1, parameters, std::nullopt, walled()}};
  CHECK(finalRequest(correction).constraints == walled());
  CHECK(correction.request.constraints.empty());
  grown.settings.corrections = {correction};
  const std::vector<FrameResult> frames = carryThrough(carrierOf(grown), grown.result, 4);
  CHECK(frames[0].under.walls == walled().walls);
  CHECK(nearestToWall(frames[1]) > kWall.radius);
  FrameCorrection other = correction;
  CHECK(other == correction);
  other.changes[0].constraints = Constraints{};
  CHECK_FALSE(other == correction);
  other = correction;
  other.stopAt = 4;
  CHECK_FALSE(other == correction);
}

TEST_CASE(
    "what is changed after the surface was at rest is changed when it is at rest, if that is earlier now") {
  GrownFrame grown = grownInFrame2();
  FrameCorrection correction{3, carriedRequest(grown.settings, 3)};
  const Parameters parameters = correction.request.parameters;
  correction.changes = {{500, parameters, std::nullopt, walled()}};
  grown.settings.corrections = {correction};
  const FrameResult r = carrierOf(grown).carry(grown.result, 3);
  CHECK(r.iterations < 500);
  CHECK(r.under.walls == walled().walls);
  CHECK(nearestToWall(r) > kWall.radius);
}

TEST_CASE("a correction that the frame cannot follow is told, and starts no other") {
  GrownFrame grown = grownInFrame2();
  FrameCorrection correction = walledIn3(grown);
  const bool isSeed = GENERATE(true, false);
  if (isSeed)
    correction.request.seeds = {{Vec3(500, 0, 0)}};
  else
    correction.request.parameters.range = IntensityRange{200, 100};
  grown.settings.corrections = {correction};
  const std::vector<FrameResult> frames = carryThrough(carrierOf(grown), grown.result, 3);
  REQUIRE(frames.size() == 1);
  CHECK_FALSE(frames[0].isTrusted());
  REQUIRE(frames[0].faults.size() == 1);
  CHECK(frames[0].faults[0].fault == FrameFault::noObject);
  CHECK(frames[0].faults[0].finding.causes.size() == 1);
}

TEST_CASE("of several corrections the last one before a frame counts, seen from the frame that was grown") {
  OverTimeSettings settings;
  settings.grownFrame = 5;
  settings.request.seeds = {{kMiddle}};
  settings.request.constraints.pins = {{kMiddle, 1, 0}};
  settings.request.constraints.vetoes = {{3, kMiddle}};
  for (const int frame : {2, 7, 9}) {
    FrameCorrection c{frame, settings.request};
    c.request.parameters.candidate = frame;
    settings.corrections.push_back(c);
  }
  const auto candidate = [&](int frame) { return carriedRequest(settings, frame).parameters.candidate; };
  CHECK(candidate(6) == 1);
  CHECK(candidate(7) == 7);
  CHECK(candidate(8) == 7);
  CHECK(candidate(12) == 9);
  CHECK(candidate(4) == 1);
  CHECK(candidate(2) == 2);
  CHECK(candidate(0) == 2);
  // An object that has moved there from the frame beside it is no choice.
  settings.corrections[2].isOfMoved = true;
  CHECK(candidate(12) == 7);
  // What names an iteration stays in its own frame.
  CHECK(carriedRequest(settings, 8).constraints.empty());
}

TEST_CASE("every fault of a frame has a name of its own") {
  std::set<std::string> names;
  int failures = 0;
  for (int f = 0; f <= static_cast<int>(FrameFault::unfinished); ++f) {
    names.insert(frameFaultName(static_cast<FrameFault>(f)));
    failures += isFailure(static_cast<FrameFault>(f));
  }
  CHECK(names.size() == 11);
  CHECK(failures == 6);
  CHECK(leakFault({}).fault == FrameFault::leaked);
  CHECK(leakFault({}).finding.kind == FindingKind::frameLeaked);
}
