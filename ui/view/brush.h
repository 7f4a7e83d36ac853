#pragma once
// The brush: a ball that paints and erases walls in the slices, pins and smooths the surface, in slices and
// in 3D, pulls it by a point, and cuts it along a line drawn in a slice. All views share it, so that a stroke
// is seen in each while it is drawn.

#include <QObject>
#include <optional>
#include <vector>

#include "core/evolution/constraints.h"

namespace handlebody::ui {

class Brush : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  enum class Mode { off, paintWalls, eraseWalls, pin, unpin, smooth, pull, cut };
  //! A point of the surface that is being pulled, and where to, or the ends of the line of a cut; mm LPS.
  struct Pull {
    Vec3 from, to;
  };

  Mode mode() const { return mode_; }
  //! Ends a stroke that is being drawn, without a trace.
  void setMode(Mode mode);
  bool isOn() const { return mode_ != Mode::off; }
  bool isForWalls() const { return mode_ == Mode::paintWalls || mode_ == Mode::eraseWalls; }
  //! On, and not for walls.
  bool isForSurface() const { return isOn() && !isForWalls(); }
  //! On, and of use in 3D.
  bool isFor3d() const { return isForSurface() && mode_ != Mode::cut; }
  double radius() const { return radius_; }  //!< mm
  //! Within lowest() and highest().
  void setRadius(double radius);
  //! By so many notches of a wheel; parts of one count.
  void turnWheel(double notches);
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  //! Off, and with a radius of three voxels, of which half of one to a quarter of the volume are allowed.
  void startWith(const Grid& grid);

  //! Draws on to a place, mm LPS; the first begins a stroke. Precondition: isOn().
  void drawTo(const Vec3& place);
  //! Goes on there without anything between.
  void jumpTo(const Vec3& place);
  //! The stroke that is being drawn; empty: none.
  const std::vector<WallBall>& stroke() const { return stroke_; }
  //! Ends it.
  std::vector<WallBall> take();

  void setPull(const std::optional<Pull>& pull);
  const std::optional<Pull>& pull() const { return pull_; }

 Q_SIGNALS:
  void changed();        //!< mode or radius
  void strokeChanged();  //!< or the pull

 private:
  Mode mode_ = Mode::off;
  double radius_ = 3, lowest_ = 0.5, highest_ = 100;  // mm
  std::vector<WallBall> stroke_;
  std::optional<Pull> pull_;
};

}  // namespace handlebody::ui
