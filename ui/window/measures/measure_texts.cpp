#include "ui/window/measures/measure_texts.h"

#include <QLocale>
#include <algorithm>
#include <numeric>

#include "ui/model/finding_text.h"
#include "ui/model/measuring.h"
#include "ui/model/translate.h"
#include "ui/view/length_decimals.h"
#include "ui/window/widgets/numbers.h"

namespace handlebody::ui {

namespace {

QString nameOf(const std::string& name) { return QString::fromStdString(name); }

const IntensityInside* intensityOf(const MeasuredObject& o) {
  const auto& in = o.measures.intensity;
  return in && in->voxels > 0 ? &*in : nullptr;
}

const std::string* otherOf(const MeasuredGap& gap, const MeasuredObject& o) {
  return gap.from == o.name ? &gap.to : gap.to == o.name ? &gap.from : nullptr;
}

QString gapText(const MeasuredGap& gap) {
  if (gap.gap.contact == BodyContact::surfaces) return tr("they meet");
  const QString text = millimetres(gap.gap.distance);
  return gap.gap.contact == BodyContact::inside ? tr("%1, one within the other").arg(text) : text;
}

//! An object may be called "1.5".
bool holdsNames(const QString& header) {
  return header.endsWith(QStringLiteral("object")) || header == QStringLiteral("wall_first") ||
         header == QStringLiteral("wall_second");
}

bool isPlainNumber(const QString& cell) {
  bool is = false;
  QLocale::c().toDouble(cell, &is);
  return is;
}

//! What files call them in English where the surface is a wall in itself.
QString wallSurface(const MeasuredWall& wall, bool isFirst) {
  if (wall.first == kOuterSurface && wall.second == kCavities)
    return isFirst ? tr("the outer surface") : tr("the cavities");
  return nameOf(isFirst ? wall.first : wall.second);
}

QString wallText(const QString& name, const DirectedDistances& d) {
  return tr("  from %1: mean %2, least %3, 95 % up to %4, largest %5")
      .arg(name, millimetres(d.mean), millimetres(d.smallest), millimetres(d.percentile95),
           millimetres(d.largest));
}

}  // namespace

QStringList measureHeaders() {
  return {tr("Object"),          tr("Volume\n(ml)"),         tr("Area\n(cm²)"),
          tr("Largest\nØ (mm)"), tr("Intensity\nmean ± SD"), tr("Nearest object\n(mm)")};
}

QStringList measureCells(const Measured& m, const MeasuredObject& o) {
  const ShapeMeasures& s = o.measures.shape;
  const IntensityInside* in = intensityOf(o);
  const MeasuredGap* nearest = nullptr;
  for (const MeasuredGap& gap : m.gaps)
    if (otherOf(gap, o) && (!nearest || gap.gap.distance < nearest->gap.distance)) nearest = &gap;
  const QString none = QStringLiteral("–");
  return {
      nameOf(o.name),
      fineNumber(s.volume / 1000),
      fineNumber(s.area / 100),
      fineNumber(s.largest.distance),
      in ? tr("%1 ± %2").arg(fineNumber(in->mean), fineNumber(in->deviation, 3)) : none,
      nearest ? tr("%1: %2").arg(nameOf(*otherOf(*nearest, o)), fineNumber(nearest->gap.distance, 3)) : none};
}

QString measureDetails(const Measured& m, const MeasuredObject& o, const Grid& grid) {
  const ShapeMeasures& s = o.measures.shape;
  const int decimals = placeDecimals(grid);
  QStringList lines;
  lines << tr("Along its axes: %1 mm").arg(times(s.extents, decimals))
        << tr("Along x, y, z: %1 mm").arg(times(s.box, decimals))
        << tr("Largest Ø from %1 to %2").arg(place(s.largest.from, grid), place(s.largest.to, grid))
        << tr("Centroid: %1 LPS").arg(place(s.centroid, grid));
  if (const IntensityInside* in = intensityOf(o))
    lines << tr("Intensity %1 to %2, %3 voxels")
                 .arg(fineNumber(in->minimum), fineNumber(in->maximum),
                      QLocale().toString(static_cast<qulonglong>(in->voxels)));
  const Certificate& c = o.certificate;
  lines << tr("Components %1, cavities %2, tunnels %3")
               .arg(QString::number(c.components - c.cavities), QString::number(c.cavities),
                    QString::number(std::accumulate(c.genus.begin(), c.genus.end(), 0)));
  for (const MeasuredGap& gap : m.gaps)
    if (const std::string* other = otherOf(gap, o))
      lines << tr("Distance to “%1”: %2").arg(nameOf(*other), gapText(gap));
  if (m.wall)
    lines << tr("Wall thickness") << wallText(wallSurface(*m.wall, true), m.wall->wall.fromFirst)
          << wallText(wallSurface(*m.wall, false), m.wall->wall.fromSecond);
  return lines.join(QLatin1Char('\n'));
}

QString columnsForSpreadsheet(const QString& columns) {
  QStringList lines = columns.split(QLatin1Char('\n'));
  const QStringList headers = lines.front().split(QLatin1Char('\t'));
  for (QString& line : lines) {
    QStringList cells = line.split(QLatin1Char('\t'));
    for (qsizetype i = 0; i < std::min(cells.size(), headers.size()); ++i)
      if (!holdsNames(headers[i]) && isPlainNumber(cells[i]))
        cells[i].replace(QLatin1Char('.'), QLocale().decimalPoint());
    line = cells.join(QLatin1Char('\t'));
  }
  return lines.join(QLatin1Char('\n'));
}

QString lineSummary(const MeasuredLine& m) {
  const CentreLinePoint *least = nullptr, *largest = nullptr;
  for (const CentreLinePoint& p : m.line.points) {
    if (!p.area) continue;
    if (!least || *p.area < *least->area) least = &p;
    if (!largest || *p.area > *largest->area) largest = &p;
  }
  QStringList lines{tr("Length %1, in “%2”").arg(millimetres(m.line.length), nameOf(m.object))};
  if (least)
    lines << tr("Least section: %1").arg(sectionText(*least)) << tr("Largest: %1").arg(sectionText(*largest));
  return lines.join(QLatin1Char('\n'));
}

QString failureText(const PerturbedRun& run) {
  return run.why.any() && isTranslated(run.why) ? findingText(run.why) : QString::fromStdString(run.failure);
}

QString sectionText(const CentreLinePoint& p) {
  if (!p.area) return tr("at %1: no section").arg(millimetres(p.along));
  return tr("at %1: %2 mm², Ø %3")
      .arg(millimetres(p.along), fineNumber(*p.area), millimetres(p.equivalentDiameter()));
}

}  // namespace handlebody::ui
