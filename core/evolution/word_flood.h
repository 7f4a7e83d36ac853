#pragma once
// The region that floodObject floods, taken 32 voxels of a row at a time.

#include <bit>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/evolution/level_test.h"
#include "core/evolution/object_region.h"
#include "core/evolution/region_brick.h"

namespace handlebody {

//! A row of a brick is one machine word, and its voxels are listed only where someone asks: for regions of
//! millions of voxels, for which floodObject takes several times as long. Where it ends early it holds any
//! part of the region around the seeds, not a ball.
class WordFlood {
 public:
  //! As floodObject's. Volume and levels must live as long.
  WordFlood(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
            const LevelField& levels);

  //! Floods; false if it ended as soon as it had more than `mostVoxels`. To be called once.
  bool run(std::size_t mostVoxels);
  //! Voxels of the region.
  std::size_t count() const { return count_; }
  //! Those voxels that have faces, by rows, and the faces. Nothing is said of padding and of the border.
  ObjectRegion rim() const;
  //! f(first, last, y, z) for runs of voxels along x, by rows.
  template <typename F>
  void forEachRun(F&& f) const {
    for (const std::size_t at : taken_) {
      const Place p = placeOf(at);
      for (region::RowBits rest = words_[at].taken; rest != 0;) {
        const int first = std::countr_zero(rest), length = std::countr_one(rest >> first);
        f(p.brick * kBits + first, p.brick * kBits + first + length - 1, p.y, p.z);
        rest = first + length < kBits ? rest >> (first + length) << (first + length) : 0;
      }
    }
  }

 private:
  using RowBits = region::RowBits;
  static constexpr int kBits = region::kBrick;

  //! Unknown as long as nothing is inside or outside (padding is neither).
  struct Word {
    RowBits inside, outside;
    RowBits taken;
    RowBits waits;  // reached, but not taken yet
  };
  struct Free {
    void operator()(Word* words) const { std::free(words); }
  };
  using Words = std::unique_ptr<Word[], Free>;
  struct Place {
    int brick, y, z;  // brick along x
  };

  static Words allUnknown(std::size_t count);
  Place placeOf(std::size_t at) const {
    return {static_cast<int>(at % inRow_), static_cast<int>(at / inRow_ % rows_),
            static_cast<int>(at / inSlice_)};
  }
  RowBits voxelsOf(int brick) const;
  void start(const Vec3& seed);
  void enter(std::size_t at, RowBits bits);
  void look(std::size_t at);
  RowBits paddingOf(const Place& p, RowBits all) const;
  void take(std::size_t at);
  RowBits outsideBeside(std::size_t at, const Place& p, int axis, int step) const;

  const SmoothedVolume& volume_;
  LevelTest isInside_;
  float sign_, innermost_, outermost_;
  std::array<int, 3> size_;
  std::size_t inRow_, rows_, inSlice_;  // words in a row, rows in a slice, words in a slice
  Words words_;
  std::size_t count_ = 0;  // voxels taken
  std::vector<std::size_t> waiting_, taken_;
};

}  // namespace handlebody
