#pragma once
// Places that were rolled back rest for some iterations and then move on slowly; a place that is rolled back
// again and again rests for good.

#include <Eigen/Geometry>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! Changes at one place after which it rests for good. A neck that closes, a crease that fills take a few
//! each.
inline constexpr int kMaxRepeats = 12;
//! Times that a place comes again after which it is stuck.
inline constexpr int kStuck = 3;
//! Changes at one place after which smoothing alone is not expected to help.
inline constexpr int kCameBack = 3;

//! The places that are stuck at one time: for many points.
class StuckPlaces {
 public:
  bool isEmpty() const { return balls_.empty(); }
  void add(const Vec3& centre, double radius);
  bool hold(const Vec3& p) const;

 private:
  struct Ball {
    Vec3 centre;
    double radius;
  };
  std::vector<Ball> balls_;
  Eigen::AlignedBox3d box_;  // around all of them
};

class LockedRegions {
 public:
  //! A place rests from `iteration` on; each time it comes again it rests longer, and at last for good:
  //! unless it only waits.
  void add(const Vec3& centre, double radius, int iteration, bool waits = false);
  //! Counts a change of the mesh at `p`. True when it is the kMaxRepeats-th within `radius`: the place then
  //! rests for good, so that attaching and splitting, or folding and smoothing, cannot go on for ever.
  bool repeats(const Vec3& p, double radius);
  //! True if the mesh has changed kCameBack times or more within `radius` of p.
  bool cameBack(const Vec3& p, double radius) const;
  bool isLocked(const Vec3& p, int iteration) const;
  //! Those that rest, and came again so often that they are not expected to come right by themselves.
  StuckPlaces stuck(int iteration) const;
  bool any(int iteration) const;
  //! True if some place rests now but will move again.
  bool anyWillUnlock(int iteration) const;
  //! Part of its step that a vertex at p may take: places that have rested move on more slowly, so that the
  //! fronts there meet in another way than the one that failed.
  double speedFactor(const Vec3& p) const;

 private:
  struct Region {
    Vec3 centre;
    double radius;  // mm
    int until;      // first iteration at which it moves again
    int times;      // that it came again
    bool holds(const Vec3& p) const { return (p - centre).squaredNorm() < radius * radius; }
  };
  struct Change {
    Vec3 centre;
    int times;
  };
  std::vector<Region> regions_;
  std::vector<Change> changes_;
};

}  // namespace handlebody
