#include "ui/window/widgets/appearance.h"

#include <QApplication>
#include <QPalette>
#include <QToolTip>

#include "ui/window/widgets/window_style.h"

namespace handlebody::ui {

namespace {

const QColor kThemeAccent(0x2F, 0x74, 0xB5);

QPalette lightPalette() {
  QPalette p(QColor(0xF0, 0xF1, 0xF3));
  p.setColor(QPalette::Window, QColor(0xF3, 0xF4, 0xF6));
  p.setColor(QPalette::Base, Qt::white);
  p.setColor(QPalette::AlternateBase, QColor(0xF6, 0xF7, 0xF9));
  p.setColor(QPalette::Button, QColor(0xEC, 0xEE, 0xF1));
  p.setColor(QPalette::ToolTipBase, QColor(0xFF, 0xFB, 0xE8));
  p.setColor(QPalette::ToolTipText, QColor(0x20, 0x24, 0x28));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(role, QColor(0x20, 0x24, 0x28));
  p.setColor(QPalette::PlaceholderText, QColor(0x5C, 0x64, 0x6C));
  p.setColor(QPalette::Link, kThemeAccent);
  return p;
}

QPalette darkPalette() {
  QPalette p(QColor(0x33, 0x37, 0x3C));
  p.setColor(QPalette::Window, QColor(0x2A, 0x2D, 0x31));
  p.setColor(QPalette::Base, QColor(0x1F, 0x22, 0x25));
  p.setColor(QPalette::AlternateBase, QColor(0x25, 0x28, 0x2C));
  p.setColor(QPalette::Button, QColor(0x3A, 0x3F, 0x45));
  p.setColor(QPalette::ToolTipBase, QColor(0x3D, 0x3A, 0x2C));
  p.setColor(QPalette::ToolTipText, QColor(0xEE, 0xEE, 0xEE));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(role, QColor(0xE4, 0xE7, 0xEA));
  p.setColor(QPalette::PlaceholderText, QColor(0xA3, 0xAB, 0xB3));
  p.setColor(QPalette::BrightText, Qt::white);
  p.setColor(QPalette::Link, QColor(0x7F, 0xB8, 0xE8));
  return p;
}

QPalette finished(QPalette p, const QColor& disabledText) {
  p.setColor(QPalette::Highlight, kThemeAccent);
  p.setColor(QPalette::HighlightedText, Qt::white);
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText})
    p.setColor(QPalette::Disabled, role, disabledText);
  return p;
}

//! Always the same two: Qt keeps what it has painted by palette, and never forgets the names of what it threw
//! away.
const QPalette& paletteOf(bool dark) {
  static const QPalette lightOne = finished(lightPalette(), QColor(0x9A, 0xA1, 0xA8));
  static const QPalette darkOne = finished(darkPalette(), QColor(0x7C, 0x83, 0x8A));
  return dark ? darkOne : lightOne;
}

bool desktopIsDark() {
  static const bool dark = QApplication::palette().color(QPalette::Window).lightnessF() < 0.5F;
  return dark;
}

}  // namespace

void applyAppearance(Appearance appearance) {
  const bool systemDark = desktopIsDark();  // before the palette is ours
  const bool dark = appearance == Appearance::dark || (appearance == Appearance::system && systemDark);
  if (!qobject_cast<WindowStyle*>(QApplication::style())) QApplication::setStyle(new WindowStyle);
  QApplication::setPalette(paletteOf(dark));
  QToolTip::setPalette(paletteOf(dark));
}

}  // namespace handlebody::ui
