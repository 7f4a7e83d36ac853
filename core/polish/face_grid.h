#pragma once
// Which faces of many may meet a box, while faces come and go: hashed cells of as many sizes as the faces
// have.

#include <array>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/collision/box_tree.h"

namespace handlebody {

//! The box of some points, made larger by `by` on all sides.
template <typename Points>
Box boxAround(const Points& points, double by = 0) {
  Box box{points[0], points[0]};
  for (const Vec3& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return {box.low - Vec3::Constant(by), box.high + Vec3::Constant(by)};
}

class FaceGrid {
 public:
  void add(int face, const Box& box);
  //! Precondition: added with this box.
  void remove(int face, const Box& box);
  //! Replaces `found` by the faces whose boxes overlap the given one (and maybe some that do not), ascending.
  void findNear(const Box& box, std::vector<int>& found) const;

 private:
  using Cell = std::array<int, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const;
  };
  using Cells = std::unordered_map<Cell, std::vector<int>, Hash>;
  struct Range {
    Cell low, high;
    double count() const;
  };
  static int levelOf(const Box& box);
  static Range rangeOf(const Box& box, int level);
  template <typename F>
  static void forEachCell(const Range& range, F&& f);

  std::map<int, Cells> levels_;  // by the power of two that is their cells' size
};

}  // namespace handlebody
