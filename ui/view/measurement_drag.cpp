#include "ui/view/measurement_drag.h"

#include "ui/model/measurements.h"
#include "ui/view/view_state.h"

namespace handlebody::ui {

void MeasurementDrag::begin(const MeasurementGrab& grab) {
  grab_ = grab;
  left_ = list_.all().at(static_cast<std::size_t>(grab.measurement));
  gesture_ = ViewState::nextGesture();
  list_.select(grab.measurement);
}

std::optional<Vec3> MeasurementDrag::held() {
  if (!grab_ || !left_) return std::nullopt;
  const auto& all = list_.all();
  const auto at = static_cast<std::size_t>(grab_->measurement);
  if (at >= all.size() || all[at] != *left_) left_.reset();  // undone meanwhile, or another list
  return left_ ? std::optional(left_->points.at(static_cast<std::size_t>(grab_->point))) : std::nullopt;
}

void MeasurementDrag::moveTo(const Vec3& place) {
  if (!held()) return;
  list_.movePoint(grab_->measurement, grab_->point, place, gesture_);
  left_ = list_.all().at(static_cast<std::size_t>(grab_->measurement));
}

void MeasurementDrag::end() {
  grab_.reset();
  left_.reset();
}

}  // namespace handlebody::ui
