#include "core/collision/crowded_faces.h"

namespace handlebody {

//! Where the moved faces are: only what lies there goes into the tree.
void CrowdedFaces::markCells(const DetectionWorkspace& work) {
  const std::span<const int> moved = work.moved.list();
  double sum = 0;
  for (const int f : moved) {
    const Box box = work.boxOf(f);
    sum += (box.high - box.low).maxCoeff();
  }
  cells_.clear(moved.empty() ? 1 : 2 * sum / static_cast<double>(moved.size()));
  for (const int f : moved) cells_.mark(work.boxOf(f));
}

void CrowdedFaces::test(DetectionWorkspace& work) {
  boxes_.clear();
  faces_.clear();
  if (!work.all) markCells(work);
  for (int f = 0; f < static_cast<int>(work.faces.size()); ++f) {
    if (work.faces[f][0] < 0) continue;
    const Box box = work.boxOf(f);
    if (!work.all && !cells_.mayMeet(box)) continue;
    boxes_.push_back(box);
    faces_.push_back(f);
  }
  tree_.build(boxes_);
  tree_.forEachOverlap([&](int i, int j) {
    const int f = faces_[i];
    const int g = faces_[j];
    if (work.isWanted(f, g) && !shareVertex(work.faces[f], work.faces[g])) work.test(f, g, work.pairs);
  });
}

}  // namespace handlebody
