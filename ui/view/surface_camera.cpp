#include "ui/view/surface_camera.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "ui/model/document.h"
#include "ui/view/other_surfaces.h"

namespace handlebody::ui {

SurfaceCamera::SurfaceCamera(const QWidget& view) : view_(view) {
  flight_.setStartValue(0.0);
  flight_.setEndValue(1.0);
  flight_.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&flight_, &QVariantAnimation::finished, this, &SurfaceCamera::arrived);
  connect(&flight_, &QVariantAnimation::valueChanged, this, [this](const QVariant& share) {
    scene_->setPose(between(from_, to_, share.toDouble()));
    Q_EMIT moved();
  });
}

void SurfaceCamera::startVolume(const Grid* grid) {
  follows_ = true;
  const auto camera = std::exchange(wanted_, std::nullopt);
  if (!scene_) return;
  flight_.stop();
  scene_->setPose(grid ? around(*grid, obliquePose(), aspect()) : obliquePose());
  if (camera) stand(*camera);
}

CameraPose SurfaceCamera::destination() const { return isFlying() ? to_ : pose(); }

void SurfaceCamera::flyTo(const CameraPose& pose) {
  flight_.stop();
  const int time =
      flightTime_ >= 0 ? flightTime_ : 2 * view_.style()->styleHint(QStyle::SH_Widget_Animation_Duration);
  if (time <= 0 || !view_.isVisible()) {
    scene_->setPose(pose);
    Q_EMIT moved();
    return;
  }
  from_ = scene_->pose();
  to_ = pose;
  flight_.setDuration(time);
  flight_.start();
}

void SurfaceCamera::takeInHand() {
  flight_.stop();
  follows_ = false;
}

void SurfaceCamera::zoom(double factor) {
  CameraPose nearer = pose();
  nearer.height /= factor;
  scene_->setPose(nearer);
  Q_EMIT moved();
}

//! Not at every step: a camera that moves all the time hides the growth.
void SurfaceCamera::follow(const Document& document) {
  constexpr double kMargin = 2.2, kTooSmall = 5, kTooLarge = 1.05;  // heights of view per mesh
  constexpr double kAtRest = 1.25, kFarAtRest = 1.6;                // and where nothing grows any more
  if (!document.snapshot() || !follows_ || isFlying()) return;
  const std::optional<Sight> sight = sightOfSurfaces(document);
  if (!sight) return;
  CameraPose pose = scene_->pose();
  const double offset = (sight->centre - pose.focus).norm();
  const bool atRest = document.state() == GrowthState::finished;
  if (pose.height < heightFor(*sight, atRest ? kFarAtRest : kTooSmall) &&
      pose.height > heightFor({sight->centre, sight->radius + offset}, kTooLarge))
    return;
  pose.focus = sight->centre;
  pose.height = heightFor(*sight, atRest ? kAtRest : kMargin);
  flyTo(pose);
}

void SurfaceCamera::seeAll(const Document& document) {
  constexpr double kMargin = 1.25;
  const std::optional<Sight> sight = sightOfSurfaces(document);
  CameraPose pose = scene_->pose();
  if (sight) {
    pose.focus = sight->centre;
    pose.height = heightFor(*sight, kMargin);
  } else {
    pose = around(document.volume().grid, pose, aspect());
  }
  follows_ = true;
  flyTo(pose);
}

void SurfaceCamera::stand(const StandingCamera& camera) {
  if (!scene_) {
    wanted_ = camera;
    return;
  }
  flight_.stop();
  follows_ = camera.follows;
  scene_->setPose(camera.pose);
  Q_EMIT moved();
}

std::optional<StandingCamera> SurfaceCamera::standing() const {
  if (!scene_) return wanted_;
  return StandingCamera{destination(), follows_};
}

double SurfaceCamera::heightFor(const Sight& sight, double margin) const {
  return margin * 2 * sight.radius / std::min(1.0, aspect());
}

double SurfaceCamera::aspect() const {
  return std::max(1, view_.width()) / std::max(1.0, static_cast<double>(view_.height()));
}

}  // namespace handlebody::ui
