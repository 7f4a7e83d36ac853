#include "ui/view/seed_circles.h"

#include <QLineF>
#include <cmath>

namespace handlebody::ui {
namespace {

constexpr double kReach = 6;         // pixels within which the mouse has hold of something
constexpr double kSmallCircle = 18;  // pixels: below, there is no room for a crosshair inside
const QColor kSeed(0x4f, 0xc3, 0xf7), kSelected(0xff, 0xff, 0xff), kShadow(0, 0, 0, 140);

SeedGrab::Part partAt(const SeedCircle& circle, const QPointF& pixel) {
  const double distance = QLineF(circle.centre, pixel).length();
  if (distance <= std::min(kReach, circle.radius / 2)) return SeedGrab::Part::centre;
  if (std::abs(distance - circle.radius) <= kReach) return SeedGrab::Part::rim;
  const bool inSmall = circle.radius < kSmallCircle && distance < circle.radius;
  return inSmall || distance <= kReach ? SeedGrab::Part::centre : SeedGrab::Part::none;
}

void paintCircle(QPainter& painter, const SeedCircle& circle, bool selected) {
  const QColor colour = selected ? kSelected : kSeed;
  const double width = selected ? 2.4 : 1.6, dot = selected ? 4 : 3;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kShadow, width + 2));
  painter.drawEllipse(circle.centre, circle.radius, circle.radius);
  painter.setPen(QPen(colour, width));
  painter.drawEllipse(circle.centre, circle.radius, circle.radius);
  painter.setPen(QPen(kShadow, 1));
  painter.setBrush(colour);
  painter.drawEllipse(circle.centre, dot, dot);
}

}  // namespace

std::vector<SeedCircle> seedCircles(const SliceGeometry& geometry, const std::vector<Vec3>& centres,
                                    const std::vector<double>& radii) {
  std::vector<SeedCircle> circles;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double distance = geometry.distance(centres[i]);
    const double square = radii[i] * radii[i] - distance * distance;
    if (square <= 0) continue;
    circles.push_back({static_cast<int>(i), geometry.worldToScreen(centres[i]),
                       std::sqrt(square) / geometry.mmPerPixel(), distance});
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
