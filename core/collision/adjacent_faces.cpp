#include "core/collision/adjacent_faces.h"

namespace handlebody {

namespace {

void testStarPairs(const DetectionWorkspace& work, int v, std::vector<FacePair>& found) {
  const auto corners = work.stars.corners(v);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const int f = corners[i].face;
      const int g = corners[j].face;
      if (f != g && work.isWanted(f, g)) work.test(f, g, found);
    }
  }
}

void testStar(DetectionWorkspace& work, StarTest& starTest, int v, std::vector<FacePair>& found) {
  if (work.stars.isCycle(v)) {
    if (!starTest.isEmbedded(work.points, v, work.stars.corners(v), work.sizes[v]))
      testStarPairs(work, v, found);
  } else {
    work.sizes[v] = measureStar(work.points, v, work.stars.corners(v));
    testStarPairs(work, v, found);
  }
}

}  // namespace

void AdjacentFaces::test(DetectionWorkspace& work) {
  starTests_.resize(std::max(starTests_.size(), work.shares()));
  work.findInShares([&](const Share& share, std::vector<FacePair>& found) {
    const auto [from, to] = share.of(work.vertices.size());
    for (std::size_t i = from; i < to; ++i) testStar(work, starTests_[share.part], work.vertices[i], found);
  });
}

}  // namespace handlebody
