#include "core/volume/border_region.h"

#include "core/indices.h"

namespace handlebody {

VoxelBits::VoxelBits(const std::array<int, 3>& size, bool inFrame)
    : columns_(size[0] + 2 * kFrame),
      rows_(size[1] + 2 * kFrame),
      slices_(size[2] + 2 * kFrame),
      inRow_(idx((columns_ + kBits - 1) / kBits)),
      words_(inRow_ * idx(rows_) * idx(slices_), 0) {
  if (!inFrame) return;
  for (int k = -kFrame; k < size[2] + kFrame; ++k)
    for (int j = -kFrame; j < size[1] + kFrame; ++j) {
      const bool isWithin = k >= 0 && k < size[2] && j >= 0 && j < size[1];
      for (int i = -kFrame; i < size[0] + kFrame; ++i) {
        if (isWithin && i == 0) i = size[0];
        set(i, j, k);
      }
    }
}

VoxelBits& VoxelBits::operator&=(const VoxelBits& other) {
  for (std::size_t w = 0; w < words_.size(); ++w) words_[w] &= other.words_[w];
  return *this;
}

//! Bits of the word (its number in its row) that are columns.
VoxelBits::Word VoxelBits::valid(std::size_t word) const {
  const int more = columns_ - static_cast<int>(word) * kBits;
  return more >= kBits ? ~Word{0} : (Word{1} << more) - 1;
}

//! Each row with itself moved by one voxel either way; `beyond` both ends all bits are as it says.
template <typename Combine>
void VoxelBits::combineAlongRows(Word beyond, Combine&& combine) {
  for (std::size_t row = 0; row < words_.size(); row += inRow_) {
    Word before = beyond;
    words_[row + inRow_ - 1] |= beyond & ~valid(inRow_ - 1);
    for (std::size_t w = 0; w < inRow_; ++w) {
      const Word now = words_[row + w], after = w + 1 < inRow_ ? words_[row + w + 1] : beyond;
      words_[row + w] =
          combine(now, now << 1 | before >> (kBits - 1), now >> 1 | after << (kBits - 1)) & valid(w);
      before = now;
    }
  }
}

//! Each word with those one step before and after it, the steps being `stride` words long and `steps` in a
//! line; lines follow one another as rows do in a slice.
template <typename Combine>
void VoxelBits::combineAcrossRows(std::size_t stride, std::size_t steps, Word beyond, Combine&& combine) {
  std::vector<Word> before(stride, beyond), now(stride);
  for (std::size_t line = 0; line < words_.size(); line += stride * steps) {
    before.assign(stride, beyond);
    for (std::size_t step = 0; step < steps; ++step) {
      Word* here = &words_[line + step * stride];
      for (std::size_t w = 0; w < stride; ++w) {
        now[w] = here[w];
        here[w] =
            combine(here[w], before[w], step + 1 < steps ? here[stride + w] : beyond) & valid(w % inRow_);
      }
      before.swap(now);
    }
  }
}

void VoxelBits::erode(int axis) {
  const auto all = [](Word a, Word b, Word c) { return a & b & c; };
  if (axis == 0) return combineAlongRows(~Word{0}, all);
  if (axis == 1) return combineAcrossRows(inRow_, idx(rows_), ~Word{0}, all);
  combineAcrossRows(inRow_ * idx(rows_), idx(slices_), ~Word{0}, all);
}

void VoxelBits::dilate(int axis) {
  const auto any = [](Word a, Word b, Word c) { return a | b | c; };
  if (axis == 0) return combineAlongRows(0, any);
  if (axis == 1) return combineAcrossRows(inRow_, idx(rows_), 0, any);
  combineAcrossRows(inRow_ * idx(rows_), idx(slices_), 0, any);
}

VoxelBits VoxelBits::reachedFromCorner() const {
  VoxelBits reached = *this;
  reached.words_.assign(words_.size(), 0);
  std::vector<Word> waits(words_.size(), 0);
  std::vector<std::size_t> waiting;
  const auto enter = [&](std::size_t at, Word bits) {
    bits &= words_[at] & ~reached.words_[at];
    if (bits == 0) return;
    if (waits[at] == 0) waiting.push_back(at);
    waits[at] |= bits;
  };
  const std::size_t inSlice = inRow_ * idx(rows_);
  enter(0, 1);
  while (!waiting.empty()) {
    const std::size_t at = waiting.back();
    waiting.pop_back();
    Word bits = waits[at];
    waits[at] = 0;
    for (Word before = 0; before != bits;) {
      before = bits;
      bits |= (bits << 1 | bits >> 1) & words_[at];
    }
    reached.words_[at] |= bits;
    const std::size_t column = at % inRow_, row = at / inRow_ % idx(rows_), slice = at / inSlice;
    if (column > 0) enter(at - 1, bits << (kBits - 1));
    if (column + 1 < inRow_) enter(at + 1, bits >> (kBits - 1));
    if (row > 0) enter(at - inRow_, bits);
    if (row + 1 < idx(rows_)) enter(at + inRow_, bits);
    if (slice > 0) enter(at - inSlice, bits);
    if (slice + 1 < idx(slices_)) enter(at + inSlice, bits);
  }
  return reached;
}

VoxelBits reachedFromBorder(VoxelBits in, const std::array<bool, 3>& axes) {
  for (int axis = 0; axis < 3; ++axis)
    if (axes[idx(axis)]) in.erode(axis);
  VoxelBits reached = in.reachedFromCorner();
  for (int axis = 0; axis < 3; ++axis)
    if (axes[idx(axis)]) reached.dilate(axis);
  return reached;
}

}  // namespace handlebody
