#include "ui/view/slice_measuring.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>

#include "ui/model/document.h"
#include "ui/model/measurements.h"
#include "ui/view/view_state.h"

namespace handlebody::ui {

SliceMeasuring::SliceMeasuring(Document& document, ViewState& state, SliceGeometry& geometry, QWidget& view)
    : QObject(&view),
      document_(document),
      state_(state),
      geometry_(geometry),
      view_(view),
      drag_(document.measurements()) {
  const auto repaint = [this] { view_.update(); };
  connect(&state_.measure(), &MeasureTool::changed, this, repaint);
  connect(&document_.measurements(), &Measurements::changed, this, repaint);
  connect(&document_, &Document::opened, this, [this] { drag_.end(); });
}

//! No other tool has the left button.
bool SliceMeasuring::isFree() const { return !state_.windowLevelTool() && !state_.brush().isOn(); }

bool SliceMeasuring::eventFilter(QObject*, QEvent* event) {
  if (!document_.hasVolume()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick:  // the second click of two in one place: no point of its own
      return isFree() && (state_.measure().isOn() || pressed_);
    case QEvent::MouseMove:
      return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return release(*static_cast<QMouseEvent*>(event));
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      return key(*static_cast<QKeyEvent*>(event));
    case QEvent::Leave:
      state_.measure().setPointer(std::nullopt);
      return false;
    default:
      return false;
  }
}

bool SliceMeasuring::press(const QMouseEvent& event) {
  const bool isPlain = event.button() == Qt::LeftButton && !(event.modifiers() & Qt::ShiftModifier);
  if (!isPlain || !isFree()) return false;
  if (state_.measure().isOn()) {
    pressed_ = true;
    state_.measure().place(placeAt(event.position()), document_.measurements());
    return true;
  }
  const auto grab = grabAt(geometry_, document_, event.position());
  if (grab) drag_.begin(*grab);
  return grab.has_value();
}

bool SliceMeasuring::move(const QMouseEvent& event) {
  if (drag_.isOn()) {
    dragTo(event.position());
    return true;
  }
  if (pressed_) return true;
  if (!isFree()) return false;
  if (state_.measure().isOn()) {
    state_.measure().setPointer(placeAt(event.position()));
    return false;  // place and intensity are told all the same
  }
  if (event.buttons() != Qt::NoButton || !grabAt(geometry_, document_, event.position())) return false;
  view_.setCursor(Qt::SizeAllCursor);
  return true;
}

bool SliceMeasuring::release(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || (!drag_.isOn() && !pressed_)) return false;
  drag_.end();
  pressed_ = false;
  return true;
}

bool SliceMeasuring::key(QKeyEvent& event) {
  MeasureTool& tool = state_.measure();
  const bool isReturn = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
  if (!tool.isOn() || (event.modifiers() & ~Qt::KeypadModifier) ||
      !(isReturn || event.key() == Qt::Key_Escape))
    return false;
  event.accept();  // no shortcut
  if (event.type() == QEvent::ShortcutOverride || event.isAutoRepeat()) return true;
  if (isReturn)
    tool.place(state_.crosshair(), document_.measurements());
  else
    tool.stepBack();
  return true;
}

Vec3 SliceMeasuring::placeAt(const QPointF& pixel) const {
  return geometry_.grid().toWorld(geometry_.clamped(geometry_.toIndex(pixel)));
}

//! Within the slice: how far the point lies from it stays.
void SliceMeasuring::dragTo(const QPointF& pixel) {
  if (const auto held = drag_.held())
    drag_.moveTo(placeAt(pixel) + geometry_.distance(*held) * geometry_.normal());
}

}  // namespace handlebody::ui
