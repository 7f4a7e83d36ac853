#pragma once
// Which boxes of many may meet some of a few: a bit table of the cells of a grid that the few meet.

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/collision/box_tree.h"

namespace handlebody {

class MarkedCells {
 public:
  //! Nothing is marked; cells of this size, mm.
  void clear(double size) {
    scale_ = 1 / size;
    marksAll_ = false;
    bits_.assign(kBits / 64, 0);
  }
  void mark(const Box& box) {
    const Cells cells = cellsOf(box);
    marksAll_ = marksAll_ || cells.count() > kMaxMarked;
    if (!marksAll_) anyOf(cells, [this](std::uint32_t at) { return bits_[at / 64] |= bit(at), false; });
  }
  //! True for every box that meets a marked one (touching counts), and for some others.
  bool mayMeet(const Box& box) const {
    const Cells cells = cellsOf(box);
    return marksAll_ || cells.count() > kMaxAsked ||
           anyOf(cells, [this](std::uint32_t at) { return (bits_[at / 64] & bit(at)) != 0; });
  }

 private:
  static constexpr std::uint32_t kBits = 1u << 19;
  static constexpr double kMaxMarked = 4096, kMaxAsked = 64;  // cells of one box
  struct Cells {
    Vec3 low, high;  // whole numbers
    //! Not finite, or not a number, where they cannot be numbered.
    double count() const {
      const bool numbered = (low.array() > -0x1p40).all() && (high.array() < 0x1p40).all();
      return numbered ? (high - low + Vec3::Constant(1)).prod() : HUGE_VAL;
    }
  };
  Cells cellsOf(const Box& box) const {
    return {(box.low * scale_).array().floor().matrix(), (box.high * scale_).array().floor().matrix()};
  }
  static std::uint64_t bit(std::uint32_t at) { return std::uint64_t{1} << at % 64; }
  template <typename F>
  static bool anyOf(const Cells& c, F&& f) {
    for (auto z = static_cast<std::int64_t>(c.low.z()); z <= static_cast<std::int64_t>(c.high.z()); ++z)
      for (auto y = static_cast<std::int64_t>(c.low.y()); y <= static_cast<std::int64_t>(c.high.y()); ++y)
        for (auto x = static_cast<std::int64_t>(c.low.x()); x <= static_cast<std::int64_t>(c.high.x()); ++x) {
          const auto at = static_cast<std::uint32_t>(x) * 73856093u ^
                          static_cast<std::uint32_t>(y) * 19349663u ^
                          static_cast<std::uint32_t>(z) * 83492791u;
          if (f(at % kBits)) return true;
        }
    return false;
  }

  double scale_ = 1;
  bool marksAll_ = false;
  std::vector<std::uint64_t> bits_;
};

}  // namespace handlebody
