#pragma once
// Two dark balls that run into one another, and a window in which they are grown.

#include <QTableWidget>
#include <algorithm>

#include "core/io/formats/volume_io.h"
#include "tests/support/test_volume.h"
#include "tests/ui/window/window_support.h"
#include "ui/window/objects/objects_panel.h"

namespace handlebody::test {

inline const Vec3 kLeft(12, 20, 20), kRight(28, 20, 20);

inline QString writeBalls(const QTemporaryDir& folder) {
  const QString path = folder.filePath("balls.nii.gz");
  const auto intensity = [](int i, int j, int k) {
    const Vec3 p(i, j, k);
    const double distance = std::min((p - kLeft).norm(), (p - kRight).norm()) - 8.5;
    // No two voxels are quite alike, so that the background is not taken for padding.
    return 110 + 90 * std::clamp(distance, -1.0, 1.0) + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  };
  writeVolume(testing::volumeByIndex(testing::cubicGrid(41), intensity), path.toStdString());
  return path;
}

inline ui::ObjectsPanel* panelOf(ui::MainWindow& window) { return window.findChild<ui::ObjectsPanel*>(); }
inline QTableWidget* tableOf(ui::MainWindow& window) { return panelOf(window)->findChild<QTableWidget*>(); }

inline bool addSecond(ui::MainWindow& window) {
  QTest::keyClick(&window, Qt::Key_N, Qt::ControlModifier);
  window.viewState().setCrosshair(kRight);
  QTest::keyClick(&window, Qt::Key_Return);
  return window.document().objectCount() == 2 && window.document().seeds().size() == 1;
}

//! The first object is stopped on its way, the second grows to its end.
inline bool growTwo(ui::MainWindow& window) {
  window.viewState().setCrosshair(kLeft);
  QTest::keyClick(&window, Qt::Key_Return);
  for (int i = 1; i <= 8; ++i) {
    QTest::keyClick(&window, Qt::Key_Period);
    if (!QTest::qWaitFor([&] { return window.document().iteration() == i; }, kPatience)) return false;
  }
  if (!waitFor(window, ui::GrowthState::paused) || !addSecond(window)) return false;
  QTest::keyClick(&window, Qt::Key_Space);
  return waitFor(window, ui::GrowthState::finished);
}

//! The first whose text holds this; null if none does.
template <typename Widget>
Widget* saying(QWidget& parent, const char* text) {
  const auto all = parent.findChildren<Widget*>();
  for (Widget* widget : all)
    if (widget->text().remove('&').contains(QLatin1String(text))) return widget;
  return nullptr;
}

//! By its accessible name.
template <typename Widget>
Widget* called(QWidget& parent, const char* name) {
  const auto all = parent.findChildren<Widget*>();
  for (Widget* widget : all)
    if (widget->accessibleName() == QLatin1String(name)) return widget;
  return nullptr;
}

}  // namespace handlebody::test
