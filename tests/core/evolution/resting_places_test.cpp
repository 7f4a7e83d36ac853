#include "core/evolution/resting_places.h"

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

const Vec3 kPlace(1, 2, 3);

//! Iterations from `from` on during which the place rests, at most `limit`.
int restFrom(const RestingPlaces& places, const Vec3& p, int from, int limit) {
  int n = 0;
  while (n < limit && places.rests(p, from + n)) ++n;
  return n;
}

}  // namespace

TEST_CASE("nothing rests before a place is added") {
  const RestingPlaces places;
  CHECK_FALSE(places.rests(kPlace, 0));
  CHECK_FALSE(places.any(0));
  CHECK_FALSE(places.anyWillWake(0));
  CHECK(places.pace(kPlace) == 1);
}

TEST_CASE("a place rests within its radius, for some iterations, and then moves on") {
  RestingPlaces places;
  places.add(kPlace, 2, 10);
  CHECK(places.rests(kPlace, 10));
  CHECK(places.rests(kPlace + Vec3(1.9, 0, 0), 10));
  CHECK_FALSE(places.rests(kPlace + Vec3(2.1, 0, 0), 10));
  const int rest = restFrom(places, kPlace, 10, 1000);
  CHECK(rest > 0);
  CHECK(rest < 1000);
  CHECK(places.any(10));
  CHECK(places.anyWillWake(10));
  CHECK_FALSE(places.any(10 + rest));
  CHECK_FALSE(places.anyWillWake(10 + rest));
}

TEST_CASE("a place that has rested moves on more slowly, others do not") {
  RestingPlaces places;
  places.add(kPlace, 2, 10);
  CHECK(places.pace(kPlace) < 1);
  CHECK(places.pace(kPlace) > 0);
  CHECK(places.pace(kPlace + Vec3(3, 0, 0)) == 1);
}

TEST_CASE("each time a place comes again it rests longer and moves on more slowly, and at last for good") {
  RestingPlaces places;
  int iteration = 0, last = 0;
  double pace = 1;
  bool forGood = false;
  for (int times = 0; times < 20 && !forGood; ++times) {
    places.add(kPlace, 2, iteration);
    const int rest = restFrom(places, kPlace, iteration, 100'000);
    CHECK(rest > last);
    CHECK(places.pace(kPlace) <= pace);
    last = rest;
    pace = places.pace(kPlace);
    forGood = rest == 100'000;
    iteration += rest;
  }
  CHECK(forGood);
  CHECK(places.any(iteration));
  CHECK_FALSE(places.anyWillWake(iteration));
}

TEST_CASE("a place added again in the same step counts once") {
  RestingPlaces once, thrice;
  once.add(kPlace, 2, 5);
  for (int i = 0; i < 3; ++i) thrice.add(kPlace, 2, 5);
  CHECK(restFrom(once, kPlace, 5, 1000) == restFrom(thrice, kPlace, 5, 1000));
  CHECK(once.pace(kPlace) == thrice.pace(kPlace));
}

TEST_CASE("a place added again in the same step grows, so that a wider part rests") {
  RestingPlaces places;
  places.add(kPlace, 2, 5);
  places.add(kPlace, 2, 5);
  CHECK(places.rests(kPlace + Vec3(2.1, 0, 0), 5));
}

TEST_CASE("places apart from each other rest independently") {
  RestingPlaces places;
  const Vec3 other = kPlace + Vec3(10, 0, 0);
  for (int i = 0; i < 3; ++i) places.add(kPlace, 2, 200 * i);
  places.add(other, 2, 400);
  CHECK(restFrom(places, other, 400, 1000) < restFrom(places, kPlace, 400, 1000));
}

TEST_CASE("a place that changes kMostRepeats times rests for good") {
  RestingPlaces places;
  for (int i = 1; i < kMostRepeats; ++i) {
    CHECK_FALSE(places.repeats(kPlace + Vec3(0.1 * (i % 3), 0, 0), 1));
    CHECK_FALSE(places.rests(kPlace, 1'000'000));
  }
  CHECK(places.repeats(kPlace, 1));
  CHECK(places.rests(kPlace, 1'000'000));
  CHECK_FALSE(places.anyWillWake(1'000'000));
}

TEST_CASE("changes at places apart from each other are no repetition") {
  RestingPlaces places;
  for (int i = 0; i < 5 * kMostRepeats; ++i) CHECK_FALSE(places.repeats(kPlace + Vec3(1.5 * i, 0, 0), 1));
  CHECK_FALSE(places.any(0));
}

TEST_CASE("a place has come back once it has changed kCameBack times") {
  RestingPlaces places;
  for (int i = 0; i < kCameBack; ++i) {
    CHECK_FALSE(places.cameBack(kPlace, 1));
    places.repeats(kPlace, 1);
  }
  CHECK(places.cameBack(kPlace + Vec3(0.9, 0, 0), 1));
  CHECK_FALSE(places.cameBack(kPlace + Vec3(1.1, 0, 0), 1));
}

TEST_CASE("a place that only waits rests longer and longer, but never for good") {
  RestingPlaces waiting, failing;
  int now = 0, last = 0;
  for (int i = 0; i < 12; ++i) {
    waiting.add(kPlace, 2, now, true);
    failing.add(kPlace, 2, now);
    const int rest = restFrom(waiting, kPlace, now, 100000);
    CHECK(rest >= last);
    last = rest;
    now += rest;
  }
  CHECK(last < 1000);
  CHECK_FALSE(waiting.rests(kPlace, now));
  CHECK(failing.rests(kPlace, now));
}
