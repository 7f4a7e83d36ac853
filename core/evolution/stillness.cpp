#include "core/evolution/stillness.h"

#include <algorithm>

namespace handlebody {

namespace {

constexpr int kQuietToStop = 3;   // steps without motion or event
constexpr int kStillToStop = 40;  // steps in which next to nothing moves and nothing happens
constexpr double kNextToNothing =
    0.001;  // part of the vertices: single ones may tremble between two faces of a noisy voxel

}  // namespace

void Stillness::count(bool calm, int moved, int vertices) {
  quiet_ = calm && moved == 0 ? quiet_ + 1 : 0;
  const bool isNearlyStill = moved <= std::max(1.0, kNextToNothing * vertices);
  nearlyStill_ = calm && isNearlyStill ? nearlyStill_ + 1 : 0;
}

bool Stillness::isAtRest() const { return quiet_ >= kQuietToStop || nearlyStill_ >= kStillToStop; }

}  // namespace handlebody
