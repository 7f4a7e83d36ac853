#pragma once
// Wide spaces of a region and the narrow passages between them: a merge tree over the radii of the largest
// balls.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace handlebody {

//! Which passages are told: those much narrower than what lies on both sides, and those out of a space into
//! one much wider than all of it, which no narrowing tells. Lengths are those of radii.
struct NarrowRule {
  double narrow = 0.4;       //!< the passage is at most this part of the space before it, and of that behind
  double above = 1.25;       //!< before it counts what is this many times as wide as the passage, so that a
                             //!< start in a bar between two spaces has nothing wide before it
  double leastPart = 0.3;    //!< the space behind is at least this part of the one before
  double leastBehind = 2.5;  //!< and at least this wide
  double widening = 4;       //!< the space behind is this many times as wide as all before it
};

//! A passage where a space without a start merges with those that have one. Radii are those of balls.
struct Merging {
  double level = 0;         //!< radius of the widest ball that passes; 0: there is no way through
  std::uint32_t at = 0;     //!< the cell where it is narrowest; level > 0 only
  double before = 0;        //!< radius of the widest ball on the side of the start
  double behind = 0;        //!< of the widest on the other side
  std::uint32_t peak = 0;   //!< the cell in whose middle that is
  bool isWidening = false;  //!< told for what lies behind: it need not be narrower than what lies before it
};

//! Cells fall into basins: from each of them steps to the widest of the 26 neighbours lead to the same peak.
//! The widest way from one space to another leads over borders of basins, so that these alone decide. Ties go
//! to the cell with the smaller number.
class SpaceTree {
 public:
  //! `radius`: per cell, x fastest; 0 = no part of the region, as all of the outermost layer. Must outlive
  //! the tree.
  SpaceTree(const std::array<int, 3>& size, const std::vector<float>& radius);

  //! The passages, the widest first; at most kMaxPassages. `starts`: cells; those outside of the region do
  //! not count.
  std::vector<Merging> merge(std::span<const std::uint32_t> starts, const NarrowRule& rule);
  //! Number (from 1 on) of the passage behind which a cell lies, 0 for none. Precondition: after merge.
  std::uint8_t behindWhich(std::size_t cell) const {
    return basin_[cell] < 0 ? std::uint8_t{0} : marks_[basin_[cell]];
  }

  static constexpr std::size_t kMaxPassages = 255;

 private:
  struct Border {
    float level;
    std::uint32_t at, a, b;  // cell; basins
  };
  struct Past {
    float level, widest;
  };
  struct Space {
    std::uint32_t peak = 0;  // cell
    bool isStarted = false;
    std::vector<Past> past{};  // if started: how wide it was, at which levels
  };

  void findBasins();
  void findBorders();
  void start(std::span<const std::uint32_t> starts);
  void join(const Border& border, const NarrowRule& rule);
  void judge(const Border& border, const Space& before, std::uint32_t behind, const NarrowRule& rule);
  void judgeUnconnected(const NarrowRule& rule);
  std::uint32_t find(std::uint32_t basin);
  float peakOf(const Space& space) const { return radius_[space.peak]; }

  std::array<int, 3> size_;
  const std::vector<float>& radius_;
  std::array<std::ptrdiff_t, 13> forward_{};  // to the neighbours that come after a cell
  std::vector<std::int32_t> basin_;           // per cell; -1 = no part of the region
  std::vector<Border> borders_;               // the widest of every two basins, in descending order
  std::vector<Space> spaces_;                 // per basin; holds for the one that stands for its space
  std::vector<std::uint32_t> parent_;         // per basin
  std::vector<std::uint8_t> marks_;           // per basin
  std::vector<Merging> told_;
};

//! True if merge() of a tree of these radii surely tells nothing, in a fraction of the time of making it: it
//! is so for widths from w on, up to what makes them narrow beside it, if all that is as wide as w hangs
//! together with starts as wide. False says nothing.
bool surelyTellsNothing(const std::array<int, 3>& size, const std::vector<float>& radius,
                        std::span<const std::uint32_t> starts, const NarrowRule& rule);

}  // namespace handlebody
