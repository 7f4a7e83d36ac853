#pragma once
// What is connected with the border of a volume, and not through a narrow passage alone.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace handlebody {

//! Voxels of a volume, one bit each in words along x, with a frame of kFrame voxels around them.
class VoxelBits {
 public:
  static constexpr int kFrame = 2;

  //! `inFrame`: what the frame holds. The volume itself is empty.
  VoxelBits(const std::array<int, 3>& size, bool inFrame);

  void set(int i, int j, int k) { word(i, j, k) |= bit(i); }
  //! Those of a row that isIn(i) says are in.
  template <typename IsIn>
  void setRow(int j, int k, IsIn&& isIn);
  //! Calls f(first, last) for all that is in in a row without gaps, the last not included; without the frame.
  template <typename F>
  void forEachRun(int j, int k, F&& f) const;
  //! What is in both. Precondition: of one size.
  VoxelBits& operator&=(const VoxelBits& other);
  bool test(int i, int j, int k) const { return (words_[wordOf(i, j, k)] & bit(i)) != 0; }

  //! Without the voxels that have a neighbour along the axis which is not in; beyond the frame all is in.
  void erode(int axis);
  //! With the neighbours along the axis.
  void dilate(int axis);
  //! The part that is connected by faces with the corner of the frame, which must be in.
  VoxelBits reachedFromCorner() const;

 private:
  using Word = std::uint64_t;
  static constexpr int kBits = 64;

  std::size_t wordOf(int i, int j, int k) const {
    const auto row = static_cast<std::size_t>(k + kFrame) * static_cast<std::size_t>(rows_) +
                     static_cast<std::size_t>(j + kFrame);
    return row * inRow_ + static_cast<std::size_t>((i + kFrame) / kBits);
  }
  Word& word(int i, int j, int k) { return words_[wordOf(i, j, k)]; }
  static Word bit(int i) { return Word{1} << ((i + kFrame) % kBits); }
  Word valid(std::size_t word) const;
  template <typename Combine>
  void combineAlongRows(Word beyond, Combine&& combine);
  template <typename Combine>
  void combineAcrossRows(std::size_t stride, std::size_t steps, Word beyond, Combine&& combine);

  int columns_, rows_, slices_;  // with the frame
  std::size_t inRow_;            // words
  std::vector<Word> words_;      // bits beyond the columns are 0
};

template <typename IsIn>
void VoxelBits::setRow(int j, int k, IsIn&& isIn) {
  const int n = columns_ - 2 * kFrame;
  for (int i = 0; i < n;) {
    Word in = 0, *to = &word(i, j, k);
    int at = (i + kFrame) % kBits;
    for (const int end = std::min(n, i + kBits - at); i < end; ++i, ++at)
      in |= static_cast<Word>(isIn(i)) << at;
    *to |= in;
  }
}

template <typename F>
void VoxelBits::forEachRun(int j, int k, F&& f) const {
  const int n = columns_ - 2 * kFrame;
  const auto next = [&](int i, Word wanted) {  // from i on: the first that is in, or is not (all bits of 0)
    while (i < n) {
      const int at = (i + kFrame) % kBits;
      const Word left = (words_[wordOf(i, j, k)] ^ ~wanted) >> at;
      if (left != 0) return std::min(n, i + std::countr_zero(left));
      i += kBits - at;
    }
    return n;
  };
  for (int i = next(0, ~Word{0}); i < n;) {
    const int end = next(i, 0);
    f(i, end);
    i = next(end, ~Word{0});
  }
}

//! Of the voxels that are in, those connected with the border of the volume by faces through passages at
//! least three voxels wide, and their neighbours: what a cube of three voxels reaches from outside, which is
//! all in. `axes`: along which a passage has a width; the cube is one voxel thick along others.
VoxelBits reachedFromBorder(VoxelBits in, const std::array<bool, 3>& axes);

}  // namespace handlebody
