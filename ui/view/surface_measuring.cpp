#include "ui/view/surface_measuring.h"

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QWidget>
#include <limits>

#include "ui/model/document.h"
#include "ui/model/measurements.h"
#include "ui/view/view_state.h"

namespace handlebody::ui {

namespace {

constexpr double kClick = 4;  // pixels that the mouse may move in one

//! The nearest to the eye of those found so far.
struct Nearest {
  double towardsEye = -std::numeric_limits<double>::infinity();
  std::optional<SurfaceHit> hit{};

  void look(const TriangleSoup& mesh, const Vec3& origin, const Vec3& eye) {
    for (const Triangle& t : mesh.triangles) {
      const Vec3& a = mesh.points[t[0]];
      const Vec3 ab = mesh.points[t[1]] - a;
      const Vec3 ac = mesh.points[t[2]] - a;
      const Vec3 cross = eye.cross(ac);
      const double determinant = ab.dot(cross);
      if (determinant == 0) continue;  // seen from its edge
      const Vec3 offset = origin - a, other = offset.cross(ab);
      const double u = offset.dot(cross) / determinant, v = eye.dot(other) / determinant;
      if (u < 0 || v < 0 || u + v > 1) continue;
      const double along = ac.dot(other) / determinant;
      if (along <= towardsEye) continue;
      towardsEye = along;
      hit = SurfaceHit{a + u * ab + v * ac, ab.cross(ac).normalized()};
    }
  }
};

}  // namespace

std::optional<SurfaceHit> hitAt(const CameraPose& pose, const QSizeF& size, const Document& document,
                                const QPointF& pixel) {
  const double mm = pose.height / size.height();  // per pixel
  const Vec3 right = pose.up.cross(pose.towardsEye);
  const Vec3 origin = pose.focus + mm * (pixel.x() - size.width() / 2) * right -
                      mm * (pixel.y() - size.height() / 2) * pose.up;
  Nearest nearest;
  for (int i = 0; i < document.objectCount(); ++i) {
    const ObjectInfo info = document.objectInfo(i);
    if (info.visible && info.snapshot) nearest.look(info.snapshot->mesh, origin, pose.towardsEye);
  }
  return nearest.hit;
}

SurfaceMeasuring::SurfaceMeasuring(Document& document, ViewState& state,
                                   std::function<std::optional<CameraPose>()> pose, QWidget& view)
    : QObject(&view),
      document_(document),
      state_(state),
      pose_(std::move(pose)),
      view_(view),
      drag_(document.measurements()) {
  view_.setMouseTracking(true);
  const auto repaint = [this] { view_.update(); };
  connect(&state_.measure(), &MeasureTool::changed, this, repaint);
  connect(&document_.measurements(), &Measurements::changed, this, repaint);
  connect(&document_, &Document::opened, this, [this] { drag_.end(); });
}

bool SurfaceMeasuring::eventFilter(QObject*, QEvent* event) {
  if (!document_.hasVolume() || state_.brush().isOn()) return false;  // the brush has the left button
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick:
      return state_.measure().isOn();
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

bool SurfaceMeasuring::press(const QMouseEvent& event) {
  pressed_.reset();
  if (event.button() != Qt::LeftButton || (event.modifiers() & Qt::ShiftModifier)) return false;
  if (state_.measure().isOn()) {
    pressed_ = event.position();
    return false;  // it may become a turn of the camera
  }
  const auto end = grab(event.position());
  if (end) drag_.begin(*end);
  return end.has_value();
}

bool SurfaceMeasuring::move(const QMouseEvent& event) {
  if (drag_.isOn()) {
    if (const auto place = placeAt(event.position())) drag_.moveTo(*place);
    return true;
  }
  if (event.buttons() != Qt::NoButton) return false;
  if (state_.measure().isOn()) {
    view_.setCursor(Qt::CrossCursor);
    if (!state_.measure().placed().empty()) state_.measure().setPointer(placeAt(event.position()));
    isOverEnd_ = true;
  } else if (grab(event.position())) {
    view_.setCursor(Qt::SizeAllCursor);
    isOverEnd_ = true;
  } else if (std::exchange(isOverEnd_, false)) {
    view_.unsetCursor();
  }
  return false;
}

bool SurfaceMeasuring::release(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  if (drag_.isOn()) {
    drag_.end();
    return true;
  }
  const auto pressed = std::exchange(pressed_, std::nullopt);
  if (!pressed || !state_.measure().isOn() || QLineF(*pressed, event.position()).length() > kClick)
    return false;
  if (const auto place = placeAt(*pressed)) state_.measure().place(*place, document_.measurements());
  return false;  // the camera is let go
}

bool SurfaceMeasuring::key(QKeyEvent& event) {
  if (!state_.measure().isOn() || event.key() != Qt::Key_Escape || event.modifiers()) return false;
  event.accept();
  if (event.type() == QEvent::KeyPress) state_.measure().stepBack();
  return true;
}

std::optional<Vec3> SurfaceMeasuring::placeAt(const QPointF& pixel) const {
  const std::optional<CameraPose> pose = pose_();
  const auto hit = pose ? hitAt(*pose, view_.size(), document_, pixel) : std::nullopt;
  if (!hit) return std::nullopt;
  if (state_.measure().mode() != MeasureTool::Mode::centreLine) return hit->place;
  constexpr double kInside = 0.05;  // voxels: a centre line begins inside, and finds the middle by itself
  return hit->place - kInside * document_.volume().grid.meanSpacing() * hit->normal;
}

std::optional<MeasurementGrab> SurfaceMeasuring::grab(const QPointF& pixel) const {
  const std::optional<CameraPose> pose = pose_();
  return pose ? grabAt(*pose, view_.size(), document_, pixel) : std::nullopt;
}

}  // namespace handlebody::ui
