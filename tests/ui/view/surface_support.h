#pragma once
// What tests of the 3D view share.

#include <iostream>

#include "tests/ui/view/widget_support.h"

namespace handlebody::ui::testing {

inline constexpr int kWidth = 400, kHeight = 300;

inline bool isWarm(const QColor& c) { return c.red() > c.blue() + 40; }  // the mesh's own colour
inline bool isRed(const QColor& c) { return c.red() > 2 * c.green() + 30 && c.red() > 2 * c.blue() + 30; }
inline bool isGreen(const QColor& c) { return c.green() > c.red() + 50 && c.green() > c.blue() + 20; }

//! A shown view of an open volume without slices; the camera jumps.
struct Surface : Work {
  Surface() : view(document, state) {
    view.setFlightTime(0);
    open();
    state.setSlicesIn3d(false);
    show(view, {kWidth, kHeight});
  }
  bool ready() const {
    if (view.hasOpenGl()) return true;
    std::cout << "SKIPPED: no OpenGL\n";
    return false;
  }
  QImage picture() { return view.picture(); }
  //! The middle of all pixels that are so.
  template <typename F>
  QPointF middle(F&& is) {
    const QImage image = picture();
    QPointF sum;
    int count = 0;
    for (int y = 60; y < kHeight - 60; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (is(QColor(image.pixel(x, y)))) {
          sum += QPointF(x, y);
          ++count;
        }
    REQUIRE(count > 20);
    return sum / count;
  }
  void setSphere(double radius = 15) { setSnapshot(document, icosphere(world(32, 32, 32), radius, 2)); }

  SurfaceView view;
};

inline int differingPixels(const QImage& a, const QImage& b) {
  REQUIRE(a.size() == b.size());
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return count;
}

}  // namespace handlebody::ui::testing
