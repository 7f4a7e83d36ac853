#include "core/collision/spatial_hash.h"

#include <algorithm>

namespace handlebody {

namespace {

// The primes of Teschner et al. (2003), whom the paper follows.
constexpr std::uint32_t kPrimes[] = {73856093u, 19349663u, 83492791u};

// The squares of the numbers of vertices with the same value, summed, may be this many times the number of
// vertices. A mesh with edges between s/3 and s stays below 60, chance adds 1.
constexpr double kCrowd = 200;

}  // namespace

bool SpatialHash::build(std::span<const Vec3> points, std::span<const int> vertices, double radius) {
  const std::optional<HalfBoxes> boxes = halfBoxesFor(points, vertices, radius);
  if (!boxes) return false;
  points_ = points;
  radiusSquared_ = radius * radius * (1 + 0x1p-40);
  vertices_.assign(vertices.begin(), vertices.end());
  halfBoxes_.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) halfBoxes_[i] = boxes->boxOf(points[vertices[i]]);
  fillTable(0);
  return crowd() <= kCrowd * static_cast<double>(vertices.size());
}

//! Counting sort by Eq. (2).
void SpatialHash::fillTable(int shift) {
  const std::size_t count = vertices_.size();
  const auto size = static_cast<std::uint32_t>(
      std::clamp(tableSize_ * static_cast<double>(count), 1.0, static_cast<double>(1u << 30)));
  value_.resize(count);
  order_.resize(count);
  start_.assign(std::size_t{size} + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t sum = 0;
    for (int axis = 0; axis < 3; ++axis)
      sum += kPrimes[axis] * static_cast<std::uint32_t>(boxIndex(halfBoxes_[i][axis], shift >> axis & 1));
    value_[i] = sum % size;
    ++start_[value_[i]];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& s : start_) s = sum += s;
  for (std::size_t i = count; i-- > 0;) order_[--start_[value_[i]]] = static_cast<std::uint32_t>(i);
}

double SpatialHash::crowd() const {
  double sum = 0;
  for (std::size_t value = 0; value + 1 < start_.size(); ++value) {
    const double n = start_[value + 1] - start_[value];
    sum += n * n;
  }
  return sum;
}

std::size_t SpatialHash::countCandidates() {
  std::size_t count = 0;
  for (int shift = 0; shift < kFunctions; ++shift) {
    fillTable(shift);
    forEachWithSameValue([&](std::uint32_t, std::uint32_t) { ++count; });
  }
  return count;
}

//! The first of the eight functions that puts both into one box, or none of them: 8.
int SpatialHash::firstSharedBox(std::uint32_t i, std::uint32_t j) const {
  int shift = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = halfBoxes_[i][axis], b = halfBoxes_[j][axis];
    if (boxIndex(a, 0) == boxIndex(b, 0)) continue;
    if (boxIndex(a, 1) != boxIndex(b, 1)) return kFunctions;
    shift |= 1 << axis;
  }
  return shift;
}

}  // namespace handlebody
