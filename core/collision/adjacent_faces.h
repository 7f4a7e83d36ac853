#pragma once
// Pairs of faces that share a vertex.

#include <vector>

#include "core/collision/detection_workspace.h"

namespace handlebody {

//! Keeps the memory of its star tests.
class AdjacentFaces {
 public:
  //! Measures the stars of work.vertices, and tests the faces of each against each other where a cheap test
  //! of all (star_test.h) does not decide.
  void test(DetectionWorkspace& work);

 private:
  std::vector<StarTest> starTests_;  // one for each share
};

}  // namespace handlebody
