#pragma once
// Finds all pairs of vertices closer than a radius (paper, section 2, Theorem 3), in linear time.
//
// The paper hashes every vertex eight times, for i = (i1,i2,i3) in {0,1}³, by its box of size l in a grid
// that is shifted by i/2 boxes: Eq. (1), read as the integer r(a,i) = floor(a/l + i/2), and Eq. (2), r1·p1 +
// r2·p2
// + r3·p3 modulo the table size. Here the vertices are sorted once, by the half boxes floor(2a/l) of size
// l/2: every box of the eight functions is a block of 2×2×2 half boxes (boxIndex below), so two vertices
// share a box of at least one function exactly if their half boxes are equal or neighbours along each axis.
// Visiting the neighbours finds each such pair once, where the eight tables find it up to eight times.
//
// p1 is 1, not a prime: half boxes that follow each other along x are then neighbours in the table, and the
// three of one row are one piece of memory.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/collision/lanes.h"
#include "core/geometry/vec.h"

namespace handlebody {

class SpatialHash {
 public:
  //! Eq. (1): floor(a/l + i/2) for i in {0,1}, given the half box floor(2a/l).
  static int boxIndex(int halfBox, int i) { return (halfBox + i) >> 1; }

  //! Sorts the vertices in `vertices` by half boxes somewhat larger than `radius` (mm). False if that makes
  //! no sense: radius is not positive, the half boxes cannot be numbered, or they hold so many vertices each
  //! (a mesh with very uneven edges) that visiting neighbours would not be linear any more; see kCrowd.
  //! The points must stay as they are until the last forEachPair.
  bool build(std::span<const Vec3> points, std::span<const int> vertices, double radius);

  //! Calls f(u, v, squared distance) once for each pair of vertices not farther apart than `radius`.
  template <typename F>
  void forEachPair(F&& f) const;

 private:
  // The sum of squares of the bucket sizes may be this many times the number of vertices. By Cauchy-Schwarz,
  // visiting all neighbours then looks at no more than 27/2 times as many pairs. A mesh with edges between
  // s/3 and s stays below 8.
  static constexpr double kCrowd = 24;

  struct Entry {
    int vertex;
    int x, y, z;  // half box
  };
  //! Coordinates in half boxes from the lower corner of all, rounded: for rejection only.
  using Coordinates = std::array<std::vector<float>, 3>;

  std::uint32_t bucket(int x, int y, int z) const {
    return (static_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(y) * 73856093u +
            static_cast<std::uint32_t>(z) * 83492791u) &
           mask_;
  }
  void sortByBucket(std::size_t count);
  //! Calls f for the entries of half boxes (x-1..x+1, y, z) within the radius of entry e.
  template <typename F>
  void visitRow(std::uint32_t e, int y, int z, F&& f) const;
  //! Calls f for the entries from `first` to before `last` that belong to that row.
  template <typename F>
  void visitEntries(std::uint32_t first, std::uint32_t last, std::uint32_t e, int y, int z, F&& f) const;

  std::uint32_t mask_ = 0;
  double radiusSquared_ = 0;
  float rejectBeyond_ = 0;  // squared, in half boxes
  std::span<const Vec3> points_;
  std::vector<std::uint32_t> start_;  // per bucket, into entries_; one more at the end
  std::vector<Entry> entries_, unsorted_;
  Coordinates at_, unsortedAt_;  // of the entries; kLanes more at the end, far away
};

template <typename F>
void SpatialHash::visitEntries(std::uint32_t first, std::uint32_t last, std::uint32_t e, int y, int z,
                               F&& f) const {
  const std::array<float, 3> centre{at_[0][e], at_[1][e], at_[2][e]};
  const Entry& own = entries_[e];
  for (std::uint32_t i = first; i < last; i += kLanes) {
    unsigned near = lanesWithin(&at_[0][i], &at_[1][i], &at_[2][i], centre, rejectBeyond_);
    near &= (2u << std::min(last - i - 1, kLanes - 1)) - 1;
    for (; near != 0; near &= near - 1) {
      const Entry& other = entries_[i + static_cast<std::uint32_t>(std::countr_zero(near))];
      // Different rows may share buckets: only the one that is being visited counts.
      if (other.y != y || other.z != z || other.x - own.x > 1 || own.x - other.x > 1) continue;
      const double d =
          (points_[static_cast<std::size_t>(other.vertex)] - points_[static_cast<std::size_t>(own.vertex)])
              .squaredNorm();
      if (d <= radiusSquared_) f(own.vertex, other.vertex, d);
    }
  }
}

template <typename F>
void SpatialHash::visitRow(std::uint32_t e, int y, int z, F&& f) const {
  const std::uint32_t first = bucket(entries_[e].x - 1, y, z);
  if (first + 2 <= mask_) {
    visitEntries(start_[first], start_[first + 3], e, y, z, f);
    return;
  }
  for (std::uint32_t i = 0; i < 3; ++i) {  // the row goes on at the beginning of the table
    const std::uint32_t b = (first + i) & mask_;
    visitEntries(start_[b], start_[b + 1], e, y, z, f);
  }
}

template <typename F>
void SpatialHash::forEachPair(F&& f) const {
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    const Entry& e = entries_[i];
    // In its own row an entry looks forward only: at the rest of its bucket and at the next half box.
    const std::uint32_t own = bucket(e.x, e.y, e.z);
    if (own < mask_) {
      visitEntries(i + 1, start_[own + 2], i, e.y, e.z, f);
    } else {
      visitEntries(i + 1, start_[own + 1], i, e.y, e.z, f);
      visitEntries(start_[0], start_[1], i, e.y, e.z, f);
    }
    visitRow(i, e.y + 1, e.z, f);
    for (int dy = -1; dy <= 1; ++dy) visitRow(i, e.y + dy, e.z + 1, f);
  }
}

}  // namespace handlebody
