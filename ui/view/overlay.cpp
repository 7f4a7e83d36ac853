#include "ui/view/overlay.h"

#include <QCache>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLocale>
#include <QPainterPath>
#include <cmath>

#include "core/volume/anatomy.h"

namespace handlebody::ui {
namespace {

const QColor kLineRim(0, 0, 0, 150), kTextRim(0, 0, 0, 235);

QRectF textRect(const QPointF& place, Qt::Alignment flags, const QSizeF& size) {
  QPointF corner = place;
  if (flags & Qt::AlignRight) corner.rx() -= size.width();
  if (flags & Qt::AlignHCenter) corner.rx() -= size.width() / 2;
  if (flags & Qt::AlignBottom) corner.ry() -= size.height();
  if (flags & Qt::AlignVCenter) corner.ry() -= size.height() / 2;
  return {corner, size};
}

}  // namespace

QColor planeColour(Plane plane) {
  return plane == Plane::axial     ? QColor(0xf3, 0x4a, 0x33)
         : plane == Plane::coronal ? QColor(0x6e, 0xb0, 0x4b)
                                   : QColor(0xed, 0xd5, 0x4c);
}

QString planeName(Plane plane) {
  return plane == Plane::axial     ? QCoreApplication::translate("SliceView", "Axial")
         : plane == Plane::coronal ? QCoreApplication::translate("SliceView", "Coronal")
                                   : QCoreApplication::translate("SliceView", "Sagittal");
}

QFont overlayFont(double factor, bool bold) {
  QFont font = QGuiApplication::font();
  font.setPointSizeF(std::max(1.0, font.pointSizeF()) * factor);
  font.setBold(bold);
  return font;
}

namespace {

constexpr qsizetype kKeptTexts = 4'000'000;       // bytes
constexpr double kLineRimWidth = 4, kAround = 3;  // pixels; the room around a text that its rim takes

QImage drawText(const QString& text, const QFont& font, const QColor& colour, const QSizeF& size,
                double ratio) {
  const QSizeF whole(size.width() + 2 * kAround, size.height() + 2 * kAround);
  QImage picture((whole * ratio).toSize() + QSize(1, 1), QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF baseline(kAround, kAround + QFontMetricsF(font, &picture).ascent());
  QPainterPath outline;
  outline.addText(baseline, font, text);
  painter.strokePath(outline, QPen(kTextRim, kLineRimWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(baseline, text);
  painter.end();
  return picture.copy();  // a picture that was painted on keeps its painter's buffers, far larger than itself
}

}  // namespace

// Most texts are the same from frame to frame, and their rims cost more than all else in a slice: they are
// kept. Not in QPixmapCache, which never forgets the names of what it threw away.
void paintText(QPainter& painter, const QPointF& place, Qt::Alignment flags, const QString& text,
               const QFont& font, const QColor& colour) {
  const QFontMetricsF metrics(font, painter.device());
  const QRectF rect = textRect(place, flags, {metrics.horizontalAdvance(text) + 1, metrics.height()});
  const double ratio = painter.device()->devicePixelRatioF();
  const QString key = font.key() + colour.name() + QString::number(ratio) + text;
  static QCache<QString, QImage> kept(kKeptTexts);
  QImage picture;
  if (const QImage* known = kept.object(key)) {
    picture = *known;
  } else {
    picture = drawText(text, font, colour, rect.size(), ratio);
    kept.insert(key, new QImage(picture), picture.sizeInBytes());
  }
  const QPointF corner = (rect.topLeft() - QPointF(kAround, kAround)) * ratio;
  painter.drawImage(QPointF(std::round(corner.x()), std::round(corner.y())) / ratio, picture);
}

void paintKey(QPainter& painter, const QPointF& place, const QColor& colour, const QString& text) {
  const QFont font = overlayFont(0.95);
  const double side = QFontMetricsF(font).ascent() * 0.8;
  const QRectF swatch(place.x(), place.y() - side / 2, side, side);
  painter.fillRect(swatch.adjusted(-1, -1, 1, 1), kLineRim);
  painter.fillRect(swatch, colour);
  paintText(painter, {swatch.right() + 6, place.y()}, Qt::AlignLeft | Qt::AlignVCenter, text, font);
}

QColor loopColour(MarkedLoop::Kind kind) {
  return kind == MarkedLoop::Kind::handle ? QColor(0x5e, 0xff, 0x5e) : QColor(0x00, 0xe5, 0xff);
}

QColor pinColour() { return {0x8c, 0xff, 0xf2}; }

QColor wallColour() { return {0xd8, 0x5c, 0xf0}; }

QColor unsupportedColour() { return {0x6a, 0x7b, 0xff}; }

void paintScaleBar(QPainter& painter, const QSizeF& size, double mmPerPixel) {
  if (!(mmPerPixel > 0) || size.width() < 80) return;
  const double length = roundLength(0.25 * size.width() * mmPerPixel);
  const double pixels = length / mmPerPixel;
  constexpr double kThickness = 3;
  const QRectF bar(size.width() - kOverlayMargin - pixels, size.height() - kOverlayMargin - kThickness,
                   pixels, kThickness);
  painter.fillRect(bar.adjusted(-1, -1, 1, 1), kLineRim);
  painter.fillRect(bar, QColor(0xe8, 0xec, 0xf0));
  const QString number = QLocale().toString(length, 'f', QLocale::FloatingPointShortest);
  paintText(painter, {bar.right(), bar.top() - 2}, Qt::AlignRight | Qt::AlignBottom,
            QCoreApplication::translate("SliceView", "%1 mm").arg(number), overlayFont(0.95));
}

void paintFrame(QPainter& painter, const QSizeF& size, const QColor& colour, bool focused) {
  constexpr double kBar = 3, kBorder = 2;
  painter.fillRect(QRectF(0, 0, size.width(), kBar), colour);
  if (!focused) return;
  painter.fillRect(QRectF(0, 0, kBorder, size.height()), colour);
  painter.fillRect(QRectF(size.width() - kBorder, 0, kBorder, size.height()), colour);
  painter.fillRect(QRectF(0, size.height() - kBorder, size.width(), kBorder), colour);
}

void paintHint(QPainter& painter, const QSizeF& size, const QString& text) {
  painter.setFont(overlayFont(1.1));
  painter.setPen(QColor(0x9a, 0xa2, 0xac));
  const QRectF inner = QRectF({0, 0}, size).adjusted(24, 24, -24, -24);
  painter.drawText(inner, Qt::AlignCenter | Qt::TextWordWrap, text);
}

}  // namespace handlebody::ui
