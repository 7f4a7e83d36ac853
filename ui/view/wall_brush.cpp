#include "ui/view/wall_brush.h"

#include <algorithm>
#include <cmath>

#include "core/evolution/painted_walls.h"

namespace handlebody::ui {

void WallBrush::setMode(Mode mode) {
  if (mode == mode_) return;
  take();
  mode_ = mode;
  Q_EMIT changed();
}

void WallBrush::setRadius(double radius) {
  radius = std::clamp(radius, lowest_, highest_);
  if (radius == radius_) return;
  radius_ = radius;
  Q_EMIT changed();
}

void WallBrush::startWith(const Grid& grid) {
  take();
  const Vec3 extent = Vec3(grid.size[0], grid.size[1], grid.size[2]).cwiseProduct(grid.spacing);
  mode_ = Mode::off;
  lowest_ = grid.spacing.minCoeff() / 2;
  highest_ = std::max(2 * lowest_, extent.maxCoeff() / 4);
  constexpr double kRound = 2;  // to half a mm where voxels are that large
  const double usual = 3 * grid.meanSpacing(), round = std::round(usual * kRound) / kRound;
  radius_ = std::clamp(round > 0 ? round : usual, lowest_, highest_);
  Q_EMIT changed();
}

void WallBrush::drawTo(const Vec3& place) {
  const std::size_t before = stroke_.size();
  handlebody::drawTo(stroke_, place, radius_);
  if (stroke_.size() != before) Q_EMIT strokeChanged();
}

std::vector<WallBall> WallBrush::take() {
  std::vector<WallBall> drawn;
  drawn.swap(stroke_);
  if (!drawn.empty()) Q_EMIT strokeChanged();
  return drawn;
}

}  // namespace handlebody::ui
