#pragma once
// The broad phase of the detection: which vertices are near each other. Two ways, the same pairs.

#include <utility>

#include "core/collision/broad_phase.h"
#include "core/collision/sorted_boxes.h"
#include "core/collision/spatial_hash.h"
#include "core/threads.h"

namespace handlebody {

class VertexPairs {
 public:
  void use(BroadPhase phase) { phase_ = phase; }

  //! False if it makes no sense: the radius (mm) is not positive, or vertices are so crowded that it would
  //! not be linear. The points must stay as they are until the last forEachPair.
  bool build(std::span<const Vec3> points, std::span<const int> vertices, double radius) {
    return phase_ == BroadPhase::sorted ? sorted_.build(points, vertices, radius)
                                        : hash_.build(points, vertices, radius);
  }

  //! Calls f(u, v, squared distance) once for each pair of vertices not farther apart than `radius`, in
  //! either order. All shares together have all of them, and may be asked for at the same time; with hashing
  //! the first has all.
  template <typename F>
  void forEachPair(F&& f, const Share& share = {}) {
    if (phase_ == BroadPhase::sorted)
      sorted_.forEachPair(std::forward<F>(f), share);
    else if (share.part == 0)
      hash_.forEachPair(std::forward<F>(f));
  }

 private:
  BroadPhase phase_ = BroadPhase::sorted;
  SortedBoxes sorted_;
  SpatialHash hash_;
};

}  // namespace handlebody
