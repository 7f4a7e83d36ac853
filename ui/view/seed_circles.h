#pragma once
// Seeds as circles on a slice, crossed where they lie outside of the object: where they are and what the
// mouse has hold of.

#include <QPainter>
#include <vector>

#include "core/evolution/parameters.h"
#include "ui/view/slice_geometry.h"

namespace handlebody::ui {

//! A seed's ball cut by a slice, or beside it.
struct SeedCircle {
  int seed = 0;          //!< index of the seed
  QPointF centre;        //!< pixels
  double radius = 0;     //!< pixels; 0: the slice misses the ball, which is a dot there
  double distance = 0;   //!< mm of the ball's centre from the slice
  bool outside = false;  //!< a click outside of the object
};

//! Of clicks outside of the object, here and in 3D: not to be taken for that of seeds with any kind of sight.
QColor outsideColour();

//! The balls (centre and radius in mm, one each per seed) that the slice cuts, and those it misses whose
//! centres are no farther than `reach` (mm) from it.
std::vector<SeedCircle> seedCircles(const SliceGeometry& geometry, const std::vector<Vec3>& centres,
                                    const std::vector<double>& radii, double reach = 0);

//! What lies under the mouse: a circle's rim, or its centre; all of a small circle counts as its centre, and
//! a dot is nothing else.
struct SeedGrab {
  enum class Part { none, centre, rim } part = Part::none;
  int seed = -1;
};
//! Of several the selected one, else the one drawn last.
SeedGrab seedAt(const std::vector<SeedCircle>& circles, const QPointF& pixel, int selected);
//! The radius (mm) of a ball whose rim is dragged to `pixel`.
double draggedRadius(const SliceGeometry& geometry, const Vec3& centre, const QPointF& pixel);

void paintSeeds(QPainter& painter, const std::vector<SeedCircle>& circles, int selected);

}  // namespace handlebody::ui
