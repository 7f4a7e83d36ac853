#pragma once
// What tests of the slices share.

#include "tests/ui/view/widget_support.h"

namespace handlebody::ui::testing {

inline constexpr int kWidth = 400, kHeight = 300;

//! A shown view of an open volume, and where its pixels lie by the geometry's own account.
struct OneSlice : Work {
  explicit OneSlice(Plane plane = Plane::axial) : view(plane, document, state) {
    open();
    show(view, {kWidth, kHeight});
    geometry = SliceGeometry(volume.grid, plane, {kWidth, kHeight});
    QObject::connect(&view, &SliceView::hovered, [this](const Vec3& world, const Vec3&, double value) {
      hovered = world;
      intensity = value;
    });
    QObject::connect(&view, &SliceView::left, [this] { hovered.reset(); });
  }
  //! What the view says lies under the mouse.
  Vec3 under(const QPointF& pixel) {
    QMouseEvent move(QEvent::MouseMove, pixel, view.mapToGlobal(pixel), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&view, &move);
    REQUIRE(hovered.has_value());
    return *hovered;
  }
  Vec3 index() const { return volume.grid.toIndex(state.crosshair()); }

  SliceView view;
  SliceGeometry geometry;
  std::optional<Vec3> hovered;
  double intensity = 0;
};

inline const QPoint kPlace(190, 130);

}  // namespace handlebody::ui::testing
