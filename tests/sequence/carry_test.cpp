// A surface that is carried from frame to frame.

#include <algorithm>
#include <cmath>
#include <regex>

#include "core/collision/certify.h"
#include "core/errors.h"
#include "core/mesh/validity.h"
#include "core/sequence/carried_seeds.h"
#include "core/sequence/cycle_check.h"
#include "core/sequence/drift.h"
#include "tests/sequence/beating_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

FrameResult firstOf(const FrameCarrier& carrier, const FrameResult& start) { return carrier.carry(start, 1); }

//! Carried from a ball onto another volume.
FrameResult carriedOnto(const Volume& next, bool holdTopology = true,
                        const Volume& first = balls({{kMiddle, 10}}), const Constraints& constraints = {}) {
  GrownFrame grown = growIn(first, 0, {{{kMiddle}}, {}, constraints});
  grown.settings.holdTopology = holdTopology;
  return firstOf(FrameCarrier(grown.settings, hooksOf(framesOf(first, next))), grown.result);
}

}  // namespace

TEST_CASE("a surface is carried through a beating phantom with its volume, its topology and its place") {
  BeatingOptions options;
  options.frames = 5;
  options.image.spacing = Vec3::Constant(2);
  const BeatingPhantom phantom(options);
  const int start = GENERATE(0, 2);
  const GrownFrame grown = growIn(phantom.image(start), start, {{{phantom.seed()}}, {}, {}});
  const FrameCarrier carrier(grown.settings, hooksOf([&](int f) { return phantom.image(f); }));
  std::vector<FrameResult> frames = carryThrough(carrier, grown.result, 0);
  std::reverse(frames.begin(), frames.end());
  frames.push_back(grown.result);
  for (FrameResult& r : carryThrough(carrier, grown.result, 4)) frames.push_back(std::move(r));
  REQUIRE(frames.size() == 5);
  for (int f = 0; f < 5; ++f) {
    const FrameResult& r = frames[f];
    INFO("frame " << f << " of " << start);
    CHECK(r.frame == f);
    CHECK(r.isTrusted());
    CHECK(r.faults.empty());
    CHECK(r.components == 1);
    CHECK(r.genus == 0);
    CHECK(certify(r.mesh).boundsBody());
    CHECK(diceOf(r.mesh, phantom.truth(f)) > 0.97);
  }
  CHECK(std::abs(curveOf(frames).ejectionFraction - phantom.sampledEjection()) < 0.02);
}

TEST_CASE("carrying twice gives the same bits") {
  const FrameResult a = carriedOnto(balls({{kMiddle, 8}})), b = carriedOnto(balls({{kMiddle, 8}}));
  CHECK(a.mesh.points == b.mesh.points);
  CHECK(a.mesh.triangles == b.mesh.triangles);
}

TEST_CASE("a ball that has grown, shrunk or gone beside is followed both ways") {
  CHECK(carriedOnto(balls({{kMiddle, 12}})).volume == Approx(ball(12)).epsilon(0.03));
  CHECK(carriedOnto(balls({{kMiddle, 8.5}})).volume == Approx(ball(8.5)).epsilon(0.03));
  const FrameResult moved = carriedOnto(balls({{kMiddle + Vec3(4, -3, 0), 10}}));
  CHECK(moved.volume == Approx(ball(10)).epsilon(0.03));
  CHECK(diceOf(moved.mesh, rasterize(moved.mesh, balls({}).grid)) == 1);
  CHECK(moved.isTrusted());
}

TEST_CASE("an object that comes apart is held together, unless its topology is free") {
  const Volume whole = balls({{kMiddle - Vec3(6, 0, 0), 8}, {kMiddle + Vec3(6, 0, 0), 8}});
  const Volume parts = balls({{kMiddle - Vec3(9, 0, 0), 7}, {kMiddle + Vec3(9, 0, 0), 7}});
  GrownFrame grown = growIn(whole, 0, {{{kMiddle - Vec3(8, 0, 0)}, {kMiddle + Vec3(8, 0, 0)}}, {}, {}});
  REQUIRE(grown.result.components == 1);
  const auto carried = [&](bool hold) {
    grown.settings.holdTopology = hold;
    return firstOf(FrameCarrier(grown.settings, hooksOf(framesOf(whole, parts))), grown.result);
  };
  const FrameResult held = carried(true);
  CHECK(held.components == 1);
  CHECK(held.genus == 0);
  CHECK(has(held, FrameFault::held));
  const Finding holding = toldOf(held, FrameFault::held);
  CHECK(holding.find("place") != nullptr);
  CHECK(std::regex_match(
      sentence(holding),
      std::regex("the topology was held at (1 place|[0-9]+ places), the first at [-0-9.e,]+ mm")));
  CHECK((holding.kind == FindingKind::frameHeldAtPlace) == (holding.number("places") == 1));
  const FrameResult free = carried(false);
  CHECK(free.components == 2);
  CHECK(has(free, FrameFault::changed));
  CHECK(toldOf(free, FrameFault::changed).kind == FindingKind::frameCameApart);
  CHECK(sentence(toldOf(free, FrameFault::changed)) ==
        "the topology changes from 1 component of genus 0 to 2 components of genus 0");
  CHECK_FALSE(has(free, FrameFault::held));
}

TEST_CASE("a frame without the object is told, and so is one in which its volume jumps") {
  const FrameResult none = carriedOnto(balls({}));
  CHECK_FALSE(none.isTrusted());
  CHECK(has(none, FrameFault::noObject));
  CHECK(none.mesh.triangles.empty());
  const Finding nothing = toldOf(none, FrameFault::noObject);
  CHECK(nothing.kind == FindingKind::frameNoObject);
  REQUIRE(nothing.causes.size() == 1);
  CHECK(nothing.causes.front().kind != FindingKind::other);
  CHECK(sentence(nothing) == sentence(nothing.causes.front()));
  const FrameResult small = carriedOnto(balls({{kMiddle, 5}}));
  CHECK_FALSE(small.isTrusted());
  CHECK(has(small, FrameFault::jumped));
  CHECK_FALSE(small.mesh.triangles.empty());
  const Finding jump = toldOf(small, FrameFault::jumped);
  CHECK(jump.kind == FindingKind::frameJumped);
  CHECK(jump.number("from_frame") == 0);
  CHECK(jump.number("from_ml") == Approx(ball(10) / 1000).epsilon(0.03));
  CHECK(jump.number("to_ml") == small.volume / 1000);
  CHECK(std::regex_match(sentence(jump),
                         std::regex(R"(the volume jumps from [0-9.]+ ml in frame 0 to [0-9.]+ ml)")));
}

TEST_CASE("a surface that still moves at the limit of the iterations is told, with the limit's name") {
  const Volume image = balls({{kMiddle, 10}});
  GrownFrame grown = growIn(image, 0, {{{kMiddle}}, {}, {}});
  grown.settings.request.parameters.maxIterations = 1;
  const FrameResult r =
      firstOf(FrameCarrier(grown.settings, hooksOf(framesOf(image, balls({{kMiddle, 12}})))), grown.result);
  CHECK(toldOf(r, FrameFault::unfinished).kind == FindingKind::frameAtLimit);
  CHECK(sentence(toldOf(r, FrameFault::unfinished)) ==
        "the surface was not at rest of its own accord (max-iterations)");
}

TEST_CASE("where the likeliest object is another one, the candidate that is nearest in volume is taken") {
  const Volume image = ballWithCore(12, 5);
  const GrownFrame alone = growIn(image, 1, {{{kMiddle}}, {}, {}});
  REQUIRE(alone.result.volume == Approx(ball(5)).epsilon(0.1));
  const FrameResult r = carriedOnto(image, true, balls({{kMiddle, 12}}));
  CHECK(r.isTrusted());
  CHECK(has(r, FrameFault::otherObject));
  const Finding other = toldOf(r, FrameFault::otherObject);
  CHECK(other.number("candidate") > 1);
  REQUIRE(other.causes.size() == 1);
  CHECK(sentence(other) == "another object is likelier there, but it fails (" +
                               sentence(other.causes.front()) + "); candidate " +
                               std::to_string(static_cast<int>(other.number("candidate"))) + " was taken");
  CHECK(r.volume == Approx(ball(12)).epsilon(0.05));
}

TEST_CASE("a frame that cannot be read starts no other: the next starts from the last that is trusted") {
  const GrownFrame grown = growIn(balls({{kMiddle, 10}}), 3, {{{kMiddle}}, {}, {}});
  const auto load = [](int frame) {
    if (frame == 5) throw InputError("frame 5 is damaged.");
    return balls({{kMiddle, 10 - 0.4 * (frame - 3)}});
  };
  std::vector<int> told;
  const auto frames = carryThrough(FrameCarrier(grown.settings, hooksOf(load)), grown.result, 7,
                                   [&](const FrameResult& r) { told.push_back(r.frame); });
  CHECK(told == std::vector<int>{4, 5, 6, 7});
  CHECK(frames[0].from == 3);
  CHECK(has(frames[1], FrameFault::unreadable));
  CHECK(sentence(toldOf(frames[1], FrameFault::unreadable)) == "frame 5 is damaged.");
  CHECK_FALSE(frames[1].isTrusted());
  CHECK(frames[2].from == 4);
  CHECK(frames[2].isTrusted());
  CHECK(frames[3].from == 6);
  CHECK(frames[3].volume == Approx(ball(8.4)).epsilon(0.03));
}

TEST_CASE("what comes from a frame that failed is made, and not trusted") {
  GrownFrame grown = growIn(balls({{kMiddle, 10}}), 3, {{{kMiddle}}, {}, {}});
  grown.result.faults.push_back(leakFault({}));
  const auto load = [](int frame) { return balls({{kMiddle, 10 - 0.4 * (frame - 3)}}); };
  const auto frames = carryThrough(FrameCarrier(grown.settings, hooksOf(load)), grown.result, 5);
  REQUIRE(frames.size() == 2);
  for (const FrameResult& r : frames) {
    CHECK_FALSE(r.isTrusted());
    CHECK(r.startsNext());
    CHECK(toldOf(r, FrameFault::fromFailed).number("from_frame") == r.frame - 1);
  }
  CHECK(frames[1].volume == Approx(ball(9.2)).epsilon(0.03));
  std::vector<FrameResult> all{grown.result};
  all.insert(all.end(), frames.begin(), frames.end());
  for (const DriftCheck check : {DriftCheck::back, DriftCheck::wrap})
    CHECK(checkCycle(FrameCarrier(grown.settings, hooksOf(load)), all, grown.result, check,
                     grown.settings.edgeLength)
              .empty());
}

TEST_CASE("how a growth ended is told, unless it was ended on purpose") {
  CHECK(faultsAtEnd(StopReason::converged, {}).empty());
  CHECK(faultsAtEnd(StopReason::running, {}).empty());
  for (const StopReason stopped : {StopReason::maxIterations, StopReason::stuck, StopReason::frozen}) {
    const std::vector<ToldFault> faults = faultsAtEnd(stopped, {});
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].fault == FrameFault::unfinished);
  }
  const std::vector<ToldFault> held = faultsAtEnd(StopReason::converged, {HeldPlace{}});
  REQUIRE(held.size() == 1);
  CHECK(held[0].fault == FrameFault::held);
}

TEST_CASE("walls stay where they are in every frame") {
  Constraints constraints;
  constraints.walls.balls.push_back({kMiddle + Vec3(12, 0, 0), 4});
  const FrameResult r = carriedOnto(balls({{kMiddle, 14}}), true, balls({{kMiddle, 10}}), constraints);
  REQUIRE_FALSE(r.mesh.triangles.empty());
  for (const Vec3& p : r.mesh.points) CHECK((p - (kMiddle + Vec3(12, 0, 0))).norm() > 3.99);
  CHECK(r.volume > ball(11));
  CHECK(r.under.walls == constraints.walls);  // a polish keeps out of them, too
  CHECK(r.under.edgeLength > 0);
}

TEST_CASE("clicks are carried where the surface holds them, and replaced by its deepest place where not") {
  const GrownFrame grown = growIn(balls({{kMiddle, 10}}), 0, {{{kMiddle}}, {}, {}});
  const TriangleSoup& mesh = grown.result.mesh;
  const Seed inside{kMiddle + Vec3(2, 0, 0), 30.0}, far{Vec3(3, 3, 3)}, rim{kMiddle + Vec3(9.5, 0, 0)};
  Seed outside{Vec3(35, 35, 35)}, swallowed{kMiddle};
  outside.background = swallowed.background = true;
  const std::vector<Seed> kept = carriedSeeds({inside, far, rim, outside, swallowed}, mesh, 2);
  REQUIRE(kept.size() == 2);
  CHECK(kept[0].centre == inside.centre);
  CHECK(*kept[0].radius < 8.5);
  CHECK(kept[1] == outside);
  const std::vector<Seed> other = carriedSeeds({far}, mesh, 2);
  REQUIRE(other.size() == 1);
  CHECK((other[0].centre - kMiddle).norm() < 2);
}

TEST_CASE("drift is none between equal surfaces, and the shift between shifted ones") {
  const GrownFrame grown = growIn(balls({{kMiddle, 10}}), 0, {{{kMiddle}}, {}, {}});
  TriangleSoup shifted = grown.result.mesh;
  for (Vec3& p : shifted.points) p.x() += 1;
  const Drift none = driftBetween(grown.result.mesh, grown.result.mesh, 2);
  CHECK(none.isBack);
  CHECK(none.dice == 1);
  CHECK(none.percentile95 < 1e-6);
  CHECK(none.volumeRatio == Approx(1));
  const Drift one = driftBetween(grown.result.mesh, shifted, 2);
  CHECK(one.dice < 0.95);
  CHECK(one.mean == Approx(0.5).margin(0.1));  // the mean of |cos| over a sphere
  CHECK(one.percentile95 <= 1.001);
}
