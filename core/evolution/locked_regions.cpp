#include "core/evolution/locked_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handlebody {

namespace {
constexpr int kFirstLock = 4;        // iterations; doubled each time
constexpr int kMaxTimes = 5;         // then for good
constexpr double kSameRegion = 1.0;  // part of the radius within which a new place is an old one come again
constexpr double kSlower = 0.6;      // each time, down to kSlowest
constexpr double kSlowest = 0.2;
constexpr double kWidening = 1.15;  // of the radius each time
}  // namespace

void StuckPlaces::add(const Vec3& centre, double radius) {
  balls_.push_back({centre, radius});
  box_.extend(centre - Vec3::Constant(radius)).extend(centre + Vec3::Constant(radius));
}

bool StuckPlaces::hold(const Vec3& p) const {
  return box_.contains(p) && std::any_of(balls_.begin(), balls_.end(), [&](const Ball& b) {
           return (p - b.centre).squaredNorm() < b.radius * b.radius;
         });
}

void LockedRegions::add(const Vec3& centre, double radius, int iteration, bool waits) {
  for (Region& p : regions_)
    if ((p.centre - centre).norm() < kSameRegion * std::min(p.radius, radius)) {
      const bool sameStep = p.until > iteration;
      if (!sameStep && !(waits && p.times >= kMaxTimes)) ++p.times;
      p.radius = std::max((sameStep ? kWidening : 1.0) * p.radius, radius);
      p.centre = centre;
      p.until = p.times > kMaxTimes ? std::numeric_limits<int>::max() : iteration + (kFirstLock << p.times);
      return;
    }
  regions_.push_back({centre, radius, iteration + kFirstLock, 0});
}

bool LockedRegions::repeats(const Vec3& p, double radius) {
  for (Change& c : changes_)
    if ((c.centre - p).squaredNorm() < radius * radius) {
      if (++c.times != kMaxRepeats) return false;
      regions_.push_back({c.centre, 2 * radius, std::numeric_limits<int>::max(), kMaxTimes});
      return true;
    }
  changes_.push_back({p, 1});
  return false;
}

bool LockedRegions::cameBack(const Vec3& p, double radius) const {
  return std::any_of(changes_.begin(), changes_.end(), [&](const Change& c) {
    return c.times >= kCameBack && (c.centre - p).squaredNorm() < radius * radius;
  });
}

bool LockedRegions::isLocked(const Vec3& p, int iteration) const {
  return std::any_of(regions_.begin(), regions_.end(),
                     [&](const Region& region) { return iteration < region.until && region.holds(p); });
}

StuckPlaces LockedRegions::stuck(int iteration) const {
  StuckPlaces out;
  for (const Region& r : regions_)
    if (iteration < r.until && r.times >= kStuck) out.add(r.centre, r.radius);
  return out;
}

double LockedRegions::speedFactor(const Vec3& p) const {
  double speedFactor = 1;
  for (const Region& region : regions_)
    if (region.holds(p))
      speedFactor = std::min(speedFactor, std::max(kSlowest, std::pow(kSlower, region.times + 1)));
  return speedFactor;
}

bool LockedRegions::any(int iteration) const {
  return std::any_of(regions_.begin(), regions_.end(), [&](const Region& p) { return iteration < p.until; });
}

bool LockedRegions::anyWillUnlock(int iteration) const {
  return std::any_of(regions_.begin(), regions_.end(), [&](const Region& p) {
    return iteration < p.until && p.until != std::numeric_limits<int>::max();
  });
}

}  // namespace handlebody
