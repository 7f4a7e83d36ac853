#include "ui/view/seed_circles.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

namespace handlebody::ui {
namespace {

constexpr double kSeedReach = 6;     // pixels within which the mouse has hold of something
constexpr double kSmallCircle = 18;  // pixels: below, there is no room for a crosshair inside
const QColor kSeed(0x4f, 0xc3, 0xf7), kOutsideSeed(0xff, 0x7a, 0x1a), kSelectedSeed(0xff, 0xff, 0xff),
    kSeedShadow(0, 0, 0, 140);

SeedGrab::Part partAt(const SeedCircle& circle, const QPointF& pixel) {
  const double distance = QLineF(circle.centre, pixel).length();
  if (circle.radius == 0) return distance <= kSeedReach ? SeedGrab::Part::centre : SeedGrab::Part::none;
  if (distance <= std::min(kSeedReach, circle.radius / 2)) return SeedGrab::Part::centre;
  if (std::abs(distance - circle.radius) <= kSeedReach) return SeedGrab::Part::rim;
  const bool inSmall = circle.radius < kSmallCircle && distance < circle.radius;
  return inSmall || distance <= kSeedReach ? SeedGrab::Part::centre : SeedGrab::Part::none;
}

void paintRing(QPainter& painter, const SeedCircle& circle, const QPen& pen) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawEllipse(circle.centre, circle.radius, circle.radius);
}

void paintDot(QPainter& painter, const SeedCircle& circle, const QColor& colour, double radius) {
  painter.setPen(QPen(kSeedShadow, 1));
  painter.setBrush(colour);
  painter.drawEllipse(circle.centre, radius, radius);
}

//! From rim to rim.
void paintCross(QPainter& painter, const SeedCircle& circle, const QPen& pen) {
  const double half = circle.radius * std::sqrt(0.5);
  painter.setPen(pen);
  painter.drawLine(circle.centre - QPointF(half, half), circle.centre + QPointF(half, half));
  painter.drawLine(circle.centre - QPointF(half, -half), circle.centre + QPointF(half, -half));
}

//! Of a size that says nothing.
void paintMissed(QPainter& painter, SeedCircle circle, const QColor& colour, bool selected) {
  if (!circle.outside) return paintDot(painter, circle, colour, selected ? 4 : 3);
  circle.radius = selected ? 7 : 5;
  paintCross(painter, circle, QPen(kSeedShadow, 4));
  paintCross(painter, circle, QPen(colour, 2));
}

// The cross keeps its colour when it is selected: white alone would be a seed at first sight.
void paintCircle(QPainter& painter, const SeedCircle& circle, bool selected) {
  const QColor own = circle.outside ? kOutsideSeed : kSeed, colour = selected ? kSelectedSeed : own;
  if (circle.radius == 0) return paintMissed(painter, circle, colour, selected);
  const double width = selected ? 2.4 : 1.6;
  paintRing(painter, circle, QPen(kSeedShadow, width + 2));
  if (circle.outside) {
    paintCross(painter, circle, QPen(kSeedShadow, width + 2));
    paintCross(painter, circle, QPen(own, width));
  }
  paintRing(painter, circle, QPen(colour, width));
  if (!circle.outside) paintDot(painter, circle, colour, selected ? 4 : 3);
}

}  // namespace

QColor outsideColour() { return kOutsideSeed; }

std::vector<SeedCircle> seedCircles(const SliceGeometry& geometry, const std::vector<Vec3>& centres,
                                    const std::vector<double>& radii, double reach) {
  std::vector<SeedCircle> circles;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double distance = geometry.distance(centres[i]);
    const double square = radii[i] * radii[i] - distance * distance;
    if (square <= 0 && std::abs(distance) > reach) continue;
    circles.push_back({static_cast<int>(i), geometry.worldToScreen(centres[i]),
                       std::sqrt(std::max(0.0, square)) / geometry.mmPerPixel(), distance});
  }
  return circles;
}

SeedGrab seedAt(const std::vector<SeedCircle>& circles, const QPointF& pixel, int selected) {
  SeedGrab grab;
  for (const SeedCircle& circle : circles) {
    const SeedGrab::Part part = partAt(circle, pixel);
    if (part == SeedGrab::Part::none || (grab.seed == selected && grab.seed >= 0)) continue;
    grab = {part, circle.seed};
  }
  return grab;
}

double draggedRadius(const SliceGeometry& geometry, const Vec3& centre, const QPointF& pixel) {
  const double inSlice = QLineF(geometry.worldToScreen(centre), pixel).length() * geometry.mmPerPixel();
  return std::hypot(inSlice, geometry.distance(centre));
}

void paintSeeds(QPainter& painter, const std::vector<SeedCircle>& circles, int selected) {
  for (const SeedCircle& circle : circles)
    if (circle.seed != selected) paintCircle(painter, circle, false);
  for (const SeedCircle& circle : circles)
    if (circle.seed == selected) paintCircle(painter, circle, true);
}

}  // namespace handlebody::ui
