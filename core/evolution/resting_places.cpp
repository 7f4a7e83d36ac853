#include "core/evolution/resting_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handlebody {

namespace {
constexpr int kFirstRest = 4;       // iterations; doubled each time
constexpr int kMostTimes = 5;       // then for good
constexpr double kSamePlace = 1.0;  // part of the radius within which a new place is an old one come again
constexpr double kSlower = 0.6;     // each time, down to kSlowest
constexpr double kSlowest = 0.2;
constexpr double kGrowth = 1.15;  // of the radius each time
}  // namespace

void RestingPlaces::add(const Vec3& centre, double radius, int iteration, bool waits) {
  for (Place& p : places_)
    if ((p.centre - centre).norm() < kSamePlace * std::min(p.radius, radius)) {
      const bool sameStep = p.until > iteration;
      if (!sameStep && !(waits && p.times >= kMostTimes)) ++p.times;
      p.radius = std::max((sameStep ? kGrowth : 1.0) * p.radius, radius);
      p.centre = centre;
      p.until = p.times > kMostTimes ? std::numeric_limits<int>::max() : iteration + (kFirstRest << p.times);
      return;
    }
  places_.push_back({centre, radius, iteration + kFirstRest, 0});
}

bool RestingPlaces::repeats(const Vec3& p, double radius) {
  for (Change& c : changes_)
    if ((c.centre - p).squaredNorm() < radius * radius) {
      if (++c.times != kMostRepeats) return false;
      places_.push_back({c.centre, 2 * radius, std::numeric_limits<int>::max(), kMostTimes});
      return true;
    }
  changes_.push_back({p, 1});
  return false;
}

bool RestingPlaces::cameBack(const Vec3& p, double radius) const {
  return std::any_of(changes_.begin(), changes_.end(), [&](const Change& c) {
    return c.times >= kCameBack && (c.centre - p).squaredNorm() < radius * radius;
  });
}

bool RestingPlaces::rests(const Vec3& p, int iteration) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return iteration < place.until && (p - place.centre).squaredNorm() < place.radius * place.radius;
  });
}

double RestingPlaces::pace(const Vec3& p) const {
  double pace = 1;
  for (const Place& place : places_)
    if ((p - place.centre).squaredNorm() < place.radius * place.radius)
      pace = std::min(pace, std::max(kSlowest, std::pow(kSlower, place.times + 1)));
  return pace;
}

bool RestingPlaces::any(int iteration) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& p) { return iteration < p.until; });
}

bool RestingPlaces::anyWillWake(int iteration) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& p) {
    return iteration < p.until && p.until != std::numeric_limits<int>::max();
  });
}

}  // namespace handlebody
