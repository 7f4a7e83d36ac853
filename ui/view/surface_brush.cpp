#include "ui/view/surface_brush.h"

#include <QLineF>
#include <QPainterPath>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/model/document.h"
#include "ui/view/brush_picture.h"
#include "ui/view/other_outlines.h"
#include "ui/view/other_surfaces.h"
#include "ui/view/overlay.h"

namespace handlebody::ui {

namespace {

Vec3 rightOf(const CameraPose& pose) { return pose.up.cross(pose.towardsEye); }

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

//! A stroke does not go on through the air from one part of the surface to another behind it.
bool isNear(const Vec3& from, const Vec3& to, const Vec3& towardsEye, double radius) {
  constexpr double kSteepest = 2;  // depth per way across
  const Vec3 way = to - from;
  const double depth = std::abs(way.dot(towardsEye));
  return depth <= radius + kSteepest * (way - way.dot(towardsEye) * towardsEye).norm();
}

}  // namespace

QPointF Eye::toScreen(const Vec3& world) const {
  const Vec3 way = (world - pose.focus) / mmPerPixel();
  return {size.width() / 2 + way.dot(rightOf(pose)), size.height() / 2 - way.dot(pose.up)};
}

Vec3 Eye::toWorld(const QPointF& pixel, const Vec3& asFarAs) const {
  const QPointF way = (pixel - QPointF(size.width(), size.height()) / 2) * mmPerPixel();
  const Vec3 across = pose.focus + way.x() * rightOf(pose) - way.y() * pose.up;
  return across + (asFarAs - across).dot(pose.towardsEye) * pose.towardsEye;
}

std::optional<Vec3> pick(const TriangleSoup& surface, const Eye& eye, const QPointF& pixel) {
  const Vec3 right = rightOf(eye.pose), through = eye.toWorld(pixel, eye.pose.focus);
  std::vector<Eigen::Vector2d> seen;  // from the pixel, mm
  seen.reserve(surface.points.size());
  for (const Vec3& p : surface.points)
    seen.emplace_back((p - through).dot(right), (p - through).dot(eye.pose.up));
  std::optional<Vec3> nearest;
  double nearestDepth = 0;
  for (const Triangle& t : surface.triangles) {
    const auto at = [&](int i) { return static_cast<std::size_t>(t[i]); };
    const Eigen::Vector2d &a = seen[at(0)], &b = seen[at(1)], &c = seen[at(2)];
    const double wa = cross(b, c), wb = cross(c, a), wc = cross(a, b), all = wa + wb + wc;
    const bool isUnder = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
    if (!isUnder || all == 0) continue;
    const Vec3 p =
        (wa * surface.points[at(0)] + wb * surface.points[at(1)] + wc * surface.points[at(2)]) / all;
    const double depth = p.dot(eye.pose.towardsEye);
    if (nearest && depth <= nearestDepth) continue;
    nearest = p;
    nearestDepth = depth;
  }
  return nearest;
}

SurfaceBrush::SurfaceBrush(Document& document, ViewState& state)
    : document_(document), state_(state), hand_(document, state.brush()) {}

//! What another object hides cannot be meant.
std::optional<Vec3> SurfaceBrush::placeUnder(const Eye& eye, const QPointF& pixel) const {
  if (!hand_.isReady() || !isActiveVisible(document_)) return std::nullopt;
  const std::optional<Vec3> place = pick(document_.snapshot()->mesh, eye, pixel);
  if (!place) return std::nullopt;
  for (const SurfaceScene::Other& other : otherSurfaces(document_)) {
    const auto before = pick(other.mesh->mesh, eye, pixel);
    if (before && (*before - *place).dot(eye.pose.towardsEye) > 0) return std::nullopt;
  }
  return place;
}

bool SurfaceBrush::press(const Eye& eye, const QPointF& pixel) {
  pointer_ = pixel;
  if (!state_.brush().isFor3d()) return false;
  last_ = placeUnder(eye, pixel);
  if (last_) hand_.press(*last_, *last_);
  return last_.has_value();
}

void SurfaceBrush::move(const Eye& eye, const QPointF& pixel) {
  const QPointF before = pointer_.value_or(pixel);
  pointer_ = pixel;
  if (!hand_.isDown()) return;
  if (const auto& pull = state_.brush().pull()) return hand_.drawTo(eye.toWorld(pixel, pull->from));
  // A mouse that is fast leaves no gap: the surface between is not a straight line.
  constexpr double kMaxParts = 32;
  const double step = std::max(2.0, state_.brush().radius() / eye.mmPerPixel() / 2);
  const double parts = std::clamp(std::ceil(QLineF(before, pixel).length() / step), 1.0, kMaxParts);
  for (double i = 1; i <= parts; ++i) drawTo(eye, before + i / parts * (pixel - before));
}

void SurfaceBrush::drawTo(const Eye& eye, const QPointF& pixel) {
  const std::optional<Vec3> place = placeUnder(eye, pixel);
  if (place)
    hand_.drawTo(*place, last_ && isNear(*last_, *place, eye.pose.towardsEye, state_.brush().radius()));
  last_ = place;
}

void SurfaceBrush::lift() { hand_.lift(); }
void SurfaceBrush::giveUp() { hand_.giveUp(); }

Qt::CursorShape SurfaceBrush::cursor(const Eye& eye) const {
  if (!pointer_ || !state_.brush().isFor3d()) return Qt::ArrowCursor;
  if (!hand_.isReady()) return Qt::ForbiddenCursor;
  const bool pulls = state_.brush().mode() == Brush::Mode::pull;
  if (hand_.isDown()) return pulls ? Qt::ClosedHandCursor : Qt::CrossCursor;
  if (!placeUnder(eye, *pointer_)) return Qt::ArrowCursor;
  return pulls ? Qt::OpenHandCursor : Qt::CrossCursor;
}

void SurfaceBrush::paint(QPainter& painter, const Eye& eye) const {
  const Brush& brush = state_.brush();
  const double radius = brush.radius() / eye.mmPerPixel();
  if (const auto& pull = brush.pull(); pull && brush.isFor3d())
    return paintPull(painter, eye.toScreen(pull->from), eye.toScreen(pull->to), radius);
  if (!brush.isFor3d()) return;
  QPainterPath stroke;
  stroke.setFillRule(Qt::WindingFill);
  for (const WallBall& ball : brush.stroke()) {
    const double seen = ball.radius / eye.mmPerPixel();
    stroke.addEllipse(eye.toScreen(ball.centre), seen, seen);
  }
  constexpr float kStroke = 0.35F;
  QColor fill = brush.mode() == Brush::Mode::unpin ? QColor(Qt::white) : pinColour();
  fill.setAlphaF(kStroke);
  painter.fillPath(stroke, fill);
  if (!pointer_) return;
  const std::optional<Vec3> place = placeUnder(eye, *pointer_);
  if (!place) return;
  paintBrush(painter, eye.toScreen(*place), radius, brush.mode(), true);
  if (brush.mode() == Brush::Mode::pull) paintGrip(painter, eye.toScreen(*place));
}

}  // namespace handlebody::ui
