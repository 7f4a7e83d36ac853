#pragma once
// Places that were rolled back rest for some iterations; a place that is rolled back again and again rests
// for good.

#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

class RestingPlaces {
 public:
  //! A place rests from `iteration` on; each time it comes again it rests longer.
  void add(const Vec3& centre, double radius, int iteration);
  bool rests(const Vec3& p, int iteration) const;
  bool any(int iteration) const;
  //! True if some place rests now but will move again.
  bool anyWillWake(int iteration) const;
  //! Makes the newest places larger, for another try of the same step.
  std::size_t size() const { return places_.size(); }

 private:
  struct Place {
    Vec3 centre;
    double radius;  // mm
    int until;      // first iteration at which it moves again
    int times;
  };
  std::vector<Place> places_;
};

}  // namespace handlebody
