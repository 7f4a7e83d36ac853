// The object of one frame, moved to the next: where clicks mean another one there.

#include "core/collision/certify.h"
#include "core/sequence/cycle_check.h"
#include "tests/sequence/beating_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

// It leaves open whether the core or the whole ball is meant.
const Vec3 kClick = kMiddle + Vec3(5, 0, 0);

//! Both frames show the image. In the first the surface encloses the whole ball, as if it had been corrected
//! by clicks that are not carried.
FrameResult carriedIn(const Volume& image, const Parameters& parameters = {}) {
  GrownFrame grown = growIn(balls({{kMiddle, 12}}), 0, {{{kClick}}, {}, {}});
  grown.settings.request.parameters = parameters;
  return FrameCarrier(grown.settings, hooksOf([&](int) { return image; })).carry(grown.result, 1);
}

}  // namespace

TEST_CASE("where clicks mean another object than the frame before had, that one is taken, and told") {
  const Volume next = ballWithCore(12, 9.5);
  const GrownFrame alone = growIn(next, 1, {{{kClick}}, {}, {}});
  REQUIRE(alone.result.volume == Approx(ball(9.7)).epsilon(0.05));
  const FrameResult r = carriedIn(next);
  CHECK(r.isTrusted());
  CHECK(r.volume == Approx(ball(12)).epsilon(0.05));
  CHECK(certify(r.mesh).boundsBody());
  REQUIRE(has(r, FrameFault::movedObject));
  const Finding told = toldOf(r, FrameFault::movedObject);
  CHECK(told.kind == FindingKind::frameMovedObject);
  CHECK(told.number("from_frame") == 0);
  CHECK(told.number("percent") == Approx(69).margin(6));  // Dice of balls of 9.7 and 12
  CHECK(sentence(told).find("with the object of frame 0 as the images move it; the latter was taken") !=
        std::string::npos);
}

TEST_CASE("where what clicks mean fails the frame fails, whatever the frame before had") {
  const FrameResult r = carriedIn(balls({{kClick, 5}}));
  CHECK_FALSE(r.isTrusted());
  CHECK(has(r, FrameFault::jumped));
  CHECK_FALSE(has(r, FrameFault::movedObject));
}

TEST_CASE("a range of intensities says by itself what the object is in every frame") {
  Parameters parameters;
  parameters.range = IntensityRange{0, 115};
  const FrameResult r = carriedIn(ballWithCore(12, 9.5), parameters);
  CHECK_FALSE(has(r, FrameFault::movedObject));
  CHECK(r.volume < ball(11));
}

TEST_CASE("in a cycle what is carried to the first frame comes from the image of the last") {
  // Which is asked for, since the choice is close.
  const auto frame = [](int f) {
    if (f < 0) throw InputError("there is no such frame.");
    return ballWithCore(12, 9.5);
  };
  const GrownFrame grown = growIn(balls({{kMiddle, 12}}), 0, {{{kClick}}, {}, {}});
  const FrameCarrier carrier(grown.settings, hooksOf(frame));
  std::vector<FrameResult> frames{grown.result};
  for (FrameResult& r : carryThrough(carrier, grown.result, 2)) frames.push_back(std::move(r));
  const std::vector<Drift> drifts =
      checkCycle(carrier, frames, grown.result, DriftCheck::wrap, grown.settings.edgeLength);
  REQUIRE(drifts.size() == 1);
  CHECK(drifts[0].isBack);
  CHECK(drifts[0].dice > 0.98);
}
