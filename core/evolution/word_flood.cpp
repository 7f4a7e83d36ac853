#include "core/evolution/word_flood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "core/indices.h"

namespace handlebody {

namespace {

using region::RowBits;

//! No float lies between it and the limit, which no float below it reaches.
float roundedUp(double limit) {
  const auto near = static_cast<float>(limit);
  return static_cast<double>(near) < limit ? std::nextafter(near, std::numeric_limits<float>::infinity())
                                           : near;
}

template <typename F>
void forEachBit(RowBits bits, F&& f) {
  for (; bits != 0; bits &= bits - 1) f(std::countr_zero(bits));
}

}  // namespace

WordFlood::WordFlood(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                     const LevelField& levels)
    : volume_(volume),
      isInside_(sign, levels),
      sign_(static_cast<float>(sign)),
      innermost_(roundedUp(isInside_.innermost())),
      outermost_(roundedUp(isInside_.outermost())),
      size_(volume.grid().size),
      inRow_(idx(volume.bricks()[0])),
      rows_(idx(size_[1])),
      inSlice_(inRow_ * rows_),
      words_(allUnknown(inSlice_ * idx(size_[2]))) {
  for (const Vec3& s : seeds) start(s);
}

//! By calloc, so that of a large volume only the pages that the region touches become memory.
WordFlood::Words WordFlood::allUnknown(std::size_t count) {
  auto* words = static_cast<Word*>(std::calloc(count, sizeof(Word)));
  if (!words) throw std::bad_alloc();
  return Words(words);
}

//! Voxels of the volume in a word.
RowBits WordFlood::voxelsOf(int brick) const {
  const int more = size_[0] - brick * kBits;
  return more >= kBits ? ~RowBits{0} : (RowBits{1} << more) - 1;
}

//! The nearest voxel may be noise: its neighbours are tried too.
void WordFlood::start(const Vec3& seed) {
  std::array<int, 3> middle;
  for (int a = 0; a < 3; ++a) middle[idx(a)] = static_cast<int>(std::lround(seed[a]));
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const int x = middle[0] + i, y = middle[1] + j, z = middle[2] + k;
        if (!volume_.grid().contains(Vec3(x, y, z))) continue;
        enter(idx(z) * inSlice_ + idx(y) * inRow_ + idx(x / kBits), RowBits{1} << (x % kBits));
      }
}

bool WordFlood::run(std::size_t mostVoxels) {
  while (!waiting_.empty() && count_ <= mostVoxels) {
    std::vector<std::size_t> now;
    now.swap(waiting_);
    for (const std::size_t at : now) {
      if (count_ > mostVoxels) break;
      take(at);
    }
  }
  std::sort(taken_.begin(), taken_.end());
  return count_ <= mostVoxels;
}

void WordFlood::enter(std::size_t at, RowBits bits) {
  Word& word = words_[at];
  if ((word.inside | word.outside) == 0) look(at);
  bits &= word.inside & ~word.taken;
  if (bits == 0) return;
  if (word.waits == 0) waiting_.push_back(at);
  word.waits |= bits;
}

//! Which voxels of the word are inside.
void WordFlood::look(std::size_t at) {
  const Place p = placeOf(at);
  const RowBits all = voxelsOf(p.brick);
  const float* row = volume_.brick(p.brick, p.y >> region::kShift, p.z >> region::kShift) +
                     region::rowIndex(region::placeOf({0, p.y, p.z}) >> region::kShift);
  Word& word = words_[at];
  word.inside = all & region::rowBelow(row, sign_, innermost_);
  forEachBit(all & region::rowBelow(row, sign_, outermost_) & ~word.inside, [&](int i) {
    if (isInside_.at(row[i], Vec3(p.brick * kBits + i, p.y, p.z))) word.inside |= RowBits{1} << i;
  });
  const RowBits padding = volume_.hasPadding() ? paddingOf(p, all) : 0;
  word.inside &= ~padding;
  word.outside = all & ~word.inside & ~padding;
}

RowBits WordFlood::paddingOf(const Place& p, RowBits all) const {
  const std::size_t first = (idx(p.z) * rows_ + idx(p.y)) * idx(size_[0]) + idx(p.brick * kBits);
  RowBits padding = 0;
  forEachBit(all, [&](int i) { padding |= static_cast<RowBits>(volume_.isPadding(first + idx(i))) << i; });
  return padding;
}

void WordFlood::take(std::size_t at) {
  Word& word = words_[at];
  const RowBits bits = region::fillRow(word.waits, word.inside & ~word.taken);
  word.waits = 0;
  if (word.taken == 0) taken_.push_back(at);
  word.taken |= bits;
  count_ += idx(std::popcount(bits));
  const Place p = placeOf(at);
  if (p.brick > 0 && (bits & 1)) enter(at - 1, RowBits{1} << (kBits - 1));
  if (p.brick + 1 < volume_.bricks()[0] && (bits >> (kBits - 1))) enter(at + 1, 1);
  if (p.y > 0) enter(at - inRow_, bits);
  if (p.y + 1 < size_[1]) enter(at + inRow_, bits);
  if (p.z > 0) enter(at - inSlice_, bits);
  if (p.z + 1 < size_[2]) enter(at + inSlice_, bits);
}

//! Voxels of the word whose neighbour along the axis is outside.
RowBits WordFlood::outsideBeside(std::size_t at, const Place& p, int axis, int step) const {
  const auto outside = [&](std::size_t w) { return words_[w].outside; };
  if (axis > 0) {
    const int to = (axis == 1 ? p.y : p.z) + step;
    if (to < 0 || to >= size_[idx(axis)]) return 0;
    const std::size_t stride = axis == 1 ? inRow_ : inSlice_;
    return outside(step < 0 ? at - stride : at + stride);
  }
  if (step < 0) return outside(at) << 1 | (p.brick > 0 ? outside(at - 1) >> (kBits - 1) : 0);
  const bool isLast = p.brick + 1 == volume_.bricks()[0];
  return outside(at) >> 1 | (isLast ? 0 : outside(at + 1) << (kBits - 1));
}

ObjectRegion WordFlood::rim() const {
  ObjectRegion region;
  for (const std::size_t at : taken_) {
    const Place p = placeOf(at);
    const RowBits taken = words_[at].taken;
    std::array<RowBits, 6> faces;
    RowBits any = 0;
    for (int side = 0; side < 6; ++side)
      any |= faces[idx(side)] = taken & outsideBeside(at, p, side / 2, side % 2 == 0 ? -1 : 1);
    forEachBit(any, [&](int i) {
      const auto voxel = static_cast<std::int32_t>(region.voxels.size());
      region.voxels.push_back({p.brick * kBits + i, p.y, p.z});
      for (int side = 0; side < 6; ++side)
        if (faces[idx(side)] >> i & 1)
          region.faces.push_back(
              {voxel, static_cast<std::int8_t>(side / 2), static_cast<std::int8_t>(side % 2 == 0 ? -1 : 1)});
    });
  }
  return region;
}

}  // namespace handlebody
