#include "core/object/displacement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;

Vec3 placeOf(const CellGrid& cells, const Cell& c) {
  return Vec3(c[0], c[1], c[2]).cwiseProduct(cells.grid.spacing);
}

//! Shortest paths from the side of a region that moves, in a box. A step across an edge is as long as more.
class Paths {
 public:
  Paths(const WorkImage& work, const Region& from, const CellBox& box, const Displacement& d)
      : work_(work),
        box_(box),
        limit_(d.height),
        edge_(d.edge),
        length_(box.count(), std::numeric_limits<float>::infinity()) {
    forBox(box, [&](const Cell& c) {
      if (isOn(from, c, d.isInside)) length_[box.at(c)] = 0;
    });
    forBox(box, [&](const Cell& c) {
      if (length_[box.at(c)] == 0) goOnFrom(c);
    });
    while (!queue_.empty()) {
      const auto [length, c] = queue_.top();
      queue_.pop();
      if (length <= length_[box.at(c)]) goOnFrom(c);
    }
  }
  //! mm; infinite beyond the height of the bell.
  float to(const Cell& c) const { return length_[box_.at(c)]; }

 private:
  using Entry = std::pair<float, Cell>;

  bool isOn(const Region& from, const Cell& c, bool isInside) const {
    return (from.inside[work_.cells().at(c)] != 0) == isInside;
  }
  void goOnFrom(const Cell& c) {
    const double so = length_[box_.at(c)];
    forBox({{c[0] - 1, c[1] - 1, c[2] - 1}, {c[0] + 1, c[1] + 1, c[2] + 1}}, [&](const Cell& n) {
      if (!box_.holds(n) || length_[box_.at(n)] <= so) return;
      const auto there = static_cast<float>(so + step(c, n));
      if (there > limit_ || there >= length_[box_.at(n)]) return;
      length_[box_.at(n)] = there;
      queue_.push({there, n});
    });
  }
  double step(const Cell& a, const Cell& b) const {
    const CellGrid& cells = work_.cells();
    const double length = (placeOf(cells, a) - placeOf(cells, b)).norm();
    if (edge_ <= 0) return length;
    const double jump = (work_.values[cells.at(a)] - work_.values[cells.at(b)]) / edge_;
    return length * (1 + jump * jump);
  }

  const WorkImage& work_;
  CellBox box_;
  double limit_, edge_;
  std::vector<float> length_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

Region displaced(const WorkImage& work, const Region& from, Region region, const Displacement& d) {
  const CellGrid& cells = work.cells();
  const double least = 0.5 * cells.grid.meanSpacing();
  if (d.height <= least) return region;
  const Cell centre = cells.cellOf(d.click.cell);
  const Vec3 middle = placeOf(cells, centre);
  const double reach = d.width * std::sqrt(2 * std::log(d.height / least));
  const CellBox box = boxAround(cells, centre, reach + d.height);
  const Paths paths(work, from, box, d);
  std::vector<Vec3> against;
  for (const CellClick& c : d.against) against.push_back(placeOf(cells, cells.cellOf(c.cell)));
  forBox(box, [&](const Cell& c) {
    const Vec3 at = placeOf(cells, c);
    const double r = (at - middle).squaredNorm();
    if (r > reach * reach) return;
    if (paths.to(c) > d.height * std::exp(-r / (2 * d.width * d.width))) return;
    if (std::any_of(against.begin(), against.end(),
                    [&](const Vec3& a) { return (at - a).squaredNorm() < r; }))
      return;
    region.inside[cells.at(c)] = d.isInside;
  });
  return region;
}

}  // namespace handlebody
