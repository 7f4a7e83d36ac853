#include "ui/window/widgets/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

// Outside every namespace, as Q_INIT_RESOURCE asks for: resources of a static library are not found by
// themselves.
static void registerResources() { Q_INIT_RESOURCE(handlebody); }

namespace handlebody::ui {

namespace {

QColor lineColour(QIcon::Mode mode) {
  const QPalette palette = QGuiApplication::palette();
  if (mode == QIcon::Selected) return palette.color(QPalette::Active, QPalette::HighlightedText);
  return palette.color(mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::WindowText);
}

// A coloured part looks as if it could be pressed, however faint it is; and is not seen on a chosen row.
QByteArray withoutAccents(QByteArray drawing) {
  for (const char* accent : {"#3b82c4", "#c2483d", "#c98a1b"}) drawing.replace(accent, "currentColor");
  return drawing;
}

// Red is too dim on dark ground and amber on light ground: their contrast would be below 3.
QByteArray withSeenAccents(QByteArray drawing, const QColor& line) {
  const bool dark = line.lightnessF() > 0.5F;
  return dark ? drawing.replace("#c2483d", "#e8776b") : drawing.replace("#c98a1b", "#b37412");
}

class LineIcon : public QIconEngine {
 public:
  explicit LineIcon(QByteArray drawing) : drawing_(std::move(drawing)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QByteArray coloured = drawing_;
    if (mode == QIcon::Disabled || mode == QIcon::Selected) coloured = withoutAccents(coloured);
    coloured = withSeenAccents(coloured, lineColour(mode));
    coloured.replace("currentColor", lineColour(mode).name().toLatin1());
    QSvgRenderer renderer(coloured);
    if (mode == QIcon::Disabled) painter->setOpacity(0.55);
    renderer.render(painter, rect);
    painter->setOpacity(1);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new LineIcon(drawing_); }

 private:
  QByteArray drawing_;
};

QByteArray resource(const QString& name) {
  static const bool registered = (registerResources(), true);
  Q_UNUSED(registered);
  QFile file(QStringLiteral(":/handlebody/icons/%1.svg").arg(name));
  const bool there = file.open(QIODevice::ReadOnly);
  Q_ASSERT_X(there, "icon", qPrintable(name));
  return there ? file.readAll() : QByteArray();
}

}  // namespace

QIcon icon(const QString& name) { return QIcon(new LineIcon(resource(name))); }

QIcon iconOnBlack(const QString& name) {
  return QIcon(new LineIcon(resource(name).replace("currentColor", "#e6e9ec")));
}

QIcon swatch(const Colour& colour) {
  constexpr int kSide = 42, kScale = 3;  // pixels: sharp on any screen
  QPixmap pixmap(kSide, kSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 120), kScale));
  painter.setBrush(QColor(colour[0], colour[1], colour[2]));
  painter.drawRoundedRect(pixmap.rect().adjusted(kScale, kScale, -kScale, -kScale), 6, 6);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // not tinted there
  return icon;
}

QIcon programIcon() { return icon(QStringLiteral("handlebody")); }

}  // namespace handlebody::ui
