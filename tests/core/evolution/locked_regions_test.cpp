#include "core/evolution/locked_regions.h"

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

const Vec3 kPlace(1, 2, 3);

//! Iterations from `from` on during which the place rests, at most `limit`.
int lockedFrom(const LockedRegions& regions, const Vec3& p, int from, int limit) {
  int n = 0;
  while (n < limit && regions.isLocked(p, from + n)) ++n;
  return n;
}

}  // namespace

TEST_CASE("nothing rests before a place is added") {
  const LockedRegions regions;
  CHECK_FALSE(regions.isLocked(kPlace, 0));
  CHECK_FALSE(regions.any(0));
  CHECK_FALSE(regions.anyWillUnlock(0));
  CHECK(regions.speedFactor(kPlace) == 1);
}

TEST_CASE("a place rests within its radius, for some iterations, and then moves on") {
  LockedRegions regions;
  regions.add(kPlace, 2, 10);
  CHECK(regions.isLocked(kPlace, 10));
  CHECK(regions.isLocked(kPlace + Vec3(1.9, 0, 0), 10));
  CHECK_FALSE(regions.isLocked(kPlace + Vec3(2.1, 0, 0), 10));
  const int rest = lockedFrom(regions, kPlace, 10, 1000);
  CHECK(rest > 0);
  CHECK(rest < 1000);
  CHECK(regions.any(10));
  CHECK(regions.anyWillUnlock(10));
  CHECK_FALSE(regions.any(10 + rest));
  CHECK_FALSE(regions.anyWillUnlock(10 + rest));
}

TEST_CASE("a place that has rested moves on more slowly, others do not") {
  LockedRegions regions;
  regions.add(kPlace, 2, 10);
  CHECK(regions.speedFactor(kPlace) < 1);
  CHECK(regions.speedFactor(kPlace) > 0);
  CHECK(regions.speedFactor(kPlace + Vec3(3, 0, 0)) == 1);
}

TEST_CASE("each time a place comes again it rests longer and moves on more slowly, and at last for good") {
  LockedRegions regions;
  int iteration = 0, last = 0;
  double speedFactor = 1;
  bool forGood = false;
  for (int times = 0; times < 20 && !forGood; ++times) {
    regions.add(kPlace, 2, iteration);
    const int rest = lockedFrom(regions, kPlace, iteration, 100'000);
    CHECK(rest > last);
    CHECK(regions.speedFactor(kPlace) <= speedFactor);
    last = rest;
    speedFactor = regions.speedFactor(kPlace);
    forGood = rest == 100'000;
    iteration += rest;
  }
  CHECK(forGood);
  CHECK(regions.any(iteration));
  CHECK_FALSE(regions.anyWillUnlock(iteration));
}

TEST_CASE("a place added again in the same step counts once") {
  LockedRegions once, thrice;
  once.add(kPlace, 2, 5);
  for (int i = 0; i < 3; ++i) thrice.add(kPlace, 2, 5);
  CHECK(lockedFrom(once, kPlace, 5, 1000) == lockedFrom(thrice, kPlace, 5, 1000));
  CHECK(once.speedFactor(kPlace) == thrice.speedFactor(kPlace));
}

TEST_CASE("a place added again in the same step grows, so that a wider part rests") {
  LockedRegions regions;
  regions.add(kPlace, 2, 5);
  regions.add(kPlace, 2, 5);
  CHECK(regions.isLocked(kPlace + Vec3(2.1, 0, 0), 5));
}

TEST_CASE("places apart from each other rest independently") {
  LockedRegions regions;
  const Vec3 other = kPlace + Vec3(10, 0, 0);
  for (int i = 0; i < 3; ++i) regions.add(kPlace, 2, 200 * i);
  regions.add(other, 2, 400);
  CHECK(lockedFrom(regions, other, 400, 1000) < lockedFrom(regions, kPlace, 400, 1000));
}

TEST_CASE("a place that changes kMaxRepeats times rests for good") {
  LockedRegions regions;
  for (int i = 1; i < kMaxRepeats; ++i) {
    CHECK_FALSE(regions.repeats(kPlace + Vec3(0.1 * (i % 3), 0, 0), 1));
    CHECK_FALSE(regions.isLocked(kPlace, 1'000'000));
  }
  CHECK(regions.repeats(kPlace, 1));
  CHECK(regions.isLocked(kPlace, 1'000'000));
  CHECK_FALSE(regions.anyWillUnlock(1'000'000));
}

TEST_CASE("changes at places apart from each other are no repetition") {
  LockedRegions regions;
  for (int i = 0; i < 5 * kMaxRepeats; ++i) CHECK_FALSE(regions.repeats(kPlace + Vec3(1.5 * i, 0, 0), 1));
  CHECK_FALSE(regions.any(0));
}

TEST_CASE("a place has come back once it has changed kCameBack times") {
  LockedRegions regions;
  for (int i = 0; i < kCameBack; ++i) {
    CHECK_FALSE(regions.cameBack(kPlace, 1));
    regions.repeats(kPlace, 1);
  }
  CHECK(regions.cameBack(kPlace + Vec3(0.9, 0, 0), 1));
  CHECK_FALSE(regions.cameBack(kPlace + Vec3(1.1, 0, 0), 1));
}

TEST_CASE("a place that only waits rests longer and longer, but never for good") {
  LockedRegions waiting, failing;
  int now = 0, last = 0;
  for (int i = 0; i < 12; ++i) {
    waiting.add(kPlace, 2, now, true);
    failing.add(kPlace, 2, now);
    const int rest = lockedFrom(waiting, kPlace, now, 100000);
    CHECK(rest >= last);
    last = rest;
    now += rest;
  }
  CHECK(last < 1000);
  CHECK_FALSE(waiting.isLocked(kPlace, now));
  CHECK(failing.isLocked(kPlace, now));
}
