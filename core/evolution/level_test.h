#pragma once
// Whether a voxel lies inside of a boundary level.

#include "core/evolution/level_field.h"

namespace handlebody {

//! Inside is what is below the level there, both times the sign: +1 for a dark object, -1 for a bright one.
class LevelTest {
 public:
  //! The levels must live as long.
  LevelTest(double sign, const LevelField& levels)
      : levels_(levels),
        sign_(sign),
        innermost_(sign > 0 ? levels.lowest() : -levels.highest()),
        outermost_(sign > 0 ? levels.highest() : -levels.lowest()) {}

  //! Below the first every value is inside, whatever its place; from the second on none. Times the sign.
  double innermost() const { return innermost_; }
  double outermost() const { return outermost_; }
  //! At a voxel index.
  bool at(float value, const Vec3& index) const {
    const double x = sign_ * static_cast<double>(value);
    return x < innermost_ || (x < outermost_ && x < sign_ * levels_.at(index));
  }

 private:
  const LevelField& levels_;
  double sign_;
  double innermost_, outermost_;
};

}  // namespace handlebody
