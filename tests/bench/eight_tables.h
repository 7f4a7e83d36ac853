#pragma once
// Eq. (1) and (2) of the paper to the letter (but for the division by l, which it prints twice): eight
// tables, each filled by a counting sort. The measure for SpatialHash, which finds the same pairs in one
// table.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody::bench {

class EightTables {
 public:
  //! Calls f(u, v) once for each pair of points closer than radius < l/2.
  template <typename F>
  void forEachPair(std::span<const Vec3> points, double l, double radius, F&& f) {
    const auto n = static_cast<std::uint32_t>(points.size());
    const std::uint32_t size = 2 * n;
    halves_.resize(n);
    for (std::uint32_t v = 0; v < n; ++v) {
      for (int k = 0; k < 3; ++k) {
        halves_[v][static_cast<std::size_t>(k)] = static_cast<int>(std::floor(2 * points[v][k] / l));
      }
    }
    for (int shift = 0; shift < 8; ++shift) {
      sort(n, size, shift);
      for (std::uint32_t b = 0; b < size; ++b) {
        for (std::uint32_t i = start_[b]; i < start_[b + 1]; ++i) {
          for (std::uint32_t j = i + 1; j < start_[b + 1]; ++j) {
            const std::uint32_t u = order_[i], v = order_[j];
            if ((points[u] - points[v]).squaredNorm() > radius * radius) continue;
            if (firstSharedBox(u, v) == shift) f(u, v);
          }
        }
      }
    }
  }

 private:
  static int box(int half, int i) { return (half + i) >> 1; }  // r(a, i), Eq. (1)

  void sort(std::uint32_t n, std::uint32_t size, int shift) {
    hash_.resize(n);
    order_.resize(n);
    start_.assign(size + 1, 0);
    for (std::uint32_t v = 0; v < n; ++v) {  // h(v), Eq. (2)
      const auto& half = halves_[v];
      const auto r = [&](std::size_t k) { return static_cast<std::uint32_t>(box(half[k], shift >> k & 1)); };
      hash_[v] = (r(0) * 73856093u + r(1) * 19349663u + r(2) * 83492791u) % size;
      ++start_[hash_[v]];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& s : start_) s = sum += s;
    for (std::uint32_t v = n; v-- > 0;) order_[--start_[hash_[v]]] = v;
  }

  //! The first of the eight functions that puts u and v into one box, or 8.
  int firstSharedBox(std::uint32_t u, std::uint32_t v) const {
    int shift = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (box(halves_[u][k], 0) == box(halves_[v][k], 0)) continue;
      if (box(halves_[u][k], 1) != box(halves_[v][k], 1)) return 8;
      shift |= 1 << k;
    }
    return shift;
  }

  std::vector<std::array<int, 3>> halves_;
  std::vector<std::uint32_t> hash_, order_, start_;
};

}  // namespace handlebody::bench
