// The object of one frame, moved to the next: where clicks mean another one there.

#include <algorithm>
#include <random>

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

//! 170 outside; a ball in the middle, 90 beyond a plane across x and 250 before it.
Volume ballOfTwo(double radius, double plane) {
  void* buffer = nullptr;
  const Volume whole = balls({{kMiddle, radius}}), image = makeVolume(whole.grid, VoxelType::uint8, &buffer);
  for (std::size_t i = 0; i < whole.grid.voxelCount(); ++i) {
    const double part = (180 - whole.data<std::uint8_t>()[i]) / 120.0;
    const bool isDark = static_cast<double>(i % 40) > plane;
    static_cast<std::uint8_t*>(buffer)[i] = static_cast<std::uint8_t>(170 + (isDark ? -80 : 80) * part);
  }
  return image;
}

//! With white noise of that standard deviation.
Volume noisy(const Volume& image, double deviation) {
  void* buffer = nullptr;
  const Volume out = makeVolume(image.grid, VoxelType::uint8, &buffer);
  std::mt19937 random(7);
  for (std::size_t i = 0; i < image.grid.voxelCount(); ++i) {
    double sum = -6;  // of twelve: nearly normal, and the same everywhere
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(random()) / 4294967296.0;
    const double value = image.data<std::uint8_t>()[i] + deviation * sum;
    static_cast<std::uint8_t*>(buffer)[i] = static_cast<std::uint8_t>(std::clamp(value, 0., 255.));
  }
  return out;
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

TEST_CASE("where what clicks mean fails that of the frame before is taken if the image shows it, and told") {
  // The cap with the click is too small to be the same object, and no range of intensities has both parts.
  const FrameResult r = carriedIn(noisy(ballOfTwo(12, 22), 4));
  CHECK(r.isTrusted());
  CHECK(r.volume == Approx(ball(12)).epsilon(0.05));
  REQUIRE(has(r, FrameFault::movedObject));
  const Finding told = toldOf(r, FrameFault::movedObject);
  CHECK(told.kind == FindingKind::frameMovedInstead);
  CHECK(told.number("from_frame") == 0);
  REQUIRE(told.causes.size() == 1);
  CHECK(told.causes[0].kind == FindingKind::frameJumped);
}

TEST_CASE("where what clicks mean fails and the image shows nothing else the frame fails") {
  const double noise = GENERATE(0., 5., 20.);
  const FrameResult r = carriedIn(noisy(balls({{kClick, 5}}), noise));
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
  CHECK_FALSE(carriedIn(noisy(ballOfTwo(12, 22), 4), parameters).isTrusted());
}

TEST_CASE("a frame that is corrected begins with the object that was taken there") {
  const Volume next = ballWithCore(12, 9.5);
  GrownFrame grown = growIn(balls({{kMiddle, 12}}), 0, {{{kClick}}, {}, {}});
  const auto load = [&](int frame) { return frame == 0 ? balls({{kMiddle, 12}}) : next; };
  const FrameResult taken = FrameCarrier(grown.settings, hooksOf(load)).carry(grown.result, 1);
  REQUIRE(taken.moved);
  const Request asked = carriedRequest(grown.settings, 1);
  FrameCorrection correction{1, asked, {{2, asked.parameters, {}, asked.constraints}}, {}, true};
  grown.settings.corrections = {correction};
  const FrameResult again = FrameCarrier(grown.settings, hooksOf(load)).carry(grown.result, 1);
  CHECK(again.isCorrected);
  CHECK(again.moved);
  CHECK(again.isTrusted());
  CHECK(again.volume == Approx(taken.volume).epsilon(1e-3));
  // Without it: what the clicks mean there.
  grown.settings.corrections[0].isOfMoved = false;
  CHECK_FALSE(grown.settings.corrections[0] == correction);
  const FrameResult anew = FrameCarrier(grown.settings, hooksOf(load)).carry(grown.result, 1);
  CHECK(anew.volume < ball(11));
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
