#include "core/collision/adjacent_faces.h"

namespace handlebody {

namespace {

void testStarPairs(DetectionWorkspace& work, int v) {
  const auto corners = work.stars.corners(v);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const int f = corners[i].face;
      const int g = corners[j].face;
      if (f != g && work.isWanted(f, g)) work.test(f, g);
    }
  }
}

}  // namespace

void AdjacentFaces::test(DetectionWorkspace& work, int v) {
  if (work.stars.isCycle(v)) {
    if (!starTest_.isEmbedded(work.points, v, work.stars.corners(v), work.sizes[v])) testStarPairs(work, v);
  } else {
    work.sizes[v] = measureStar(work.points, v, work.stars.corners(v));
    testStarPairs(work, v);
  }
}

}  // namespace handlebody
