#include "ui/view/measure_tool.h"

#include "ui/model/measurements.h"

namespace handlebody::ui {

void MeasureTool::setMode(Mode mode) {
  if (mode == mode_ && placed_.empty()) return;
  mode_ = mode;
  placed_.clear();
  pointer_.reset();
  Q_EMIT modeChanged();
  Q_EMIT changed();
}

void MeasureTool::place(const Vec3& point, Measurements& measurements) {
  placed_.push_back(point);
  const Mode mode = mode_;
  const std::size_t wanted = mode == Mode::angle ? 3 : 2;
  if (placed_.size() < wanted) {
    Q_EMIT changed();
    return;
  }
  const std::vector<Vec3> points = placed_;
  setMode(Mode::off);
  if (mode == Mode::centreLine)
    Q_EMIT lineAsked(points[0], points[1]);
  else
    measurements.add({mode == Mode::angle ? MeasurementKind::angle : MeasurementKind::ruler, points});
}

void MeasureTool::setPointer(const std::optional<Vec3>& point) {
  if (point == pointer_) return;
  pointer_ = point;
  Q_EMIT changed();
}

void MeasureTool::stepBack() {
  if (placed_.empty()) return setMode(Mode::off);
  placed_.pop_back();
  Q_EMIT changed();
}

void MeasureTool::setLine(const std::vector<Vec3>& line) {
  line_ = line;
  marker_.reset();
  Q_EMIT changed();
}

void MeasureTool::setMarker(const std::optional<Marker>& marker) {
  if (marker == marker_) return;
  marker_ = marker;
  Q_EMIT changed();
}

void MeasureTool::reset() {
  setMode(Mode::off);
  setLine({});
}

}  // namespace handlebody::ui
