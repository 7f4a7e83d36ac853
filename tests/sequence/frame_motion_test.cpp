// How what lies at a surface moves from frame to frame.

#include <numeric>

#include "core/sequence/frame_motion.h"
#include "tests/sequence/beating_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

TriangleSoup ballSurface() { return growIn(balls({{kMiddle, 10}}), 0, {{{kMiddle}}, {}, {}}).result.mesh; }

Vec3 centreOf(const TriangleSoup& surface) {
  const Vec3 sum = std::accumulate(surface.points.begin(), surface.points.end(), Vec3(Vec3::Zero()));
  return sum / static_cast<double>(surface.points.size());
}

double radiusAround(const TriangleSoup& surface, const Vec3& centre) {
  double sum = 0;
  for (const Vec3& p : surface.points) sum += (p - centre).norm();
  return sum / static_cast<double>(surface.points.size());
}

//! Values twice as high, and 5 more.
Volume withGain(const Volume& volume) {
  void* buffer = nullptr;
  Volume out = makeVolume(volume.grid, VoxelType::uint16, &buffer);
  for (std::size_t i = 0; i < volume.grid.voxelCount(); ++i)
    static_cast<std::uint16_t*>(buffer)[i] =
        static_cast<std::uint16_t>(2 * volume.data<std::uint8_t>()[i] + 5);
  return out;
}

}  // namespace

TEST_CASE("between two frames that are the same nothing moves") {
  const Volume image = balls({{kMiddle, 10}});
  const TriangleSoup surface = ballSurface(), moved = FrameMotion(image, image, surface).moved(surface);
  REQUIRE(moved.triangles == surface.triangles);
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    CHECK((moved.points[i] - surface.points[i]).norm() < 1e-5);
}

TEST_CASE("a ball that is shifted or shrinks takes its surface along, with another gain, too") {
  const TriangleSoup surface = ballSurface();
  const Volume first = balls({{kMiddle, 10}});
  for (const bool gain : {false, true}) {
    const auto movedTo = [&](const Volume& next) {
      return FrameMotion(first, gain ? withGain(next) : next, surface).moved(surface);
    };
    for (const double part : {0.5, 1.0}) {  // a quarter stays behind: the steps are smoothed
      INFO("gain " << gain << ", part " << part);
      const Vec3 shift = part * Vec3(3, -2, 1.5);
      const TriangleSoup shifted = movedTo(balls({{kMiddle + shift, 10}}));
      CHECK((centreOf(shifted) - centreOf(surface) - shift).norm() < 0.3 * shift.norm());
      CHECK(radiusAround(shifted, centreOf(shifted)) == Approx(10).epsilon(0.03));
    }
    CHECK(radiusAround(movedTo(balls({{kMiddle, 8.5}})), kMiddle) == Approx(8.5).epsilon(0.03));
  }
}

TEST_CASE("where the images show nothing nothing moves") {
  const TriangleSoup surface = ballSurface(),
                     moved = FrameMotion(balls({}), balls({}), surface).moved(surface);
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    CHECK((moved.points[i] - surface.points[i]).norm() < 1e-5);
}
