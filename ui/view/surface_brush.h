#pragma once
// Internal: the brush on the surface in the 3D view. It lies on the point of the surface under the mouse.

#include <QPainter>
#include <QPointF>
#include <QSizeF>
#include <optional>

#include "core/mesh/mesh.h"
#include "ui/view/brush_hand.h"
#include "ui/view/surface_scene.h"

namespace handlebody::ui {

//! What the camera sees: parallel projection, so that every pixel is a straight line towards the eye.
struct Eye {
  CameraPose pose;
  QSizeF size;  //!< of the view, logical pixels

  double mmPerPixel() const { return pose.height / size.height(); }
  QPointF toScreen(const Vec3& world) const;
  //! The point under a pixel that is as far from the eye as another one.
  Vec3 toWorld(const QPointF& pixel, const Vec3& asFarAs) const;
};

//! The point of a surface (mm) under a pixel that is nearest to the eye; none: it is not there.
std::optional<Vec3> pick(const TriangleSoup& surface, const Eye& eye, const QPointF& pixel);

class SurfaceBrush {
 public:
  SurfaceBrush(Document& document, ViewState& state);

  //! False where nothing is under the mouse that the brush could be used on: the camera's.
  bool press(const Eye& eye, const QPointF& pixel);
  //! With the button down or not. Precondition: the brush is on for the surface.
  void move(const Eye& eye, const QPointF& pixel);
  void lift();
  void giveUp();
  //! The mouse is not over the view any more.
  void leave() { pointer_.reset(); }
  bool isDown() const { return hand_.isDown(); }
  Qt::CursorShape cursor(const Eye& eye) const;

  void paint(QPainter& painter, const Eye& eye) const;

 private:
  std::optional<Vec3> placeUnder(const Eye& eye, const QPointF& pixel) const;
  void drawTo(const Eye& eye, const QPointF& pixel);

  Document& document_;
  ViewState& state_;
  BrushHand hand_;
  std::optional<QPointF> pointer_;
  std::optional<Vec3> last_;  // of the stroke; none: it has left the surface
};

}  // namespace handlebody::ui
