#include "ui/view/surface_overlay.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/model/document.h"
#include "ui/model/translate.h"
#include "ui/view/overlay.h"

#include <Eigen/Geometry>

namespace handlebody::ui {
namespace {

constexpr double kPinKey = 100;  // pixels from below: over the triad

double firstLine() { return kOverlayMargin + 2.1 * QFontMetricsF(overlayFont()).height(); }
double lineHeight() { return 1.2 * QFontMetricsF(overlayFont()).height(); }

//! Never 0 where there is something, nor all where something is missing.
QString percentOf(double part) {
  if (part > 0 && part < 0.01) return tr("less than 1 %");
  const int percent = static_cast<int>(std::lround(100 * part));
  return tr("%1 %").arg(part < 1 ? std::min(percent, 99) : percent);
}

//! Beside a key. A long text would hide the surface in a small view.
bool fits(const QString& text, const QSizeF& size) {
  constexpr double kRoom = 0.7;  // of the width
  return QFontMetricsF(overlayFont(0.95)).horizontalAdvance(text) < kRoom * size.width();
}

void paintNotCompared(QPainter& painter, const QSizeF& size) {
  const QString whole = tr("not compared with the image");
  paintKey(painter, {kOverlayMargin, firstLine()}, faceSupportColour(FaceSupport::border),
           fits(whole, size) ? whole : tr("not compared"));
}

}  // namespace

void paintTriad(QPainter& painter, const QSizeF& size, const CameraPose& pose) {
  constexpr double kLength = 24, kLetterAt = 34;
  const QPointF origin(50, size.height() - 50);
  const Vec3 right = pose.up.cross(pose.towardsEye);
  struct Arrow {
    Vec3 direction;
    char letter;
    Plane plane;
  };
  std::array<Arrow, 3> arrows{Arrow{Vec3::UnitX(), 'L', Plane::sagittal},
                              Arrow{-Vec3::UnitY(), 'A', Plane::coronal},
                              Arrow{Vec3::UnitZ(), 'S', Plane::axial}};
  // The one that points at the eye is painted last.
  std::sort(arrows.begin(), arrows.end(), [&](const Arrow& a, const Arrow& b) {
    return a.direction.dot(pose.towardsEye) < b.direction.dot(pose.towardsEye);
  });
  for (const Arrow& arrow : arrows) {
    const QPointF step(arrow.direction.dot(right), -arrow.direction.dot(pose.up));
    painter.setPen(QPen(QColor(0, 0, 0, 150), 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin, origin + kLength * step);
    painter.setPen(QPen(planeColour(arrow.plane), 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin, origin + kLength * step);
    paintText(painter, origin + kLetterAt * step, Qt::AlignCenter, QString(QChar::fromLatin1(arrow.letter)),
              overlayFont(1, true));
  }
}

void paintStateLegend(QPainter& painter) {
  const QString names[] = {tr("moving"), tr("settled"), tr("new handle"), tr("colliding")};
  for (int state = 0; state < 4; ++state)
    paintKey(painter, {kOverlayMargin, firstLine() + state * lineHeight()}, faceStateColour(state),
             names[state]);
}

void paintSupportLegend(QPainter& painter, const QSizeF& size, const MeshSnapshot& mesh) {
  const SurfaceSupport& support = mesh.support;
  if (!support.covers(mesh.mesh.triangles.size())) return paintNotCompared(painter, size);
  const QString part = percentOf(support.withoutEdge);
  const QString whole = tr("no edge in the image: %1 of the surface").arg(part);
  const QString texts[] = {tr("edge in the image"), fits(whole, size) ? whole : tr("no edge: %1").arg(part),
                           tr("border of the volume")};
  double y = firstLine();
  for (FaceSupport kind : {FaceSupport::edge, FaceSupport::none, FaceSupport::border}) {
    const bool isThere = std::find(support.faces.begin(), support.faces.end(), kind) != support.faces.end();
    if (kind == FaceSupport::border && !isThere) continue;
    paintKey(painter, {kOverlayMargin, y}, faceSupportColour(kind), texts[static_cast<int>(kind)]);
    y += lineHeight();
  }
}

void paintPinLegend(QPainter& painter, const QSizeF& size) {
  const double line = QFontMetricsF(overlayFont(0.95)).height();
  paintKey(painter, {kOverlayMargin, size.height() - kPinKey - line / 2}, pinColour(), tr("pinned"));
}

void paintStageCaption(QPainter& painter, EventStage stage) {
  const QColor loops(0xff, 0xbf, 0x26), handle = faceStateColour(2), colliding = faceStateColour(3);
  double y = firstLine();
  const auto key = [&](const QColor& colour, const QString& text) {
    paintKey(painter, {kOverlayMargin, y}, colour, text);
    y += lineHeight();
  };
  const bool refined = stage == EventStage::refined;
  if (stage == EventStage::colliding) key(colliding, tr("colliding triangles"));
  if (stage == EventStage::colliding || refined) key(Qt::white, tr("vertices that are taken out"));
  if (stage == EventStage::opened || stage == EventStage::handle || refined)
    key(loops, tr("boundary polygons"));
  if (stage == EventStage::handle) key(handle, tr("handle"));
  if (stage == EventStage::closed) key(QColor(0xb9, 0xc3, 0xd0), tr("closed mesh"));
}

}  // namespace handlebody::ui
