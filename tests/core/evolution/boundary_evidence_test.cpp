#include "core/evolution/boundary_evidence.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/evolution/clicked_object.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using testing::cubicGrid;
using testing::volumeByIndex;

namespace {

const Vec3 kCentre(24, 24, 24);
constexpr double kRadius = 10;

//! A dark ball; `gain` is how many times as bright the image is at one side as at the other, `opening` the
//! height of a cap, in radii, in which the ball fades into what is around it.
struct Scene {
  double gain = 1, noise = 2, opening = 0;
};

Volume ballIn(const Scene& scene) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, scene.noise);
  return volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    const Vec3 p = Vec3(i, j, k) - kCentre;
    const double ball = 40 + 80 * std::clamp(p.norm() - kRadius + 0.5, 0.0, 1.0);
    const bool isOpen =
        scene.opening > 0 && p[2] > kRadius * (1 - scene.opening) && p.head<2>().norm() < kRadius;
    const double fading = 40 + 80 * std::clamp(p[2] / kRadius - 1 + scene.opening, 0.0, 1.0);
    return (isOpen ? fading : ball) * std::pow(scene.gain, i / 48.0) + noise(random);
  });
}

std::vector<Seed> seeds() { return {Seed{kCentre, 4.0}}; }

BoundaryEvidence evidenceIn(const Scene& scene) {
  Parameters p;
  p.object = ObjectKind::dark;
  return evidenceOf(chooseObject(ballIn(scene), seeds(), p), seeds());
}

//! Dark, with a level of its own.
ObjectChoice withLevel(const Volume& volume, double level) {
  ObjectChoice choice;
  choice.range = {-INFINITY, level};
  choice.contrast = level - 40;
  choice.volume = std::make_shared<SmoothedVolume>(volume, 0.5);
  choice.levels = std::make_shared<LevelField>(volume.grid, level);
  return choice;
}

}  // namespace

TEST_CASE("an edge all around is clear, in noise and with a gain") {
  CHECK(evidenceIn({}).isBeyondDoubt());
  CHECK(evidenceIn({}).isClear());
  CHECK(evidenceIn({1, 12, 0}).isClear());
  CHECK(evidenceIn({4, 2, 0}).isClear());
}

TEST_CASE("a boundary that lies without an edge for a part of its way is not") {
  const BoundaryEvidence whole = evidenceOf(withLevel(ballIn({}), 80), seeds());
  const BoundaryEvidence open = evidenceOf(withLevel(ballIn({1, 2, 1}), 80), seeds());
  CAPTURE(whole.weakest, open.weakest);
  CHECK(whole.isClear());
  CHECK(whole.isPlausible());
  CHECK(open.weakest < 0.6 * whole.weakest);
  CHECK_FALSE(open.isClear());
}

TEST_CASE("a boundary as low as the noise, on the border, or around nothing is not clear") {
  const Volume volume = ballIn({1, 12, 0});
  const BoundaryEvidence low = evidenceOf(withLevel(volume, 50), seeds());
  CHECK(low.noise > 0.35);
  CHECK_FALSE(low.isClear());
  CHECK_FALSE(low.isPlausible());

  const BoundaryEvidence all = evidenceOf(withLevel(ballIn({}), 200), seeds());
  CHECK(all.unseen == Approx(1));
  CHECK_FALSE(all.isClear());

  const BoundaryEvidence nothing = evidenceOf(withLevel(ballIn({}), 20), seeds());
  CHECK(nothing.weakest == 0);
  CHECK_FALSE(nothing.isClear());
}

TEST_CASE("what closes a neck is no part of the boundary") {
  ObjectChoice choice = withLevel(ballIn({1, 2, 1}), 80);  // it fades into what is above it
  REQUIRE_FALSE(evidenceOf(choice, seeds()).isClear());
  const std::size_t slice = 49 * 49;
  VoxelMarks closed(49 * slice, 0);
  std::fill(closed.begin() + 25 * slice, closed.end(), static_cast<unsigned char>(1));
  NeckCut cut;
  cut.barrier =
      std::make_shared<Barrier>(std::array<int, 3>{0, 0, 0}, std::array<int, 3>{49, 49, 49}, closed);
  choice.neck = std::make_shared<NeckCut>(std::move(cut));
  CHECK(evidenceOf(choice, seeds()).isClear());
}

namespace {

//! An organ 40 above the tissue of a body, and air, 900 below, around that; the body goes on beyond two faces
//! of the volume. The strongest boundary around the organ is the skin.
const Vec3 kOrgan(26, 24, 24);
Volume body() {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 6);
  return volumeByIndex(cubicGrid(49), [&](int i, int j, int k) {
    const double organ = 40 * std::clamp(10.5 - (Vec3(i, j, k) - kOrgan).norm(), 0.0, 1.0);
    const bool isInBody = std::abs(i - 24) < 19 && std::abs(j - 24) < 19;
    return (isInBody ? 100 + organ : -800) + noise(random);
  });
}

}  // namespace

TEST_CASE("a seed with a radius in an organ means the organ where the strongest boundary is no clear one") {
  const Volume volume = body();
  const std::vector<Seed> seed{Seed{kOrgan, 4.0}};
  const ObjectChoice strongest = chooseObject(volume, seed, {});
  REQUIRE_FALSE(evidenceOf(strongest, seed).isClear());
  const ClickedObject found = findClickedObject(volume, seed, {});
  CHECK(found.image->inside(kOrgan) > 0);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3 out(0, 0, 0);
      out[axis] = side;
      CHECK(found.image->inside(kOrgan + 8 * out) > 0);
      CHECK(found.image->inside(kOrgan + 13 * out) < 0);
    }
  CHECK(found.choices->areKnown());
}

TEST_CASE("what a boundary beyond doubt may mean besides is looked for when it is asked for") {
  const ClickedObject found = findClickedObject(ballIn({}), seeds(), {});
  CHECK_FALSE(found.choices->areKnown());
  CHECK_FALSE(found.choices->get().candidates.empty());
}
