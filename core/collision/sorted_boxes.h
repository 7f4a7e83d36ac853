#pragma once
// Finds all pairs of vertices closer than a radius in linear time: the same as the paper's eight hash
// functions (spatial_hash.h), in one table.
//
// The vertices are sorted once, by the half boxes floor(2a/l) of size l/2: every box of the eight functions
// is a block of 2×2×2 half boxes (boxIndex in half_boxes.h), so two vertices share a box of at least one
// function exactly if their half boxes are equal or neighbours along each axis. Visiting the neighbours finds
// each such pair once, where the eight tables find it up to eight times.
//
// The place of a half box is not its hash modulo a table size but its rank among those that hold anything: by
// a counting sort along x, y and z. Rows of half boxes along x are then met in the order of memory, and the
// rows beside them as well, so that a large mesh costs as much per vertex as a small one; and no two half
// boxes are ever taken for one another.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/collision/half_boxes.h"
#include "core/collision/lanes.h"
#include "core/geometry/vec.h"
#include "core/threads.h"

namespace handlebody {

class SortedBoxes {
 public:
  //! Sorts the vertices in `vertices` by half boxes somewhat larger than `radius` (mm). False if that makes
  //! no sense: radius is not positive, the half boxes cannot be numbered, or they hold so many vertices each
  //! (a mesh with very uneven edges) that visiting neighbours would not be linear any more; see kCrowd.
  //! The points must stay as they are until the last forEachPair.
  bool build(std::span<const Vec3> points, std::span<const int> vertices, double radius);

  //! Calls f(u, v, squared distance) once for each pair of vertices not farther apart than `radius`. All
  //! shares together have all of them.
  template <typename F>
  void forEachPair(F&& f, const Share& share = {}) const;

 private:
  // The sum of squares of the numbers of vertices in the half boxes may be this many times the number of
  // vertices. By Cauchy-Schwarz, visiting all neighbours then looks at no more than 27/2 times as many pairs.
  // A mesh with edges between s/3 and s stays below 8.
  static constexpr double kCrowd = 24;

  struct Entry {
    int vertex;
    std::array<int, 3> box;  // half box
  };
  //! Half boxes (x, y, z) that hold a vertex, all x.
  struct BoxRow {
    int y, z;
    std::uint32_t first;  // up to the next row's
    bool operator<(const BoxRow& o) const { return z != o.z ? z < o.z : y < o.y; }
    bool operator==(const BoxRow& o) const { return z == o.z && y == o.y; }
  };
  //! Vertices of a row that are still ahead.
  struct Window {
    std::uint32_t next, end;
  };
  //! Of the own row what comes after, and the rows (y+1, z), (y-1, z+1), (y, z+1), (y+1, z+1): one of two
  //! neighbours has the other there.
  using Windows = std::array<Window, 5>;

  void sortAlong(std::size_t axis, int most);
  double listRows();
  void placePoints(const HalfBoxes& boxes);
  Window windowOf(std::size_t row, const BoxRow& wanted) const {
    return rows_[row] == wanted ? Window{rows_[row].first, rows_[row + 1].first} : Window{0, 0};
  }
  template <typename F>
  void visit(std::uint32_t own, Windows& windows, F&& f) const;
  template <typename F>
  void visitRest(std::uint32_t own, std::uint32_t first, std::uint32_t last, F&& f) const;
  template <typename F>
  void handPair(std::uint32_t own, std::uint32_t other, F&& f) const {
    const auto u = static_cast<std::size_t>(vertex_[own]), v = static_cast<std::size_t>(vertex_[other]);
    const double d = (points_[v] - points_[u]).squaredNorm();
    if (d <= radiusSquared_) f(vertex_[own], vertex_[other], d);
  }
  std::array<float, 3> placeOf(std::uint32_t i) const { return {at_[0][i], at_[1][i], at_[2][i]}; }
  LaneBits near(const std::array<float, 3>& centre, const Window& w) const {
    return lanesWithin(&at_[0][w.next], &at_[1][w.next], &at_[2][w.next], centre, rejectBeyond_,
                       static_cast<std::int32_t>(w.end - w.next));
  }

  double radiusSquared_ = 0;
  float rejectBeyond_ = 0;  // squared, in half boxes
  std::span<const Vec3> points_;
  std::vector<Entry> entries_, scratch_;  // while they are sorted
  std::vector<std::uint32_t> start_;
  std::vector<BoxRow> rows_;  // in order; three more at the end, beyond all
  std::vector<int> vertex_, x_;
  //! Coordinates in half boxes from the lower corner of all, rounded: for rejection only. kLanes more at the
  //! end.
  std::array<std::vector<float>, 3> at_;
};

template <typename F>
void SortedBoxes::visitRest(std::uint32_t own, std::uint32_t first, std::uint32_t last, F&& f) const {
  const std::array<float, 3> centre = placeOf(own);
  for (std::uint32_t i = first; i < last && x_[i] <= x_[own] + 1; i += kLanes)
    for (unsigned bits = anyLane(near(centre, {i, last}) & LaneBits{1, 2, 4, 8}); bits != 0; bits &= bits - 1)
      handPair(own, i + static_cast<std::uint32_t>(std::countr_zero(bits)), f);
}

//! The windows move on with the vertices of the own row. What lies beyond the neighbouring half boxes, but in
//! the same row, is farther than the radius.
template <typename F>
void SortedBoxes::visit(std::uint32_t own, Windows& windows, F&& f) const {
  const int previous = x_[own] - 1;
  windows[0].next = own + 1;
  for (std::size_t k = 1; k < windows.size(); ++k)
    while (windows[k].next < windows[k].end && x_[windows[k].next] < previous) ++windows[k].next;
  const std::array<float, 3> centre = placeOf(own);
  LaneBits all = near(centre, windows[0]) & LaneBits{1, 2, 4, 8};
  all |= near(centre, windows[1]) & (LaneBits{1, 2, 4, 8} << 4);
  all |= near(centre, windows[2]) & (LaneBits{1, 2, 4, 8} << 8);
  all |= near(centre, windows[3]) & (LaneBits{1, 2, 4, 8} << 12);
  all |= near(centre, windows[4]) & (LaneBits{1, 2, 4, 8} << 16);
  static_assert(kLanes == 4);
  for (unsigned bits = anyLane(all); bits != 0; bits &= bits - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
    handPair(own, windows[bit / kLanes].next + bit % kLanes, f);
  }
  for (const Window& w : windows)
    if (w.end > w.next + kLanes) visitRest(own, w.next + kLanes, w.end, f);
}

template <typename F>
void SortedBoxes::forEachPair(F&& f, const Share& share) const {
  const auto [begin, end] = share.of(vertex_.size());
  const auto firstFrom = [this](std::size_t i) {  // the first row that does not begin before the vertex i
    return static_cast<std::size_t>(
        std::partition_point(rows_.begin(), rows_.end(), [i](const BoxRow& row) { return row.first < i; }) -
        rows_.begin());
  };
  std::size_t above = 0;  // the first row that does not come before (y-1, z+1)
  for (std::size_t r = firstFrom(begin); rows_[r].first < end; ++r) {
    const BoxRow& row = rows_[r];
    while (rows_[above] < BoxRow{row.y - 1, row.z + 1, 0}) ++above;
    Windows windows{Window{row.first, rows_[r + 1].first}, windowOf(r + 1, {row.y + 1, row.z, 0})};
    std::size_t next = above;
    for (std::size_t k = 2; k < windows.size(); ++k) {
      windows[k] = windowOf(next, {row.y + static_cast<int>(k) - 3, row.z + 1, 0});
      next += windows[k].end != 0;
    }
    for (std::uint32_t i = row.first; i < rows_[r + 1].first; ++i) visit(i, windows, f);
  }
}

}  // namespace handlebody
