#include <Eigen/Geometry>

#include "tests/support/catch.h"
#include "ui/view/surface_scene.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

Vec3 screenRight(const CameraPose& pose) { return pose.up.cross(pose.towardsEye); }

}  // namespace

TEST_CASE("The camera stands where it looks from, with the patient upright", "[camera]") {
  const CameraPose above = lookingFrom({}, Plane::axial, false),
                   front = lookingFrom({}, Plane::coronal, false),
                   left = lookingFrom({}, Plane::sagittal, false);
  CHECK(above.towardsEye == Vec3(0, 0, 1));  // superior
  CHECK(above.up == Vec3(0, -1, 0));         // anterior
  CHECK(front.towardsEye == Vec3(0, -1, 0));
  CHECK(front.up == Vec3(0, 0, 1));
  CHECK(screenRight(front) == Vec3(1, 0, 0));  // face to face: the patient's left on the right
  CHECK(left.towardsEye == Vec3(1, 0, 0));
  CHECK(screenRight(left) == Vec3(0, 1, 0));  // seen from the patient's left the back is on the right
}

TEST_CASE("From the opposite side left and right are exchanged", "[camera]") {
  for (Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    const CameraPose there = lookingFrom({}, plane, false), back = lookingFrom({}, plane, true);
    CHECK(there.towardsEye == -back.towardsEye);
    CHECK(screenRight(there) == -screenRight(back));
  }
}

TEST_CASE("A flight begins and ends at its poses and keeps the axes square on the way", "[camera]") {
  CameraPose from = lookingFrom({}, Plane::axial, false), to = lookingFrom({}, Plane::sagittal, true);
  from.focus = Vec3(1, 2, 3);
  from.height = 10;
  to.focus = Vec3(-4, 0, 8);
  to.height = 1000;
  CHECK((between(from, to, 0).towardsEye - from.towardsEye).norm() < 1e-12);
  CHECK((between(from, to, 1).up - to.up).norm() < 1e-12);
  CHECK((between(from, to, 1).focus - to.focus).norm() < 1e-12);
  const CameraPose middle = between(from, to, 0.5);
  CHECK(middle.height == Approx(100));
  CHECK(middle.up.norm() == Approx(1));
  CHECK(middle.towardsEye.norm() == Approx(1));
  CHECK(std::abs(middle.up.dot(middle.towardsEye)) < 1e-12);
}

TEST_CASE("What is to be seen of an event is all of its trace", "[camera]") {
  EventTrace trace;
  CHECK_FALSE(sightOf(trace).has_value());
  trace.collidingFaces.push_back({Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)});
  trace.boundaryLoops.push_back({Vec3(0, 0, 4)});
  const Sight sight = *sightOf(trace);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 4)})
    CHECK((p - sight.centre).norm() <= sight.radius + 1e-12);
}
