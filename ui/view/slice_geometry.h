#pragma once
// Where a slice of the volume lies on the screen: everything between pixels and voxels, without drawing.

#include <QPointF>
#include <QSizeF>
#include <QStringList>

#include "core/volume/anatomy.h"
#include "ui/view/view_state.h"

namespace handlebody::ui {

//! One slice across a voxel axis, shown in a widget. Pixels are logical, (0, 0) the upper left corner; voxels
//! are shown in their true proportions.
class SliceGeometry {
 public:
  SliceGeometry() = default;
  //! The middle slice, fitted into `size`.
  SliceGeometry(const Grid& grid, Plane plane, const QSizeF& size);

  const Grid& grid() const { return grid_; }
  const SliceAxes& axes() const { return axes_; }
  const QSizeF& size() const { return size_; }
  double mmPerPixel() const { return mmPerPixel_; }
  int slice() const { return slice_; }  //!< voxel index along the normal axis
  int slices() const { return grid_.size[axes_.normal]; }
  //! The slice nearest to a world point (mm), within the volume.
  int nearestSlice(const Vec3& world) const;
  void setSlice(int slice);
  //! +1 if the slice number grows towards superior, anterior or the patient's right, else -1.
  int forward() const;
  //! Moves the fitted slice along, otherwise keeps scale and middle.
  void resize(const QSizeF& size);
  //! The whole slice, centred.
  void fit();
  bool isFitted() const { return fitted_; }
  //! Larger by `factor` with the place under `fixed` kept there; within reasonable limits, which the whole
  //! slice is never beyond.
  void zoom(double factor, const QPointF& fixed);
  void pan(const QPointF& pixels);

  //! Continuous voxel index → pixels; what is off the slice is projected onto it.
  QPointF toScreen(const Vec3& index) const;
  //! A point of the slice, as a continuous voxel index; may lie outside the volume.
  Vec3 toIndex(const QPointF& pixel) const;
  QPointF worldToScreen(const Vec3& world) const { return toScreen(grid_.toIndex(world)); }
  Vec3 toWorld(const QPointF& pixel) const { return grid_.toWorld(toIndex(pixel)); }
  //! Unit normal of the slice, mm.
  Vec3 normal() const { return grid_.direction.col(axes_.normal); }
  //! Signed distance (mm) of a world point from the slice, along normal().
  double distance(const Vec3& world) const;
  //! The nearest point of the volume (its outermost voxel centres), as an index.
  Vec3 clamped(const Vec3& index) const;

 private:
  friend SliceGeometry wholeSlice(const Grid& grid, Plane plane, double longest);
  double fittedScale() const;

  Grid grid_;
  Plane plane_ = Plane::axial;
  SliceAxes axes_;
  QSizeF size_{1, 1};
  Vec3 centre_{0, 0, 0};  // index at the middle of the widget
  int slice_ = 0;
  double mmPerPixel_ = 1;
  bool fitted_ = true;
};

//! The middle slice without a rim, about a pixel per voxel but at most `longest` along a side: for a texture.
SliceGeometry wholeSlice(const Grid& grid, Plane plane, double longest);

//! Lines: "Slice 5 of 20, S 12.0 mm", where the crosshair passes through it: even below the degree from which
//! a volume is oblique its corners may lie some millimetres higher or lower; of an oblique volume, where no
//! one number says where a slice lies, "Slice 5 of 20" and the whole place of the crosshair (mm LPS).
QStringList slicePlace(const SliceGeometry& geometry, Plane plane, const Vec3& crosshair);

}  // namespace handlebody::ui
