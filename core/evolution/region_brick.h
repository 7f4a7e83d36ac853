#pragma once
// What region growth keeps of a brick of the volume: which voxels it has seen, as one word of bits per row
// of 32.

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/volume/smoothed_volume.h"

namespace handlebody::region {

inline constexpr int kBins = 200;  //!< levels of a growth
inline constexpr int kBrick = SmoothedVolume::kBrick;
inline constexpr int kStored = SmoothedVolume::kStored;
inline constexpr int kShift = SmoothedVolume::kBrickShift;
inline constexpr int kBrickMask = kBrick - 1;
static_assert(kBrick == 32, "a row is one word");

struct Voxel {
  int i, j, k;
  int along(int axis) const { return axis == 0 ? i : axis == 1 ? j : k; }
};

//! A voxel of a brick: five bits per axis, x lowest; without x: a row.
using BrickVoxel = std::uint16_t;
using RowBits = std::uint32_t;
inline constexpr int kRows = kBrick * kBrick;
inline constexpr std::array<int, 3> kPlaceStride{1, kBrick, kBrick* kBrick};
inline constexpr std::array<int, 3> kValueStride{1, kStored, kStored* kStored};

inline BrickVoxel placeOf(const Voxel& v) {
  return static_cast<BrickVoxel>((v.k & kBrickMask) << 2 * kShift | (v.j & kBrickMask) << kShift |
                                 (v.i & kBrickMask));
}
inline Voxel inBrick(BrickVoxel place) {
  return {place & kBrickMask, place >> kShift & kBrickMask, place >> 2 * kShift};
}
inline int valueIndex(const Voxel& v) { return (v.k * kStored + v.j) * kStored + v.i; }
//! Index of the first value of a row.
inline int rowIndex(int row) { return ((row >> kShift) * kStored + (row & kBrickMask)) * kStored; }

//! Bit x: sign · values[x] < limit. `sign` is +1 or -1.
inline RowBits rowBelow(const float* values, float sign, float limit) {
  using Floats = float __attribute__((vector_size(16)));
  using Bits = std::uint32_t __attribute__((vector_size(16)));
  Bits all{0, 0, 0, 0};
  for (int x = 0; x < kBrick; x += 4) {
    Floats v;
    std::memcpy(&v, values + x, sizeof v);
    all |= reinterpret_cast<Bits>(v * sign < limit) & (Bits{1, 2, 4, 8} << x);
  }
  return all[0] | all[1] | all[2] | all[3];
}

//! All bits of `free` that are joined to one of `start` by bits of `free`. Precondition: start within free.
inline RowBits fillRow(RowBits start, RowBits free) {
  RowBits up = start, down = start, pathUp = free, pathDown = free;
  for (int step = 1; step < kBrick; step *= 2) {
    up |= pathUp & up << step;
    pathUp &= pathUp << step;
    down |= pathDown & down >> step;
    pathDown &= pathDown >> step;
  }
  return up | down;
}

//! A voxel that waits, and its signed value.
struct Entry {
  BrickVoxel place;
  float value;
};

struct Brick {
  const float* values = nullptr;
  Voxel first{};  // voxel of the grid
  Voxel last{};   // in the brick: beyond it a neighbour lies in another brick or outside the grid
  bool onBorder = false;
  std::array<Brick*, 6> neighbours{};  // two per axis; null: not asked for yet, or outside
  std::array<RowBits, kRows> seen{};   // or outside of the grid, or padding
  // For the level that is taken in by rows:
  int rowLevel = -1;                              // which one the next three belong to
  std::array<RowBits, kRows> low{};               // what it lets in
  std::array<RowBits, kRows> todo{};              // of those: what a neighbour has reached
  std::array<RowBits, kRows> taken{};             // what was taken
  std::vector<int> rows;                          // with something to do
  std::array<std::vector<Entry>, kBins> waiting;  // per level

  //! True the first time.
  bool visit(BrickVoxel place) {
    const RowBits bit = RowBits{1} << (place & kBrickMask);
    RowBits& row = seen[place >> kShift];
    const bool fresh = (row & bit) == 0;
    row |= bit;
    return fresh;
  }
  //! It may be seen again.
  void forget(BrickVoxel place) { seen[place >> kShift] &= ~(RowBits{1} << (place & kBrickMask)); }
  Voxel inGrid(const Voxel& local) const { return {first.i + local.i, first.j + local.j, first.k + local.k}; }
};

}  // namespace handlebody::region
