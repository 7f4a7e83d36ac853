#include "core/collision/sorted_boxes.h"

#include <cmath>
#include <limits>

namespace handlebody {
namespace {

// Bits of one pass of the sort: its counters stay in the nearest cache.
constexpr int kDigit = 11;
constexpr std::uint32_t kDigitMask = (1u << kDigit) - 1;

}  // namespace

bool SortedBoxes::build(std::span<const Vec3> points, std::span<const int> vertices, double radius) {
  const std::optional<HalfBoxes> boxes = halfBoxesFor(points, vertices, radius);
  if (!boxes) return false;
  points_ = points;
  radiusSquared_ = radius * radius * (1 + 0x1p-40);
  // In half boxes the radius is below 1. Each coordinate difference is off by less than 2^-22 times the
  // largest coordinate (two roundings to single precision, one of the difference), the sum of squares by a
  // few 2^-24.
  const double off = std::sqrt(3.0) * 0x1p-22 * boxes->extent.maxCoeff();
  rejectBeyond_ = static_cast<float>((1 + off) * (1 + off) * (1 + 0x1p-20));
  entries_.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    entries_[i] = {vertices[i], boxes->boxOf(points[vertices[i]])};
  for (const int axis : {0, 1, 2})
    sortAlong(static_cast<std::size_t>(axis), static_cast<int>(boxes->extent[axis]));
  if (listRows() > kCrowd * static_cast<double>(vertices.size())) return false;
  placePoints(*boxes);
  return true;
}

//! Counting sort, digit by digit; keeps the order of what is equal.
void SortedBoxes::sortAlong(std::size_t axis, int most) {
  scratch_.resize(entries_.size());
  for (int shift = 0; shift == 0 || most >> shift > 0; shift += kDigit) {
    const auto digit = [&](const Entry& e) {
      return static_cast<std::uint32_t>(e.box[axis] >> shift) & kDigitMask;
    };
    start_.assign(std::min(static_cast<std::uint32_t>(most >> shift), kDigitMask) + 1, 0);
    for (const Entry& e : entries_) ++start_[digit(e)];
    std::uint32_t sum = 0;
    for (std::uint32_t& s : start_) s = (sum += s) - s;
    for (const Entry& e : entries_) scratch_[start_[digit(e)]++] = e;
    std::swap(entries_, scratch_);
  }
}

//! Returns the sum of squares of the numbers of vertices in the half boxes.
double SortedBoxes::listRows() {
  rows_.clear();
  double crowd = 0, same = 0;
  std::array<int, 3> before{-1, -1, -1};
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    const std::array<int, 3>& box = entries_[i].box;
    if (box[1] != before[1] || box[2] != before[2]) rows_.push_back({box[1], box[2], i});
    same = box == before ? same + 1 : 1;
    crowd += 2 * same - 1;
    before = box;
  }
  constexpr int kBeyond = std::numeric_limits<int>::max();
  rows_.insert(rows_.end(), 3, {kBeyond, kBeyond, static_cast<std::uint32_t>(entries_.size())});
  return crowd;
}

void SortedBoxes::placePoints(const HalfBoxes& boxes) {
  const std::size_t count = entries_.size();
  vertex_.resize(count);
  x_.resize(count);
  for (auto& c : at_) c.resize(count + kLanes);
  for (std::size_t i = 0; i < count; ++i) {
    vertex_[i] = entries_[i].vertex;
    x_[i] = entries_[i].box[0];
    const Vec3 a = boxes.placeOf(points_[vertex_[i]]);
    for (std::size_t axis = 0; axis < 3; ++axis) at_[axis][i] = static_cast<float>(a[static_cast<int>(axis)]);
  }
}

}  // namespace handlebody
