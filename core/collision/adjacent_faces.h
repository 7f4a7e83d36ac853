#pragma once
// Pairs of faces that share a vertex.

#include "core/collision/detection_workspace.h"

namespace handlebody {

//! Keeps the memory of its star test.
class AdjacentFaces {
 public:
  //! Measures the star of v, and tests its faces against each other where a cheap test of all (star_test.h)
  //! does not decide.
  void test(DetectionWorkspace& work, int v);

 private:
  StarTest starTest_;
};

}  // namespace handlebody
