#include <cmath>

#include "sample_volumes/distances.h"
#include "sample_volumes/shapes.h"
#include "tests/phantoms/helpers.h"

using namespace handlebody;
using namespace handlebody::phantoms;
using namespace handlebody::phantomtest;

namespace {

// f is the signed distance at p exactly if (1) it changes no faster than the distance between points, so that
// |f(p)| is at most the true distance, and (2) p - f(p)·grad f is a point of the surface, so that it is at
// least that. (1) is tried on pairs, (2) point by point except on the medial axis, where there is no
// gradient.
template <typename F>
int expectExact(F&& f, const Vec3& half, double within, bool outsideOnly) {
  RandomPoints random(7);
  int tried = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = random.inBox(half);
    const Vec3 q = p + random.inBox(Vec3(2, 2, 2));
    const double d = f(p);
    if (std::abs(d) > within || std::abs(f(q)) > within || (outsideOnly && d < 0)) continue;
    if (std::abs(d - f(q)) > (p - q).norm() + 1e-6) FAIL("too steep at " << p.transpose());
    const Vec3 g = gradient(f, p);
    if (g.norm() < 0.999) continue;
    ++tried;
    const double missed = std::abs(f(p - d * g));
    if (missed > 1e-3) FAIL("foot of " << p.transpose() << " is " << missed << " mm beside the surface");
  }
  return tried;
}

int expectExactShape(const std::string& name, bool outsideOnly) {
  const Shape& shape = findShape(name);
  return expectExact(shape.distance, shape.extent / 2, 1000, outsideOnly);
}

}  // namespace

TEST_CASE("the distances of cube, torus, sphere, wall, plate, balls and trefoil are exact everywhere") {
  for (const char* name : {"cube", "torus", "sphere", "wall", "plate", "balls", "trefoil"}) {
    INFO(name);
    CHECK(expectExactShape(name, false) > 15000);
  }
}

TEST_CASE("the distances of genus3, dumbbell, rings, tree and neck are exact outside") {
  for (const char* name : {"genus3", "dumbbell", "rings", "tree", "neck"}) {
    INFO(name);
    CHECK(expectExactShape(name, true) > 10000);
  }
}

TEST_CASE("the distance to the cyst's body is exact within 4 mm of its surface") {
  CHECK(expectExact(cystBodyDistance, findShape("cyst").objectHalf, 4, false) > 2000);
}

TEST_CASE("the distance to the gyroid is exact within 3 mm of its surface, but for its edges") {
  const Vec3 within(33, 33, 33);  // the cube that cuts it begins at 34 mm where it is not rounded
  CHECK(expectExact(findShape("gyroid").distance, within, 3, false) > 5000);
}

TEST_CASE("walking along the normal of the cyst's body changes its distance by the way walked") {
  RandomPoints random(3);
  int tried = 0;
  while (tried < 500) {
    Vec3 p = random.inBox(findShape("cyst").objectHalf);
    if (std::abs(cystBodyDistance(p)) > 2) continue;
    for (int i = 0; i < 3; ++i) p -= cystBodyDistance(p) * gradient(cystBodyDistance, p);
    REQUIRE(std::abs(cystBodyDistance(p)) < 1e-6);
    const Vec3 normal = gradient(cystBodyDistance, p).normalized();
    const double way = random.uniform(-4, 4);
    // The central difference turns the normal by about 1e-7 / 1e-4: 1e-3.
    if (std::abs(cystBodyDistance(p + way * normal) - way) > 0.005)
      FAIL("at " << p.transpose() << " after " << way << " mm");
    ++tried;
  }
  CHECK(tried == 500);
}

TEST_CASE("the sign beyond the exact band of the cyst is right") {
  // Every ray from the middle of the cyst leaves its body once: the sign changes once.
  RandomPoints random(5);
  int changesInAll = 0;
  for (int ray = 0; ray < 300; ++ray) {
    const Vec3 direction = random.inBox(Vec3(1, 1, 1)).normalized();
    bool inside = true;
    int changes = 0;
    for (double t = 0; t < 130; t += 0.25) {
      const bool now = cystBodyDistance(t * direction) < 0;
      changes += now != inside;
      inside = now;
    }
    CHECK(changes == 1);
    CHECK_FALSE(inside);
    changesInAll += changes;
  }
  CHECK(changesInAll == 300);
}

TEST_CASE("simple distances agree with hand-computed ones") {
  CHECK(ballDistance(Vec3(3, 4, 0), 2) == Approx(3));
  CHECK(cylinderDistance(Vec3(3, 9, 4), Vec3::UnitY(), 1) == Approx(4));
  CHECK(capsuleDistance(Vec3(8, 0, 4), 5, 1) == Approx(4));
  CHECK(torusDistance(Vec3(10, 0, 3), Vec3::UnitZ(), 6, 1) == Approx(4));
  CHECK(boxDistance(Vec3(8, 14, 1), Vec3(5, 10, 3), 0) == Approx(5));
  CHECK(boxDistance(Vec3(4, 0, 0), Vec3(5, 10, 3), 1) == Approx(-1));
  CHECK(frameDistance(Vec3(0, 0, 0), 40, 47.5) == Approx(47.5));  // the sphere between the faces
  CHECK(frameDistance(Vec3(40, 0, 0), 40, 47.5) == Approx(std::sqrt(47.5 * 47.5 - 1600)));
  CHECK(frameDistance(Vec3(43, 39, 39), 40, 47.5) == Approx(3));
}
