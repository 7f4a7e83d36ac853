#include "ui/view/measure_overlay.h"

#include <Eigen/Geometry>
#include <QLineF>
#include <QVector>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "ui/model/document.h"
#include "ui/model/measurements.h"
#include "ui/view/length_decimals.h"
#include "ui/view/measure_tool.h"
#include "ui/view/other_outlines.h"
#include "ui/view/overlay.h"

namespace handlebody::ui {

namespace {

const QColor kRim(0, 0, 0, 170), kPlain(0x4d, 0xd0, 0xe1), kSelected(0xff, 0xee, 0x58),
    kLine(0xff, 0x7a, 0xb8);
constexpr double kWidth = 1.6, kRimWidth = 3.4, kHandle = 4, kReach = 9;  // pixels

//! How a view shows the world.
struct Projection {
  std::function<QPointF(const Vec3&)> toScreen;
  //! Signed distance from what is shown, mm; nothing shown is farther than `reach`.
  std::function<double(const Vec3&)> depth;
  double reach = std::numeric_limits<double>::infinity();

  bool shows(const Vec3& p) const { return std::abs(depth(p)) <= reach; }
  //! The part of a segment that is shown.
  std::optional<std::array<Vec3, 2>> clipped(Vec3 a, Vec3 b) const {
    if (!std::isfinite(reach)) return std::array<Vec3, 2>{a, b};
    double da = depth(a), db = depth(b);
    for (const double side : {1.0, -1.0}) {
      const double ea = side * da - reach, eb = side * db - reach;  // above 0: out
      if (ea > 0 && eb > 0) return std::nullopt;
      if (ea <= 0 && eb <= 0) continue;
      const Vec3 cut = a + ea / (ea - eb) * (b - a);
      (ea > 0 ? a : b) = cut;
      (ea > 0 ? da : db) = side * reach;
    }
    return std::array<Vec3, 2>{a, b};
  }
};

Projection projectionOf(const SliceGeometry& geometry) {
  // A little more than half a slice: what lies midway between two is shown on one of them at least.
  constexpr double kAlmost = 1 + 1e-9;
  return {[&geometry](const Vec3& p) { return geometry.worldToScreen(p); },
          [&geometry](const Vec3& p) { return geometry.distance(p); },
          kAlmost * geometry.grid().spacing[geometry.axes().normal] / 2};
}

Projection projectionOf(const CameraPose& pose, const QSizeF& size) {
  return {[pose, size](const Vec3& p) { return toScreen(pose, size, p); }, [](const Vec3&) { return 0.0; }};
}

//! From centre + u over `angle` (radians) towards centre + v.
std::vector<Vec3> arcPoints(const Vec3& centre, const Vec3& u, const Vec3& v, double angle) {
  constexpr int kParts = 48;
  std::vector<Vec3> points;
  for (int i = 0; i <= kParts; ++i)
    points.push_back(centre + std::cos(angle * i / kParts) * u + std::sin(angle * i / kParts) * v);
  return points;
}

class Painter {
 public:
  Painter(QPainter& painter, Projection projection) : painter_(painter), to_(std::move(projection)) {}

  void paint(const Document& document, const MeasureTool& tool) {
    painter_.setRenderHint(QPainter::Antialiasing);
    decimals_ = lengthDecimals(document.volume().grid);
    paintLine(tool);
    const Measurements& list = document.measurements();
    for (int i = 0; i < static_cast<int>(list.all().size()); ++i)
      paintMeasurement(list.all()[i], i == list.selected());
    paintPending(tool);
  }

 private:
  void stroke(const std::vector<Vec3>& points, const QColor& colour) {
    QVector<QLineF> lines;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (const auto part = to_.clipped(points[i - 1], points[i]))
        lines.append(QLineF(to_.toScreen((*part)[0]), to_.toScreen((*part)[1])));
    paintSegments(painter_, lines, colour, kWidth);
  }

  void handle(const Vec3& p, const QColor& colour) {
    if (!to_.shows(p)) return;
    painter_.setPen(QPen(kRim, kRimWidth));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawEllipse(to_.toScreen(p), kHandle, kHandle);
    painter_.setPen(QPen(colour, kWidth));
    painter_.drawEllipse(to_.toScreen(p), kHandle, kHandle);
  }

  //! Beside the middle of what is seen, if that is most of it: where a slice only crosses a ruler no length
  //! is to be read.
  void label(const Vec3& a, const Vec3& b, const QString& text, const QColor& colour) {
    const auto part = to_.clipped(a, b);
    if (!part || 2 * ((*part)[1] - (*part)[0]).norm() < (b - a).norm()) return;
    const QPointF from = to_.toScreen((*part)[0]), to = to_.toScreen((*part)[1]);
    // To the right of a steep line, above one that lies.
    const bool isSteep = std::abs(to.y() - from.y()) > std::abs(to.x() - from.x());
    const QPointF aside = isSteep ? QPointF(8, 0) : QPointF(0, -6);
    paintText(painter_, (from + to) / 2 + aside,
              isSteep ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignHCenter | Qt::AlignBottom, text,
              overlayFont(1, true), colour);
  }

  void paintMeasurement(const Measurement& m, bool isSelected) {
    const QColor colour = isSelected ? kSelected : kPlain;
    stroke(m.points, colour);
    if (m.kind == MeasurementKind::angle) arc(m, colour);
    for (const Vec3& p : m.points) handle(p, colour);
    if (m.kind == MeasurementKind::ruler)
      label(m.points[0], m.points[1], measuredValue(m, decimals_), colour);
    else if (to_.shows(m.points[1]))
      paintText(painter_, to_.toScreen(m.points[1]) + QPointF(10, 12), Qt::AlignLeft | Qt::AlignTop,
                measuredValue(m), overlayFont(1, true), colour);
  }

  //! Between the legs, a third of the shorter one away from the vertex.
  void arc(const Measurement& m, const QColor& colour) {
    const Vec3 a = m.points[0] - m.points[1], b = m.points[2] - m.points[1];
    const double radius = std::min(a.norm(), b.norm()) / 3;
    if (!(radius > 0)) return;
    const Vec3 u = a.normalized();
    Vec3 v = b - b.dot(u) * u;
    if (!(v.norm() > 1e-9 * b.norm())) return;
    v.normalize();
    const double angle = std::atan2(b.dot(v), b.dot(u));
    stroke(arcPoints(m.points[1], radius * u, radius * v, angle), colour);
  }

  void paintPending(const MeasureTool& tool) {
    std::vector<Vec3> points = tool.placed();
    if (tool.pointer() && !points.empty()) points.push_back(*tool.pointer());
    stroke(points, kSelected);
    for (const Vec3& p : tool.placed()) handle(p, kSelected);
    if (points.size() == 2 && tool.mode() == MeasureTool::Mode::ruler)
      label(points[0], points[1], measuredValue({MeasurementKind::ruler, points}, decimals_), kSelected);
  }

  void paintLine(const MeasureTool& tool) {
    stroke(tool.line(), kLine);
    if (!tool.marker()) return;
    const MeasureTool::Marker& m = *tool.marker();
    const Vec3 u = m.direction.unitOrthogonal(), v = m.direction.cross(u);
    stroke(arcPoints(m.place, m.radius * u, m.radius * v, 2 * std::numbers::pi), kSelected);
    // Its middle also where the slice does not pass: where else would one look?
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(kRim);
    painter_.drawEllipse(to_.toScreen(m.place), kHandle + 1, kHandle + 1);
    painter_.setBrush(kSelected);
    painter_.drawEllipse(to_.toScreen(m.place), kHandle - 0.5, kHandle - 0.5);
    painter_.setBrush(Qt::NoBrush);
  }

  QPainter& painter_;
  Projection to_;
  int decimals_ = 2;  // of lengths
};

std::optional<MeasurementGrab> nearest(const Projection& to, const Document& document, const QPointF& pixel) {
  const Measurements& list = document.measurements();
  std::optional<MeasurementGrab> found;
  double least = kReach;
  for (int i = 0; i < static_cast<int>(list.all().size()); ++i) {
    const auto& points = list.all()[i].points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!to.shows(points[p])) continue;
      double distance = QLineF(to.toScreen(points[p]), pixel).length();
      if (distance > kReach) continue;
      if (i == list.selected()) distance /= 2;  // of several in one place
      if (distance > least) continue;
      least = distance;
      found = MeasurementGrab{i, static_cast<int>(p)};
    }
  }
  return found;
}

}  // namespace

QPointF toScreen(const CameraPose& pose, const QSizeF& size, const Vec3& world) {
  const double pixels = size.height() / pose.height;  // per mm
  const Vec3 offset = world - pose.focus, right = pose.up.cross(pose.towardsEye);
  return {size.width() / 2 + pixels * offset.dot(right), size.height() / 2 - pixels * offset.dot(pose.up)};
}

void paintMeasurements(QPainter& painter, const SliceGeometry& geometry, const Document& document,
                       const MeasureTool& tool) {
  Painter(painter, projectionOf(geometry)).paint(document, tool);
}

void paintMeasurements(QPainter& painter, const QSizeF& size, const CameraPose& pose,
                       const Document& document, const MeasureTool& tool) {
  Painter(painter, projectionOf(pose, size)).paint(document, tool);
}

std::optional<MeasurementGrab> grabAt(const SliceGeometry& geometry, const Document& document,
                                      const QPointF& pixel) {
  return nearest(projectionOf(geometry), document, pixel);
}

std::optional<MeasurementGrab> grabAt(const CameraPose& pose, const QSizeF& size, const Document& document,
                                      const QPointF& pixel) {
  return nearest(projectionOf(pose, size), document, pixel);
}

}  // namespace handlebody::ui
