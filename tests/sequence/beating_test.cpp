#include "sample_volumes/beating.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "core/errors.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

BeatingOptions optionsOf(double ejection, int frames, double spacing) {
  BeatingOptions o;
  o.ejection = ejection;
  o.frames = frames;
  o.image.spacing = Vec3::Constant(spacing);
  o.image.noise = 0;
  return o;
}

double voxelVolume(const BeatingPhantom& phantom, int frame) {
  const Volume truth = phantom.truth(frame);
  double count = 0;
  for (std::size_t i = 0; i < truth.grid.voxelCount(); ++i) count += truth.data<std::uint8_t>()[i];
  return count * truth.grid.spacing.prod();
}

//! The angle (degrees) of the lobe of largest radius in the plane at z mm from the middle, up to 120 degrees.
double lobeAngle(const BeatingPhantom& phantom, int frame, double z) {
  double best = 0, least = 1e9;
  for (double degrees = 0; degrees < 120; degrees += 0.5) {
    const double a = degrees * std::numbers::pi / 180;
    const double d = phantom.distance(frame, phantom.seed() + Vec3(15 * std::cos(a), 15 * std::sin(a), z));
    if (d < least) {
      least = d;
      best = degrees;
    }
  }
  return best;
}

}  // namespace

TEST_CASE("the truth of the beating phantom holds the volume that it says, in every frame") {
  const BeatingPhantom phantom(optionsOf(0.6, 5, 1));
  for (int f = 0; f < 5; ++f) CHECK(voxelVolume(phantom, f) == Approx(phantom.volume(f)).epsilon(0.005));
}

TEST_CASE("the ejection fraction is the one that was asked for, where a frame is at end systole") {
  for (const double ejection : {0.3, 0.5, 0.7}) {
    const BeatingPhantom phantom(optionsOf(ejection, 20, 2));
    CHECK(phantom.sampledEjection() == Approx(ejection).epsilon(1e-12));
    CHECK(1 - phantom.volume(7) / phantom.volume(0) == Approx(ejection).epsilon(1e-12));
    for (int f = 16; f < 20; ++f) CHECK(phantom.volume(f) == Approx(phantom.volume(0)));
    CHECK(phantom.time(7) == Approx(350));
  }
}

TEST_CASE("apex and base turn against each other at end systole, and not at end diastole") {
  const BeatingPhantom phantom(optionsOf(0.6, 20, 2));
  CHECK(std::abs(lobeAngle(phantom, 0, 15) - lobeAngle(phantom, 0, -15)) < 1);
  // 20 degrees over 76 mm: 7.9 over 30 mm.
  const double turn = lobeAngle(phantom, 7, 15) - lobeAngle(phantom, 7, -15);
  CHECK(std::abs(std::remainder(turn, 120) - 20 * 30 / 76.0) < 1);
}

TEST_CASE("the image is half-way between cavity and wall on the surface, and the wall thickens") {
  const BeatingPhantom phantom(optionsOf(0.6, 20, 1));
  const auto along = [&](int frame) {  // bright voxels from the middle outwards along x
    const Volume image = phantom.image(frame);
    const Vec3 middle = image.grid.toIndex(phantom.seed());
    const auto row = static_cast<std::size_t>(std::lround(middle.z())) * 1u;
    const std::size_t nx = static_cast<std::size_t>(image.grid.size[0]),
                      ny = static_cast<std::size_t>(image.grid.size[1]);
    int bright = 0;
    for (std::size_t x = nx / 2; x < nx; ++x)
      bright +=
          image
              .data<std::uint8_t>()[(row * ny + static_cast<std::size_t>(std::lround(middle.y()))) * nx + x] >
          150;
    return bright;
  };
  CHECK(along(7) >= along(0) + 2);
  const Volume image = phantom.image(3);
  const Volume truth = phantom.truth(3);
  std::size_t wrong = 0, inside = 0;
  for (std::size_t i = 0; i < image.grid.voxelCount(); ++i) {
    inside += truth.data<std::uint8_t>()[i];
    wrong += (image.data<std::uint8_t>()[i] < 120) != (truth.data<std::uint8_t>()[i] != 0);
  }
  // Grey surroundings lie between: 114 of 120. They are none of the cavity.
  CHECK(inside > 10000);
  CHECK(image.data<std::uint8_t>()[0] > 100);
  CHECK(wrong > 0);
}

TEST_CASE("options without meaning are refused") {
  const auto refused = [](const std::function<void(BeatingOptions&)>& change) {
    BeatingOptions o = optionsOf(0.6, 4, 2);
    change(o);
    CHECK_THROWS_AS(BeatingPhantom(o), UsageError);
  };
  refused([](BeatingOptions& o) { o.frames = 1; });
  refused([](BeatingOptions& o) { o.ejection = 0.81; });
  refused([](BeatingOptions& o) { o.ejection = -0.1; });
  refused([](BeatingOptions& o) { o.period = 0; });
  refused([](BeatingOptions& o) { o.image.spacing = Vec3(1, 1, 5); });
  refused([](BeatingOptions& o) { o.image.size = {20, 20, 20}; });
  refused([](BeatingOptions& o) { o.image.gapVoxels = 1; });
  refused([](BeatingOptions& o) { o.image.bias = 2; });
  refused([](BeatingOptions& o) { o.image.type = VoxelType::uint16; });
}
