#include "core/collision/detection_workspace.h"

#include <cmath>

#include "core/collision/vertex_levels.h"

namespace handlebody {

double DetectionWorkspace::reach() const {
  return std::sqrt(longestSquared * VertexLevels::kReachSquared) * kRounding;
}

bool DetectionWorkspace::areLevelsWorth() {
  starSizes.clear();
  for (const int v : vertices) {
    starSizes.push_back(sizeSquared(v));
    longestSquared = std::max(longestSquared, starSizes.back());
  }
  return VertexLevels::areWorth(starSizes, longestSquared);
}

}  // namespace handlebody
