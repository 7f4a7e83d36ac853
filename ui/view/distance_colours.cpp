#include "ui/view/distance_colours.h"

#include <QCoreApplication>
#include <QLinearGradient>
#include <algorithm>
#include <cmath>

#include "ui/view/overlay.h"
#include "ui/view/significant_digits.h"

namespace handlebody::ui {

namespace {

constexpr int kEntries = 256;
const QColor kInside(0x2b, 0x6c, 0xd4), kNear(0xf2, 0xf0, 0xea), kOutside(0xd9, 0x3a, 0x2b);

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto mix = [share](int x, int y) { return static_cast<int>(std::lround(x + share * (y - x))); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

//! With two significant digits, not below the value.
double roundedUp(double value) {
  if (!(value > 0)) return 0.1;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit - 1e-9) * unit;
}

QString millimetresOf(double value, bool isEnd) {
  const QString text = significant(value, 3);
  return (isEnd ? QCoreApplication::translate("SurfaceView", "%1 mm or more")
                : QCoreApplication::translate("SurfaceView", "%1 mm"))
      .arg(text);
}

}  // namespace

DistanceColours distanceColours(std::shared_ptr<const MeshSnapshot> mesh, const std::vector<double>& ofPoint,
                                bool isSigned) {
  constexpr double kWithin = 0.98;
  DistanceColours colours{std::move(mesh), {}, isSigned};
  std::vector<double> away;
  for (const Triangle& t : colours.mesh->mesh.triangles) {
    double sum = 0;
    for (const int v : t) sum += ofPoint[v];
    colours.ofFace.push_back(sum / 3);
    away.push_back(std::abs(sum / 3));
  }
  if (away.empty()) return colours;
  const auto at = away.begin() + static_cast<std::ptrdiff_t>(kWithin * static_cast<double>(away.size() - 1));
  std::nth_element(away.begin(), at, away.end());
  colours.end = roundedUp(*at);
  return colours;
}

const std::vector<QColor>& distancePalette(bool isSigned) {
  static const auto make = [](bool hasInside) {
    std::vector<QColor> palette;
    for (int i = 0; i < kEntries; ++i) {
      const double share = static_cast<double>(i) / (kEntries - 1), side = 2 * share - 1;
      palette.push_back(!hasInside ? mixed(kNear, kOutside, share)
                        : side < 0 ? mixed(kNear, kInside, -side)
                                   : mixed(kNear, kOutside, side));
    }
    return palette;
  };
  static const std::vector<QColor> withInside = make(true), without = make(false);
  return isSigned ? withInside : without;
}

std::vector<unsigned char> paletteEntries(const DistanceColours& colours) {
  std::vector<unsigned char> entries;
  entries.reserve(colours.ofFace.size());
  for (const double d : colours.ofFace) {
    const double share = colours.isSigned ? (d / colours.end + 1) / 2 : d / colours.end;
    entries.push_back(static_cast<unsigned char>(std::lround((kEntries - 1) * std::clamp(share, 0.0, 1.0))));
  }
  return entries;
}

void paintDistanceScale(QPainter& painter, const QSizeF& size, const DistanceColours& colours) {
  constexpr double kBar = 12, kTop = 56,
                   kBottom = 64;  // pixels; the maximise button and the scale bar stay free
  const double height = std::min(170.0, size.height() - kTop - kBottom);
  if (height < 40) return;
  const QRectF bar(size.width() - kOverlayMargin - kBar, kTop, kBar, height);
  QLinearGradient gradient(bar.topLeft(), bar.bottomLeft());
  constexpr int kStops = 8;
  const auto& palette = distancePalette(colours.isSigned);
  for (int i = 0; i <= kStops; ++i)
    gradient.setColorAt(1 - static_cast<double>(i) / kStops, palette[i * (kEntries - 1) / kStops]);
  painter.setPen(QPen(QColor(0, 0, 0, 150), 2));
  painter.setBrush(gradient);
  painter.drawRect(bar);
  painter.setBrush(Qt::NoBrush);
  const QFont font = overlayFont(0.95);
  const auto label = [&](double y, const QString& text) {
    paintText(painter, {bar.left() - 6, y}, Qt::AlignRight | Qt::AlignVCenter, text, font);
  };
  if (!colours.title.isEmpty())
    paintText(painter, {bar.right(), bar.top() - 8}, Qt::AlignRight | Qt::AlignBottom, colours.title, font);
  const QString end = millimetresOf(colours.end, true);
  label(bar.top(),
        colours.isSigned ? QCoreApplication::translate("SurfaceView", "outside: %1").arg(end) : end);
  label(bar.bottom(), colours.isSigned ? QCoreApplication::translate("SurfaceView", "inside: %1").arg(end)
                                       : millimetresOf(0, false));
  if (colours.isSigned)
    label(bar.center().y(), QCoreApplication::translate("SurfaceView", "on the reference: 0 mm"));
}

}  // namespace handlebody::ui
