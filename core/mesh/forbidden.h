#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/geometry/vec.h"
#include "core/mesh/marks.h"

namespace handlebody {

//! Where a surface may not be put, and what of it may not be changed. Empty functions forbid nothing.
struct Forbidden {
  //! True where no face may lie: its three corners, mm.
  std::function<bool(const Vec3&, const Vec3&, const Vec3&)> holds{};
  //! Places in a box (its lowest and highest corner, mm) that no change may carry from one side of the
  //! surface to the other: at least one of each forbidden part that lies wholly in the box.
  std::function<std::vector<Vec3>(const Vec3&, const Vec3&)> places{};
  //! Per vertex slot, 1 if the vertex is neither moved nor removed, nor a face between three such; slots that
  //! it does not reach are free. Null: none is pinned.
  std::shared_ptr<const VertexMarks> pinned{};

  bool isPinned(int v) const {
    const auto slot = static_cast<std::size_t>(v);
    return pinned && slot < pinned->size() && (*pinned)[slot] != 0;
  }
  bool isAnyPinned(std::span<const int> vertices) const {
    return pinned && std::any_of(vertices.begin(), vertices.end(), [this](int v) { return isPinned(v); });
  }
};

}  // namespace handlebody
