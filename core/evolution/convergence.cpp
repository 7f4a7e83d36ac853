#include "core/evolution/convergence.h"

#include <algorithm>

namespace handlebody {

namespace {

constexpr int kUnmovedToStop = 3;         // steps without motion or event
constexpr int kNearlyUnmovedToStop = 40;  // steps in which next to nothing moves and nothing happens
constexpr double kNextToNothing =
    0.001;  // part of the vertices: single ones may tremble between two faces of a noisy voxel

}  // namespace

void Convergence::count(bool isUneventful, int moved, int vertices) {
  unmovedSteps_ = isUneventful && moved == 0 ? unmovedSteps_ + 1 : 0;
  const bool isNearlyUnmoved = moved <= std::max(1.0, kNextToNothing * vertices);
  nearlyUnmovedSteps_ = isUneventful && isNearlyUnmoved ? nearlyUnmovedSteps_ + 1 : 0;
}

bool Convergence::isReached() const {
  return unmovedSteps_ >= kUnmovedToStop || nearlyUnmovedSteps_ >= kNearlyUnmovedToStop;
}

}  // namespace handlebody
