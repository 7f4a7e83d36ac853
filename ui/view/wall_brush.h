#pragma once
// The brush that paints and erases walls in the slices. All slices share it, so that a stroke is seen in each
// while it is drawn.

#include <QObject>
#include <vector>

#include "core/evolution/constraints.h"

namespace handlebody::ui {

class WallBrush : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  enum class Mode { off, paint, erase };

  Mode mode() const { return mode_; }
  //! Ends a stroke that is being drawn, without a trace.
  void setMode(Mode mode);
  bool isOn() const { return mode_ != Mode::off; }
  double radius() const { return radius_; }  //!< mm
  //! Within lowest() and highest().
  void setRadius(double radius);
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  //! Off, and with a radius of three voxels, of which half of one to a quarter of the volume are allowed.
  void startWith(const Grid& grid);

  //! Draws on to a place, mm LPS; the first begins a stroke. Precondition: isOn().
  void drawTo(const Vec3& place);
  //! The stroke that is being drawn; empty: none.
  const std::vector<WallBall>& stroke() const { return stroke_; }
  //! Ends it.
  std::vector<WallBall> take();

 Q_SIGNALS:
  void changed();  //!< mode or radius
  void strokeChanged();

 private:
  Mode mode_ = Mode::off;
  double radius_ = 3, lowest_ = 0.5, highest_ = 100;  // mm
  std::vector<WallBall> stroke_;
};

}  // namespace handlebody::ui
