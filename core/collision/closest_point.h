#pragma once
// The point of a mesh that is nearest to a given one, and on which side of it that lies: a tree of boxes.

#include <limits>
#include <span>
#include <vector>

#include "core/collision/box_tree.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Built in O(n log n), 44 bytes per triangle. Points and triangles must outlive it. Any number of threads
//! may ask at once.
class ClosestPoint {
 public:
  //! Triangles may be degenerate and of any structure; indices must be valid.
  explicit ClosestPoint(const TriangleSoup& mesh);

  //! Distance (mm) of p from the nearest triangle, but for rounding; infinite if there is none. `hint`, if
  //! given, holds the triangle where the search begins (the last answer for a place near by; -1: none) and
  //! gets the nearest one.
  double distance(const Vec3& p, int* hint = nullptr) const;

  //! How often the mesh winds around p, if it is closed and oriented: exact (nesting.h). p must not lie on
  //! it.
  int windingNumber(const Vec3& p) const;

 private:
  static constexpr int kLeafSize = 4;
  struct Node {
    Box box;
    int first, last;  // into order_
    int right;        // the left child follows its parent; 0: a leaf
  };
  int buildNode(std::vector<Vec3>& centres, int first, int last);
  Box boxOf(int triangle) const;
  double squaredTo(const Vec3& p, int triangle) const;

  const TriangleSoup& mesh_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace handlebody
