// A growth that begins with a surface that is there already.

#include "tests/core/evolution/contour_support.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::testing;

TEST_CASE("what a surface of a few large faces holds is looked for in a ball that lies in it",
          "[evolution][start]") {
  const double halfSide = 4;
  TriangleSoup box =
      handlebody::zoo::cube(1);  // its corners are √3 times as far from the middle as its faces
  for (Vec3& p : box.points) p = kMiddle + 2 * halfSide * (p - Vec3(0.5, 0.5, 0.5));
  Constraints constraints;
  constraints.start = StartSurface{};
  constraints.start->path = "box.stl";
  constraints.start->mesh = std::make_shared<const TriangleSoup>(box);
  constraints.start->inside = kMiddle;
  const ActiveContour contour(ballVolume(), {}, {}, constraints);
  REQUIRE(contour.parameters().seeds.size() == 1);
  CHECK(contour.parameters().seeds[0].radius.value() > halfSide / 2);
  CHECK(contour.parameters().seeds[0].radius.value() < halfSide);
}
