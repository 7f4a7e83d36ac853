#pragma once
// Internal: the end of a measurement that the mouse has hold of, in a slice and in 3D.

#include <optional>

#include "core/measure/measurement.h"
#include "ui/view/measure_overlay.h"

namespace handlebody::ui {

class Measurements;

//! A measurement that is not as this drag has left it is another one, or was undone: it is let go, and
//! nothing moves until the mouse takes hold anew.
class MeasurementDrag {
 public:
  //! `list` outlives it.
  explicit MeasurementDrag(Measurements& list) : list_(list) {}

  //! Selects it. Precondition: there is such a point.
  void begin(const MeasurementGrab& grab);
  //! From begin() to end(), also where what was held is gone.
  bool isOn() const { return grab_.has_value(); }
  //! Where the held point lies, mm LPS; none: there is none any more.
  std::optional<Vec3> held();
  //! One change to undo with all others since begin(). Nothing if there is no such point any more.
  void moveTo(const Vec3& place);
  void end();

 private:
  Measurements& list_;
  std::optional<MeasurementGrab> grab_;
  std::optional<Measurement> left_;  // as this drag has left it; none: it was let go
  int gesture_ = -1;
};

}  // namespace handlebody::ui
