// Mouse and keys in the 3D view: the camera's, and the brush's.

#include <vtkGenericRenderWindowInteractor.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/view/surface_view_private.h"

namespace handlebody::ui {

void SurfaceView::Private::tell(const QPointF& pixel, Qt::KeyboardModifiers modifiers, unsigned long event) {
  if (!gl || !document.hasVolume()) return;
  const QPointF device = pixel * view.devicePixelRatioF();
  gl->interactor()->SetEventInformationFlipY(static_cast<int>(device.x()), static_cast<int>(device.y()),
                                             modifiers & Qt::ControlModifier ? 1 : 0,
                                             modifiers & Qt::ShiftModifier ? 1 : 0);
  if (event != vtkCommand::MouseMoveEvent) camera.takeInHand();
  gl->interactor()->InvokeEvent(event);
}

void SurfaceView::Private::followBrush() {
  if (!gl || !document.hasVolume()) return;
  if (state.brush().isFor3d())
    view.setCursor(brush.cursor(eye()));
  else
    view.unsetCursor();
  view.update();
}

//! First the stroke is given up, if there is one.
void SurfaceView::Private::putBrushAway() {
  if (!brush.isDown()) state.brush().setMode(Brush::Mode::off);
  brush.giveUp();
}

void SurfaceView::mousePressEvent(QMouseEvent* event) {
  const auto button = event->button();
  if (d_->dragging || (button != Qt::LeftButton && button != Qt::MiddleButton && button != Qt::RightButton))
    return;
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  const bool isBrushing = d_->gl && d_->document.hasVolume() && !d_->stage.isOn();
  if (isBrushing && button == Qt::LeftButton && !shift && d_->brush.press(d_->eye(), event->position()))
    return d_->followBrush();
  if (d_->brush.isDown()) return;
  d_->dragging = true;
  d_->tell(event->position(), event->modifiers(),
           button == Qt::LeftButton     ? vtkCommand::LeftButtonPressEvent
           : button == Qt::MiddleButton ? vtkCommand::MiddleButtonPressEvent
                                        : vtkCommand::RightButtonPressEvent);
}

void SurfaceView::mouseMoveEvent(QMouseEvent* event) {
  if (d_->dragging) return d_->tell(event->position(), event->modifiers(), vtkCommand::MouseMoveEvent);
  if (!d_->gl || !d_->document.hasVolume() || !d_->state.brush().isFor3d()) return;
  d_->brush.move(d_->eye(), event->position());
  d_->followBrush();
}

void SurfaceView::mouseReleaseEvent(QMouseEvent* event) {
  if (d_->brush.isDown() && event->button() == Qt::LeftButton) {
    d_->brush.lift();
    return d_->followBrush();
  }
  if (!d_->dragging || event->buttons() != Qt::NoButton) return;
  d_->dragging = false;
  // All of them: a drag that began with one button may end with another.
  for (auto release : {vtkCommand::LeftButtonReleaseEvent, vtkCommand::MiddleButtonReleaseEvent,
                       vtkCommand::RightButtonReleaseEvent})
    d_->tell(event->position(), event->modifiers(), release);
}

void SurfaceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (d_->state.brush().isFor3d()) return mousePressEvent(event);  // two quick dabs are two
  if (event->button() == Qt::LeftButton) Q_EMIT maximiseRequested();
}

void SurfaceView::wheelEvent(QWheelEvent* event) {
  if (!hasOpenGl() || !d_->document.hasVolume()) return;
  constexpr double kZoomNotch = 1.2, kNotch = 120;
  event->accept();
  if (d_->state.brush().isFor3d() && (event->modifiers() & Qt::ControlModifier))
    return d_->state.brush().turnWheel(event->angleDelta().y() / kNotch);
  d_->camera.takeInHand();
  d_->camera.zoom(std::pow(kZoomNotch, event->angleDelta().y() / kNotch));
}

void SurfaceView::keyPressEvent(QKeyEvent* event) {
  const bool opposite = event->modifiers() & Qt::ShiftModifier;
  if (event->key() == Qt::Key_Home)
    lookFrom(Plane::axial, opposite);
  else if (event->key() == Qt::Key_End)
    lookFrom(Plane::coronal, opposite);
  else if (event->key() == Qt::Key_PageDown)
    lookFrom(Plane::sagittal, opposite);
  else if (event->key() == Qt::Key_Escape && d_->state.brush().isFor3d())
    d_->putBrushAway();
  else
    QWidget::keyPressEvent(event);
}

void SurfaceView::leaveEvent(QEvent*) {
  d_->brush.leave();
  if (d_->state.brush().isFor3d()) update();
}

void SurfaceView::focusInEvent(QFocusEvent*) { update(); }
void SurfaceView::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace handlebody::ui
