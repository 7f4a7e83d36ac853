#pragma once
// What tests of the step Correct share: two balls with a bar between them, open in a window.

#include <QAbstractButton>
#include <QDoubleSpinBox>
#include <QUndoStack>
#include <QWheelEvent>

#include "core/io/formats/volume_io.h"
#include "tests/support/test_volume.h"
#include "tests/support/wall_support.h"
#include "tests/ui/window/window_support.h"
#include "ui/view/slice_geometry.h"
#include "ui/window/correct/local_section.h"

namespace handlebody::test {

inline const Vec3 kLeft(12, 20, 20), kRight(30, 20, 20), kNeck(21, 20, 20);

//! Two dark balls with a wide bar between them, at the same places however the columns are counted.
inline QString writeBalls(const QTemporaryDir& folder, bool fromTheLeft) {
  const QString path = folder.filePath("balls.nii.gz");
  const auto intensity = [](int i, int j, int k) {
    const Vec3 p(i, j, k);
    const bool between = p.x() > kLeft.x() && p.x() < kRight.x();
    const double bar = between ? std::hypot(p.y() - 20, p.z() - 20) - 3.5 : 100;
    const double distance = std::min({(p - kLeft).norm() - 8.0, (p - kRight).norm() - 8.0, bar});
    // No two voxels are quite alike, so that the background is not taken for padding.
    return 110 + 90 * std::clamp(distance, -1.0, 1.0) + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  };
  Grid grid = testing::cubicGrid(43);
  if (fromTheLeft) {
    grid.direction.col(0) = Vec3(-1, 0, 0);
    grid.origin = Vec3(42, 0, 0);
  }
  writeVolume(testing::volumeByIndex(grid, intensity), path.toStdString());
  return path;
}

struct Opened {
  QTemporaryDir folder;
  std::unique_ptr<ui::MainWindow> window = shownWindow();
  bool ok = false;

  explicit Opened(bool fromTheLeft = false) {
    if (!window || !open(*window, writeBalls(folder, fromTheLeft))) return;
    Parameters p = window->document().parameters();
    p.range = IntensityRange{-1000, 110};  // all that is dark: nothing else holds it back
    window->document().setParameters(p, "Range");
    window->viewState().setCrosshair(kLeft);
    QTest::keyClick(window.get(), Qt::Key_Return);
    window->showStep(ui::Command::stepCorrect);
    ok = window->document().seeds().size() == 1;
  }
  ui::Document& document() { return window->document(); }
  ui::SliceView& axial() { return window->views().slice(ui::Plane::axial); }
  QPoint pixel(const Vec3& world) {
    ui::SliceGeometry geometry(document().volume().grid, ui::Plane::axial, axial().size());
    geometry.setSlice(geometry.nearestSlice(window->viewState().crosshair()));
    return geometry.worldToScreen(world).toPoint();
  }
  //! As a hand does: in steps of a few pixels.
  void drag(const Vec3& from, const Vec3& to) {
    QTest::mousePress(&axial(), Qt::LeftButton, {}, pixel(from));
    for (int i = 1; i <= 10; ++i) {
      const QPoint at = pixel(from + i / 10.0 * (to - from));
      QMouseEvent move(QEvent::MouseMove, at, axial().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&axial(), &move);
    }
    QTest::mouseRelease(&axial(), Qt::LeftButton, {}, pixel(to));
  }
  void turnWheel(const QPoint& at, int notches, Qt::KeyboardModifiers keys) {
    QWheelEvent event(at, axial().mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&axial(), &event);
  }
  //! To the end; the step Correct is shown.
  bool grow() {
    document().run();
    const bool done = waitFor(*window, ui::GrowthState::finished);
    window->showStep(ui::Command::stepCorrect);
    return done && document().snapshot();
  }
  QDoubleSpinBox* localRadius() {
    return window->findChild<ui::LocalSection*>()->findChild<QDoubleSpinBox*>();
  }
  QAbstractButton* choice(const QString& name) {
    const auto all = window->findChild<ui::LocalSection*>()->findChildren<QAbstractButton*>();
    for (QAbstractButton* b : all)
      if (b->accessibleName() == name) return b;
    return nullptr;
  }
  //! The window as it is seen in both appearances; to be looked at.
  void keepPicture(const QString& name) {
    const QString pictures = qEnvironmentVariable("HANDLEBODY_KEEP_PICTURES");
    if (pictures.isEmpty()) return;
    for (const auto appearance : {ui::Appearance::dark, ui::Appearance::light}) {
      window->setAppearance(appearance);
      QTest::qWait(300);
      window->grab().save(pictures + '/' + name +
                          (appearance == ui::Appearance::dark ? "_dark.png" : "_light.png"));
    }
  }
  double clearance() {
    return testing::clearance(Mesh(document().snapshot()->mesh), document().constraints().walls.balls);
  }
  double furthest() {
    double x = 0;
    for (const Vec3& p : document().snapshot()->mesh.points) x = std::max(x, p.x());
    return x;
  }
  QAbstractButton* button(const QString& text) {
    const auto all = window->findChildren<QAbstractButton*>();
    for (QAbstractButton* b : all)
      if (b->isVisible() && b->text() == text) return b;
    return nullptr;
  }
};

}  // namespace handlebody::test
