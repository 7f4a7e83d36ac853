#include "ui/view/brush.h"

#include <algorithm>
#include <cmath>

#include "core/evolution/painted_walls.h"

namespace handlebody::ui {

void Brush::setMode(Mode mode) {
  if (mode == mode_) return;
  take();
  setPull(std::nullopt);
  mode_ = mode;
  Q_EMIT changed();
}

void Brush::setRadius(double radius) {
  radius = std::clamp(radius, lowest_, highest_);
  if (radius == radius_) return;
  radius_ = radius;
  Q_EMIT changed();
}

void Brush::turnWheel(double notches) {
  constexpr double kNotch = 1.1;
  setRadius(radius_ * std::pow(kNotch, notches));
}

void Brush::startWith(const Grid& grid) {
  take();
  setPull(std::nullopt);
  const Vec3 extent = Vec3(grid.size[0], grid.size[1], grid.size[2]).cwiseProduct(grid.spacing);
  mode_ = Mode::off;
  lowest_ = grid.spacing.minCoeff() / 2;
  highest_ = std::max(2 * lowest_, extent.maxCoeff() / 4);
  constexpr double kRound = 2;  // to half a mm where voxels are that large
  const double usual = 3 * grid.meanSpacing(), round = std::round(usual * kRound) / kRound;
  radius_ = std::clamp(round > 0 ? round : usual, lowest_, highest_);
  Q_EMIT changed();
}

void Brush::drawTo(const Vec3& place) {
  const std::size_t before = stroke_.size();
  handlebody::drawTo(stroke_, place, radius_);
  if (stroke_.size() != before) Q_EMIT strokeChanged();
}

void Brush::jumpTo(const Vec3& place) {
  stroke_.push_back({place, radius_});
  Q_EMIT strokeChanged();
}

void Brush::setPull(const std::optional<Pull>& pull) {
  if (!pull && !pull_) return;
  pull_ = pull;
  Q_EMIT strokeChanged();
}

std::vector<WallBall> Brush::take() {
  std::vector<WallBall> drawn;
  drawn.swap(stroke_);
  if (!drawn.empty()) Q_EMIT strokeChanged();
  return drawn;
}

}  // namespace handlebody::ui
