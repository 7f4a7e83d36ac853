#pragma once
// The homology class of a loop on a closed connected surface, and whether it bounds inside or outside.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/tree_cotree.h"

namespace handlebody {

//! Which side of the surface a loop bounds on (T. K. Dey, K. Li, J. Sun, "On computing handle and tunnel
//! loops", 2007): a handle loop runs around a handle and bounds in the body; a tunnel loop runs round a
//! tunnel and bounds outside of it.
//! `neither`: along a knotted handle or tunnel, where it winds around that as well, or both in one.
enum class LoopKind : unsigned char { handle, tunnel, neither };

//! Two numbers of a class: the first is 0 if it is that of a handle loop, the second if it is that of a
//! tunnel loop, both only if it bounds on the surface. They add up along a path, modulo 2^64. By chance (one
//! in 2^63) a number may be 0 without that; who must be sure asks isOfKind.
struct ClassKey {
  std::uint64_t outer = 0, inner = 0;
  ClassKey& operator+=(const ClassKey& o) {
    outer += o.outer;
    inner += o.inner;
    return *this;
  }
  ClassKey& operator-=(const ClassKey& o) {
    outer -= o.outer;
    inner -= o.inner;
    return *this;
  }
  bool operator==(const ClassKey&) const = default;
};

class LoopClasses {
 public:
  //! None if the linking of the generators cannot be told (see outerProjection). Precondition: closed,
  //! connected, without free slots.
  static std::optional<LoopClasses> of(const Mesh& mesh);

  int rank() const { return rank_; }  //!< 2g
  const ClassKey& key(int halfedge) const { return keys_[halfedge]; }
  //! Adds the coordinates of a half-edge to those of a class: `rank` numbers.
  void addTo(std::span<std::int64_t> coordinates, int halfedge) const;
  //! Exactly; the kind is handle or tunnel.
  bool isOfKind(std::span<const std::int64_t> coordinates, LoopKind kind) const;
  //! Algebraic intersection number of two classes, but for the sign. Precondition: its magnitude is below
  //! 2^30.
  std::int64_t intersections(std::span<const std::int64_t> a, std::span<const std::int64_t> b) const;

 private:
  struct Crossing {
    int loop, sign;
  };
  void setCrossings(const Mesh& mesh, const TreeCotree& trees);
  void setKeys(const Mesh& mesh);
  bool setIntersections(const Mesh& mesh, const TreeCotree& trees);
  std::span<const Crossing> crossings(int halfedge) const;

  int rank_ = 0;
  std::vector<int> projection_;     // see outerProjection
  std::vector<std::size_t> first_;  // per half-edge: where its crossings with dual loops begin
  std::vector<Crossing> crossings_;
  std::vector<ClassKey> keys_;              // per half-edge
  std::vector<std::int64_t> intersection_;  // of the primal loops, modulo a prime
};

}  // namespace handlebody
