#pragma once
// Internal: walls on a slice.

#include <QColor>
#include <QImage>
#include <QPainter>
#include <memory>
#include <vector>

#include "core/evolution/constraints.h"
#include "ui/view/slice_geometry.h"

namespace handlebody::ui {

class Brush;

//! Balls and voxels filled as one, however they overlap; discs as the line in which the slice cuts them, or
//! whole where they lie in it. Balls are drawn into a picture of their own, to which a stroke adds: what a
//! mouse move costs does not depend on how many there are.
class WallOverlay {
 public:
  //! `brush`: with the stroke that is being drawn, as it would be kept.
  void paint(QPainter& painter, const SliceGeometry& geometry, double pixelRatio, const WallList& walls,
             const Brush& brush);

 private:
  struct Key {
    QSizeF size;
    QPointF origin, unit;  // of the voxel index, on the screen
    int slice = -1;
    double pixelRatio = 0;
    bool operator==(const Key&) const = default;
  };
  void draw(const std::vector<WallBall>& balls, const SliceGeometry& geometry, double pixelRatio);
  void paintMap(QPainter& painter, const SliceGeometry& geometry, const WallMap& map);

  Key key_;
  QImage picture_;               // of the balls
  std::vector<WallBall> drawn_;  // there
  std::shared_ptr<const std::vector<bool>> map_;
  int mapSlice_ = -1;
  QImage mapPicture_;  // a pixel per voxel
};

}  // namespace handlebody::ui
