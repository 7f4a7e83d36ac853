#pragma once
// For tests of the widgets: a volume, the four parts that belong together, real events.

#include <QApplication>
#include <QImage>
#include <QTest>
#include <QWheelEvent>
#include <optional>

#include "core/mesh/shapes.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"
#include "tests/ui/view/document_double.h"
#include "ui/view/slice_geometry.h"
#include "ui/view/slice_view.h"
#include "ui/view/surface_view.h"

namespace handlebody::ui::testing {

//! 64 × 64 × 64 voxels of 1 mm, grey 100 but for a bright block (200) towards left, anterior and superior.
inline Volume blockVolume() {
  Grid grid = handlebody::testing::cubicGrid(64);
  grid.origin = Vec3(-40, -20, 100);
  return handlebody::testing::volumeByIndex(
      grid, [](int i, int j, int k) { return i >= 40 && j < 24 && k >= 40 ? 200 : 100; });
}

struct Work {
  Document document;
  ViewState state;
  Volume volume = blockVolume();

  void open() {
    setVolume(document, volume);
    state.startWith(volume);
  }
  Vec3 world(double i, double j, double k) const { return volume.grid.toWorld(Vec3(i, j, k)); }
};

//! The faces on that side of a place are without an edge.
inline SurfaceSupport withoutEdgeTowards(const TriangleSoup& mesh, const Vec3& side, const Vec3& place) {
  SurfaceSupport support;
  for (const Triangle& t : mesh.triangles) {
    Vec3 middle = Vec3::Zero();
    for (int v : t) middle += mesh.points[v] / 3;
    support.faces.push_back((middle - place).dot(side) > 0 ? FaceSupport::none : FaceSupport::edge);
  }
  return support;
}

//! Lit or not; the seeds' blue has more green.
inline bool isUnsupported(const QColor& c) {
  return c.blue() > c.green() + 40 && c.blue() > c.red() + 40 && c.green() < c.red() + 40;
}

//! Shown and drawn.
template <typename View>
void show(View& view, const QSize& size) {
  view.resize(size);
  view.show();
  REQUIRE(QTest::qWaitForWindowExposed(&view));
  QApplication::setActiveWindow(&view);  // there is no window manager that would
  view.setFocus();
  QCoreApplication::processEvents();
}

//! As a notch of the wheel away from the user, `notches` times; negative: towards.
inline void turnWheel(QWidget& view, const QPointF& at, int notches, Qt::KeyboardModifiers modifiers = {}) {
  QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &event);
}

inline void drag(QWidget& view, Qt::MouseButton button, const QPoint& from, const QPoint& to,
                 Qt::KeyboardModifiers modifiers = {}) {
  QTest::mousePress(&view, button, modifiers, from);
  for (int part = 1; part <= 4; ++part) {
    const QPointF at = from + (to - from) * (part / 4.0);
    // QTest's moves carry no buttons.
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, modifiers);
    QCoreApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, button, modifiers, to);
}

//! Of a channel of a pixel, 0 … 255. The rims of texts may differ by 1 from picture to picture: Qt blends
//! with vector instructions, whose rounding depends on where the buffer lies.
inline int largestDifference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 255;
  int largest = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      for (int d : {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)})
        largest = std::max(largest, std::abs(d));
    }
  return largest;
}

template <typename F>
int countPixels(const QImage& image, const QRect& area, F&& is) {
  int count = 0;
  for (int y = area.top(); y <= area.bottom(); ++y)
    for (int x = area.left(); x <= area.right(); ++x) count += is(QColor(image.pixel(x, y))) ? 1 : 0;
  return count;
}

template <typename F>
int countPixels(const QImage& image, F&& is) {
  return countPixels(image, image.rect(), is);
}

}  // namespace handlebody::ui::testing
