#include "core/evolution/size_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/object/distance.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;

constexpr int kMaxVoxels = 8;  // of a cell, along an axis
// The boundary lies less than a voxel's diagonal beside a voxel that is not of the object, and that within
// its cell: from the cell's middle half a diagonal of each. Between the middles of cells distances are up to
// a quarter of a cell too large.
constexpr double kHalfDiagonal = 0.87, kTooLarge = 0.25;
// Edge lengths from the boundary up to which edges are not longer: more than a step, and than what the mean
// over the surface around moves the boundary.
constexpr double kNear = 0.5;

//! The cells of a volume, and which of them hang together in the object.
class CellFlood {
 public:
  CellFlood(const ObjectImage& image, double edgeLength) : image_(image), voxels_(image.volume().grid()) {
    cells_.direction = voxels_.direction;
    Vec3 middle;
    for (int a = 0; a < 3; ++a) {
      const double wanted = std::round(edgeLength / voxels_.spacing[a]);
      perCell_[a] = static_cast<int>(std::clamp<double>(wanted, 1, kMaxVoxels));
      cells_.size[a] = (voxels_.size[a] + perCell_[a] - 1) / perCell_[a];
      cells_.spacing[a] = voxels_.spacing[a] * perCell_[a];
      middle[a] = 0.5 * (perCell_[a] - 1);
    }
    cells_.origin = voxels_.toWorld(middle);
    states_.assign(cells_.voxelCount(), State::unknown);
  }

  void from(const Vec3& world) {
    const Vec3 index = cells_.toIndex(world);
    Cell c;
    for (int a = 0; a < 3; ++a)
      c[a] = static_cast<int>(std::clamp<double>(std::round(index[a]), 0, cells_.size[a] - 1.0));
    visit(c);
    while (!front_.empty()) {
      if (front_.size() % 4096 == 0) giveUpIfCancelled();
      const Cell next = front_.back();
      front_.pop_back();
      for (std::size_t a = 0; a < 3; ++a)
        for (const int step : {-1, 1}) {
          Cell n = next;
          n[a] += step;
          if (n[a] >= 0 && n[a] < cells_.size[a]) visit(n);
        }
    }
  }

  bool isEmpty() const { return low_[0] > high_[0]; }
  //! The cells in the box of those found and one more on every side.
  Grid box() const {
    Grid grid = cells_;
    Vec3 corner;
    for (std::size_t a = 0; a < 3; ++a) {
      grid.size[a] = high_[a] - low_[a] + 3;
      corner[static_cast<int>(a)] = low_[a] - 1;
    }
    grid.origin = cells_.toWorld(corner);
    return grid;
  }
  //! Of those in box(): 1 where the object does not go on.
  std::vector<std::uint8_t> ends() const {
    const Cell size = box().size;
    std::vector<std::uint8_t> out(idx(size[0]) * idx(size[1]) * idx(size[2]), 1);
    for (int k = low_[2]; k <= high_[2]; ++k)
      for (int j = low_[1]; j <= high_[1]; ++j)
        for (int i = low_[0]; i <= high_[0]; ++i)
          if (states_[at({i, j, k})] == State::inside)
            out[(idx(k - low_[2] + 1) * idx(size[1]) + idx(j - low_[1] + 1)) * idx(size[0]) +
                idx(i - low_[0] + 1)] = 0;
    return out;
  }

 private:
  enum class State : std::uint8_t { unknown, inside, ends };

  std::size_t at(const Cell& c) const {
    return (idx(c[2]) * idx(cells_.size[1]) + idx(c[1])) * idx(cells_.size[0]) + idx(c[0]);
  }
  void visit(const Cell& c) {
    State& state = states_[at(c)];
    if (state != State::unknown) return;
    state = isInside(c) ? State::inside : State::ends;
    if (state == State::ends) return;
    front_.push_back(c);
    for (std::size_t a = 0; a < 3; ++a) {
      low_[a] = std::min(low_[a], c[a]);
      high_[a] = std::max(high_[a], c[a]);
    }
  }
  bool isInside(const Cell& c) const {
    Cell low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = c[a] * perCell_[a];
      high[a] = std::min(low[a] + perCell_[a], voxels_.size[a]) - 1;
    }
    return image_.holdsBox(low, high);
  }

  const ObjectImage& image_;
  const Grid& voxels_;
  Grid cells_;
  Cell perCell_{}, low_{1 << 30, 1 << 30, 1 << 30}, high_{-1, -1, -1};
  std::vector<State> states_;
  std::vector<Cell> front_;
};

}  // namespace

SizeField::SizeField(const ObjectImage& image, const std::vector<Vec3>& starts, double edgeLength) {
  CellFlood flood(image, edgeLength);
  for (const Vec3& start : starts) flood.from(start);
  if (flood.isEmpty()) return;
  grid_ = flood.box();
  sizes_ = distanceTo(grid_.size, grid_.spacing, flood.ends());
  const double toBoundary = (kHalfDiagonal + kTooLarge) * grid_.spacing.maxCoeff() +
                            kHalfDiagonal * image.volume().grid().spacing.maxCoeff();
  for (float& s : sizes_) {
    const double away = (static_cast<double>(s) - toBoundary) / edgeLength;
    widest_ = std::max(widest_, away);
    const double more = kGrade * (away - kNear);
    s = static_cast<float>(std::clamp(1 + more, 1.0, kLongest));
  }
  for (const Vec3& start : starts) keepRound(start, edgeLength);
}

void SizeField::keepRound(const Vec3& start, double edgeLength) {
  const Vec3 middle = grid_.toIndex(start);
  Cell low, high;
  for (int a = 0; a < 3; ++a) {
    const double reach = kLongest / kRound * edgeLength / grid_.spacing[a];  // cells
    low[a] = static_cast<int>(std::clamp(std::floor(middle[a] - reach), 0.0, grid_.size[a] - 1.0));
    high[a] = static_cast<int>(std::clamp(std::ceil(middle[a] + reach), 0.0, grid_.size[a] - 1.0));
  }
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) {
        const double away = (grid_.toWorld(Vec3(i, j, k)) - start).norm() / edgeLength;
        float& s = sizes_[(idx(k) * idx(grid_.size[1]) + idx(j)) * idx(grid_.size[0]) + idx(i)];
        s = std::min(s, static_cast<float>(std::max(1.0, kRound * away)));
      }
}

double SizeField::at(const Vec3& world) const {
  if (sizes_.empty()) return 1;
  const Vec3 index = grid_.toIndex(world);
  std::array<double, 3> t;
  std::size_t first = 0, stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = index[static_cast<int>(a)];
    if (!(x >= 0 && x < grid_.size[a] - 1)) return 1;  // there are three cells at least
    const auto cell = static_cast<std::size_t>(x);
    t[a] = x - static_cast<double>(cell);
    first += cell * stride;
    stride *= idx(grid_.size[a]);
  }
  const std::size_t up = idx(grid_.size[0]), on = up * idx(grid_.size[1]);
  const auto along = [](double a, double b, double s) { return a + s * (b - a); };
  const float *p = &sizes_[first], *q = p + on;
  const double low = along(along(p[0], p[1], t[0]), along(p[up], p[up + 1], t[0]), t[1]);
  const double high = along(along(q[0], q[1], t[0]), along(q[up], q[up + 1], t[0]), t[1]);
  return along(low, high, t[2]);
}

double SizeField::leastOn(const Vec3& centre, double radius) const {
  double least = kLongest;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0})
        if (x != 0 || y != 0 || z != 0)
          least = std::min(least, at(centre + radius * Vec3(x, y, z).normalized()));
  return least;
}

}  // namespace handlebody
