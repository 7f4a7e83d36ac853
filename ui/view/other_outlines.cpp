#include "ui/view/other_outlines.h"

#include <QLineF>
#include <QPen>
#include <QVector>

#include "core/mesh/plane_section.h"
#include "ui/model/document.h"

namespace handlebody::ui {

namespace {
const QColor kOutlineShadow(0, 0, 0, 110);
const QColor kPale(0x9a, 0xa0, 0xa6);
constexpr int kPaleShare = 3;        // parts of four
constexpr double kOtherWidth = 1.4;  // pixels, thinner than the active one's

QColor paled(const QColor& colour) {
  const auto mix = [](int pale, int own) { return (kPaleShare * pale + (4 - kPaleShare) * own) / 4; };
  return {mix(kPale.red(), colour.red()), mix(kPale.green(), colour.green()),
          mix(kPale.blue(), colour.blue())};
}

}  // namespace

QColor colourOf(const Document& document, int object) {
  const Colour c = document.objectInfo(object).label.colour;
  return {c[0], c[1], c[2]};
}

QColor activeColour(const Document& document, const QColor& alone) {
  const int active = document.activeObject();
  const bool isChosen = document.objectInfo(active).label.colour != ObjectLabel{}.colour;
  const QColor own = document.objectCount() > 1 || isChosen ? colourOf(document, active) : alone;
  return document.isShownOutOfDate() ? paled(own) : own;
}

bool isActiveVisible(const Document& document) {
  return document.objectInfo(document.activeObject()).visible;
}

void paintSegments(QPainter& painter, const QVector<QLineF>& lines, const QColor& colour, double width) {
  painter.setPen(QPen(kOutlineShadow, 2 * width, Qt::SolidLine, Qt::FlatCap));
  painter.drawLines(lines);
  painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
  painter.drawLines(lines);
}

double offsetOf(const SliceGeometry& geometry) {
  Vec3 index = Vec3::Zero();
  index[geometry.axes().normal] = geometry.slice();
  return geometry.normal().dot(geometry.grid().toWorld(index));
}

void OtherOutlines::paint(QPainter& painter, const Document& document, const SliceGeometry& geometry) {
  const int count = document.objectCount(), active = document.activeObject();
  cuts_.resize(count);
  for (int i = 0; i < count; ++i) {
    Cut& cut = cuts_[i];
    const ObjectInfo info = document.objectInfo(i);
    if (i == active || !info.visible || !info.snapshot) {
      cut = {};
      continue;
    }
    if (cut.mesh != info.snapshot || cut.slice != geometry.slice()) {
      cut = {info.snapshot, geometry.slice(), {}};
      planeSection(cut.mesh->mesh.points, cut.mesh->mesh.triangles, geometry.normal(), offsetOf(geometry),
                   cut.section);
    }
    QVector<QLineF> lines;
    for (const auto& [from, to] : cut.section)
      lines.append(QLineF(geometry.worldToScreen(from), geometry.worldToScreen(to)));
    paintSegments(painter, lines, colourOf(document, i), kOtherWidth);
  }
}

}  // namespace handlebody::ui
