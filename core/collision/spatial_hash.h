#pragma once
// Finds all pairs of vertices closer than a radius (paper, section 2, Theorem 3) as the paper does: every
// vertex is hashed eight times, for i = (i1,i2,i3) in {0,1}^3, by its box of size l in a grid that is shifted
// by i/2 boxes: Eq. (1); and Eq. (2), r1 p1 + r2 p2 + r3 p3 modulo the table size, which is twice the number
// of vertices. Vertices with the same value are looked at in pairs.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/collision/half_boxes.h"

namespace handlebody {

class SpatialHash {
 public:
  //! Entries of the table per vertex: the paper's choice, section 2.
  static constexpr double kTableSize = 2;
  explicit SpatialHash(double tableSize = kTableSize) : tableSize_(tableSize) {}

  //! Boxes of the vertices, for l somewhat larger than 2 `radius` (mm). False if that makes no sense: as
  //! halfBoxesFor, or if the boxes hold so many vertices each that looking at all pairs of a box would not be
  //! linear any more. The points must stay as they are until the last forEachPair.
  bool build(std::span<const Vec3> points, std::span<const int> vertices, double radius);

  //! Calls f(u, v, squared distance) once for each pair of vertices not farther apart than `radius`.
  template <typename F>
  void forEachPair(F&& f) {
    for (int shift = 0; shift < kFunctions; ++shift) {
      fillTable(shift);
      forEachWithSameValue([&](std::uint32_t i, std::uint32_t j) {
        const double d = (pointOf(i) - pointOf(j)).squaredNorm();
        if (d <= radiusSquared_ && firstSharedBox(i, j) == shift) f(vertices_[i], vertices_[j], d);
      });
    }
  }

  //! Pairs that the eight tables put together, one of them more than once, others by chance.
  std::size_t countCandidates();

 private:
  static constexpr int kFunctions = 8;

  void fillTable(int shift);
  template <typename F>
  void forEachWithSameValue(F&& f) const {
    for (std::size_t value = 0; value + 1 < start_.size(); ++value)
      for (std::uint32_t i = start_[value]; i < start_[value + 1]; ++i)
        for (std::uint32_t j = i + 1; j < start_[value + 1]; ++j) f(order_[i], order_[j]);
  }
  const Vec3& pointOf(std::uint32_t i) const { return points_[vertices_[i]]; }
  int firstSharedBox(std::uint32_t i, std::uint32_t j) const;
  double crowd() const;

  double tableSize_;
  double radiusSquared_ = 0;
  std::span<const Vec3> points_;
  std::vector<int> vertices_;
  std::vector<std::array<int, 3>> halfBoxes_;  // one per vertex, as are the next two
  std::vector<std::uint32_t> value_;           // of the hash function
  std::vector<std::uint32_t> order_;           // by that value
  std::vector<std::uint32_t> start_;           // of each value in `order_`, and the end
};

}  // namespace handlebody
