#pragma once
// What of a growth binds what is done to its surface afterwards.

#include <vector>

#include "core/evolution/active_contour.h"

namespace handlebody {

struct GrownUnder {
  Grid grid{};
  WallList walls{};
  double edgeLength = 0;  //!< mm
  std::vector<PinnedPart> pinned{};
};

inline GrownUnder grownUnder(const ActiveContour& contour) {
  return {contour.grid(), contour.constraints().walls, contour.parameters().edgeLength, contour.pinned()};
}

}  // namespace handlebody
