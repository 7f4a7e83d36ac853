#include "ui/view/wall_overlay.h"

#include <QLineF>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/evolution/painted_walls.h"
#include "ui/view/brush.h"
#include "ui/view/other_outlines.h"
#include "ui/view/overlay.h"
#include "ui/view/seed_circles.h"

namespace handlebody::ui {

namespace {

const QColor kPaintRim(0xf4, 0xb8, 0xff);
constexpr double kOpacity = 0.5, kWallRimWidth = 1.6, kDiscWidth = 3;  // pixels

std::vector<WallBall> shownBalls(const WallList& walls, const Brush& brush) {
  if (brush.stroke().empty() || !brush.isForWalls()) return walls.balls;
  if (brush.mode() == Brush::Mode::eraseWalls) return erased({walls.balls, {}, {}, {}}, brush.stroke()).balls;
  std::vector<WallBall> all = walls.balls;
  all.insert(all.end(), brush.stroke().begin(), brush.stroke().end());
  return all;
}

//! True if `list` is `first` and what follows.
bool beginsWith(const std::vector<WallBall>& list, const std::vector<WallBall>& first) {
  return list.size() >= first.size() && std::equal(first.begin(), first.end(), list.begin());
}

//! A disc as an ellipse on the screen.
void paintWholeDisc(QPainter& painter, const SliceGeometry& geometry, const WallDisc& disc) {
  constexpr int kCorners = 64;
  const Vec3 normal = disc.normal.normalized(), a = normal.unitOrthogonal(), b = normal.cross(a);
  QPolygonF rim;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    rim << geometry.worldToScreen(disc.centre + disc.radius * (std::cos(angle) * a + std::sin(angle) * b));
  }
  QColor fill = wallColour();
  fill.setAlphaF(static_cast<float>(kOpacity));
  painter.setPen(QPen(wallColour(), kWallRimWidth));
  painter.setBrush(fill);
  painter.drawPolygon(rim);
}

void paintDisc(QPainter& painter, const SliceGeometry& geometry, const WallDisc& disc) {
  constexpr double kParallel = 0.02;  // sine of the angle between disc and slice
  const Vec3 normal = disc.normal.normalized(), across = normal.cross(geometry.normal());
  const double distance = geometry.distance(disc.centre);
  if (across.norm() < kParallel) {
    const double slice = geometry.grid().spacing[geometry.axes().normal];
    if (std::abs(distance) <= slice / 2) paintWholeDisc(painter, geometry, disc);
    return;
  }
  // The line in which both planes meet, and the disc's diameter across it.
  const Vec3 along = across.normalized(), towards = along.cross(normal);
  const double t = -distance / towards.dot(geometry.normal());
  if (std::abs(t) >= disc.radius) return;
  const Vec3 half = std::sqrt(disc.radius * disc.radius - t * t) * along;
  const Vec3 middle = disc.centre + t * towards;
  paintSegments(painter,
                {QLineF(geometry.worldToScreen(middle - half), geometry.worldToScreen(middle + half))},
                wallColour(), kDiscWidth);
}

}  // namespace

//! A rim lies under what is there, so that only the whole has one.
void WallOverlay::draw(const std::vector<WallBall>& balls, const SliceGeometry& geometry, double pixelRatio) {
  const double least = geometry.grid().spacing[geometry.axes().normal] / 2;  // on one slice at least
  std::vector<Vec3> centres;
  std::vector<double> radii;
  for (const WallBall& ball : balls) {
    centres.push_back(ball.centre);
    radii.push_back(std::max(least, ball.radius));
  }
  const std::vector<SeedCircle> circles = seedCircles(geometry, centres, radii);
  if (circles.empty()) return;
  if (picture_.isNull()) {
    picture_ = QImage((geometry.size() * pixelRatio).toSize(), QImage::Format_ARGB32_Premultiplied);
    picture_.setDevicePixelRatio(pixelRatio);
    picture_.fill(Qt::transparent);
  }
  QPainter painter(&picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(wallColour());
  for (const SeedCircle& c : circles) {
    const double inner = std::max(0.5, c.radius - kWallRimWidth);
    painter.drawEllipse(c.centre, inner, inner);
  }
  painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);
  painter.setBrush(kPaintRim);
  for (const SeedCircle& c : circles) painter.drawEllipse(c.centre, c.radius, c.radius);
}

void WallOverlay::paintMap(QPainter& painter, const SliceGeometry& geometry, const WallMap& map) {
  const SliceAxes& axes = geometry.axes();
  const auto size = [&](int axis) { return geometry.grid().size[axis]; };
  if (map.voxels != map_ || geometry.slice() != mapSlice_) {
    map_ = map.voxels;
    mapSlice_ = geometry.slice();
    mapPicture_ = QImage(size(axes.across), size(axes.down), QImage::Format_ARGB32_Premultiplied);
    mapPicture_.fill(Qt::transparent);
    const QRgb colour = qPremultiply(wallColour().rgba());
    std::array<std::size_t, 3> v{};
    v[axes.normal] = static_cast<std::size_t>(geometry.slice());
    for (int y = 0; y < mapPicture_.height(); ++y) {
      auto* row = reinterpret_cast<QRgb*>(mapPicture_.scanLine(y));
      v[axes.down] = static_cast<std::size_t>(y);
      for (int x = 0; x < mapPicture_.width(); ++x) {
        v[axes.across] = static_cast<std::size_t>(x);
        const auto& n = geometry.grid().size;
        const std::size_t at =
            (v[2] * static_cast<std::size_t>(n[1]) + v[1]) * static_cast<std::size_t>(n[0]) + v[0];
        if ((*map_)[at]) row[x] = colour;
      }
    }
  }
  Vec3 corner = Vec3::Constant(-0.5);
  const QPointF origin = geometry.toScreen(corner);
  const auto step = [&](int axis) {
    Vec3 next = corner;
    next[axis] += 1;
    return geometry.toScreen(next) - origin;
  };
  const QPointF right = step(axes.across), down = step(axes.down);
  painter.save();
  painter.setTransform(QTransform(right.x(), right.y(), down.x(), down.y(), origin.x(), origin.y()), true);
  painter.setOpacity(kOpacity);
  painter.drawImage(QPointF(0, 0), mapPicture_);
  painter.restore();
}

void WallOverlay::paint(QPainter& painter, const SliceGeometry& geometry, double pixelRatio,
                        const WallList& walls, const Brush& brush) {
  const Key key{geometry.size(), geometry.toScreen(Vec3::Zero()), geometry.toScreen(Vec3::Ones()),
                geometry.slice(), pixelRatio};
  const std::vector<WallBall> balls = shownBalls(walls, brush);
  if (!(key == key_) || !beginsWith(balls, drawn_)) {
    picture_ = {};
    drawn_.clear();
  }
  key_ = key;
  draw({balls.begin() + static_cast<std::ptrdiff_t>(drawn_.size()), balls.end()}, geometry, pixelRatio);
  drawn_ = balls;
  if (walls.map && walls.map->voxels) paintMap(painter, geometry, *walls.map);
  if (!picture_.isNull()) {
    painter.setOpacity(kOpacity);
    painter.drawImage(QPointF(0, 0), picture_);
    painter.setOpacity(1);
  }
  for (const WallDisc& disc : walls.discs) paintDisc(painter, geometry, disc);
}

}  // namespace handlebody::ui
