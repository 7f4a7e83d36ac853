#pragma once
// Pairs of faces without a common vertex, by way of their boxes: for meshes whose vertices are too crowded.

#include <vector>

#include "core/collision/box_tree.h"
#include "core/collision/detection_workspace.h"
#include "core/collision/marked_cells.h"

namespace handlebody {

//! Keeps its tables.
class CrowdedFaces {
 public:
  void test(DetectionWorkspace& work);

 private:
  void markCells(const DetectionWorkspace& work);

  BoxTree tree_;
  MarkedCells cells_;  // that moved faces meet
  std::vector<Box> boxes_;
  std::vector<int> faces_;  // of the boxes
};

}  // namespace handlebody
