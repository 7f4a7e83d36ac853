#include "core/object/expected_overlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/object/centrality.h"

namespace handlebody {

namespace {

constexpr int kNone = -1;

//! In which cells of another grid of the same volume the middles of cells lie, along one axis.
std::vector<int> cellsAlong(std::size_t axis, const CellGrid& to, const CellGrid& from) {
  std::vector<int> out;
  for (int i = 0; i < from.grid.size[axis]; ++i) {
    const int voxel = from.low[axis] + i * from.factor[axis] + from.factor[axis] / 2 - to.low[axis];
    const int cell = voxel < 0 ? kNone : voxel / to.factor[axis];
    out.push_back(cell < to.grid.size[axis] ? cell : kNone);
  }
  return out;
}

using Mask = std::vector<std::uint8_t>;

//! 1 for the cells of a region among `n` that follow one another.
void markRow(const std::uint8_t* level, std::uint8_t rung, std::size_t n, std::uint8_t* to) {
  for (std::size_t i = 0; i < n; ++i) to[i] = level[i] <= rung;
}

//! 1 for each row of the region's own grid in which it has cells.
Mask rowsOf(const RankedRegion& r) {
  const auto row = static_cast<std::size_t>(r.search->image.cells.grid.size[0]);
  Mask out;
  for (auto level = r.map->level.begin(); level != r.map->level.end();
       level += static_cast<std::ptrdiff_t>(row)) {
    std::uint8_t least = kNever;
    for (std::size_t i = 0; i < row; ++i) least = std::min(least, level[static_cast<std::ptrdiff_t>(i)]);
    out.push_back(least <= r.rung);
  }
  return out;
}

//! A region's cells, 1 each, in the grid of another search. `rows`: rowsOf it.
class MaskOn {
 public:
  MaskOn(const CellGrid& grid, const RankedRegion& r, const Mask& rows)
      : own_(r.search->image.cells), map_(*r.map), rows_(rows), rung_(static_cast<std::uint8_t>(r.rung)) {
    for (std::size_t a = 0; a < 3; ++a) cell_[a] = cellsAlong(a, own_, grid);
    const auto isThere = [](int c) { return c != kNone; };
    first_ =
        static_cast<std::size_t>(std::find_if(cell_[0].begin(), cell_[0].end(), isThere) - cell_[0].begin());
    end_ = cell_[0].size();
    while (end_ > first_ && cell_[0][end_ - 1] == kNone) --end_;
    for (std::size_t x = first_ + 1; x < end_; ++x)
      isInStep_ = isInStep_ && cell_[0][x] == cell_[0][x - 1] + 1;
  }

  Mask make() const {
    const std::size_t row = cell_[0].size(), plane = row * cell_[1].size();
    Mask out(plane * cell_[2].size(), 0);
    std::uint8_t* to = out.data();
    for (std::size_t z = 0; z < cell_[2].size(); ++z)
      for (std::size_t y = 0; y < cell_[1].size(); ++y, to += row) {
        if (!hasCells(y, z)) continue;
        if (z > 0 && cell_[2][z] == cell_[2][z - 1])  // finer cells in coarser ones: the same again
          std::memcpy(to, to - plane, row);
        else if (y > 0 && cell_[1][y] == cell_[1][y - 1])
          std::memcpy(to, to - row, row);
        else
          takeRow(&map_.level[own_.at(0, cell_[1][y], cell_[2][z])], to);
      }
    return out;
  }

 private:
  bool hasCells(std::size_t y, std::size_t z) const {
    if (first_ == end_ || cell_[1][y] == kNone || cell_[2][z] == kNone) return false;
    return rows_[idx(cell_[2][z]) * idx(own_.grid.size[1]) + idx(cell_[1][y])] != 0;
  }
  void takeRow(const std::uint8_t* level, std::uint8_t* to) const {
    if (isInStep_) return markRow(level + cell_[0][first_], rung_, end_ - first_, to + first_);
    for (std::size_t x = first_; x < end_; ++x) to[x] = level[cell_[0][x]] <= rung_;
  }

  const CellGrid& own_;
  const ArrivalMap& map_;
  const Mask& rows_;
  std::uint8_t rung_;
  std::array<std::vector<int>, 3> cell_;
  std::size_t first_ = 0, end_ = 0;  // within a row: cells that lie in some of the region's grid
  bool isInStep_ = true;             // one after the other
};

Mask maskOf(const RankedRegion& r) {
  Mask out(r.map->level.size());
  markRow(r.map->level.data(), static_cast<std::uint8_t>(r.rung), out.size(), out.data());
  return out;
}

//! Cells of a grid, a bit each; no words before the first and after the last that hold any.
class CellSet {
 public:
  //! `mask`: 0 or 1 per cell.
  explicit CellSet(Mask mask) {
    mask.resize((mask.size() + kBits - 1) / kBits * kBits, 0);
    for (std::size_t from = 0; from < mask.size(); from += kBits) {
      const std::uint64_t word = wordOf(&mask[from]);
      if (words_.empty() && word == 0) continue;
      if (words_.empty()) first_ = from / kBits;
      words_.push_back(word);
    }
    while (!words_.empty() && words_.back() == 0) words_.pop_back();
  }
  std::size_t shared(const CellSet& o) const {
    const std::size_t from = std::max(first_, o.first_), end = std::min(last(), o.last());
    std::size_t out = 0;
    for (std::size_t w = from; w < end; w += kWords) {
      std::uint64_t sums = 0;  // of each of eight bytes
      for (std::size_t i = w; i < std::min(end, w + kWords); ++i)
        sums += countsOf(words_[i - first_] & o.words_[i - o.first_]);
      for (; sums != 0; sums >>= 8) out += sums & 0xff;
    }
    return out;
  }

 private:
  static constexpr std::size_t kBits = 64;
  static constexpr std::size_t kWords = 31;  // so many counts of up to 8 fit into a byte
  //! How many bits of each byte are set; several words at once where the processor can, which has an
  //! instruction for the count of one only if it is new enough.
  static std::uint64_t countsOf(std::uint64_t x) {
    x -= x >> 1 & 0x5555555555555555U;
    x = (x & 0x3333333333333333U) + (x >> 2 & 0x3333333333333333U);
    return (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fU;
  }
  //! Of 64 bytes of 0 or 1; a product brings eight of them together.
  static std::uint64_t wordOf(const std::uint8_t* bytes) {
    std::uint64_t word = 0;
    for (std::size_t b = 0; b < kBits; b += 8) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, bytes + b, sizeof eight);
      word |= ((eight * 0x0102040810204080U) >> 56) << b;
    }
    return word;
  }
  std::size_t last() const { return first_ + words_.size(); }
  std::size_t first_ = 0;
  std::vector<std::uint64_t> words_;
};

//! A region and its cells, in the grid of each search in which it was asked for.
class Listed {
 public:
  explicit Listed(const RankedRegion& r) : region(r) {}
  const CellSet& cellsOf(const ClickSearch* search) const {
    const auto known =
        std::find_if(sets_.begin(), sets_.end(), [&](const auto& s) { return s.first == search; });
    if (known != sets_.end()) return known->second;
    giveUpIfCancelled();
    if (search != region.search && rows_.empty()) rows_ = rowsOf(region);
    sets_.emplace_back(search,
                       CellSet(search == region.search ? maskOf(region)
                                                       : MaskOn(search->image.cells, region, rows_).make()));
    return sets_.back().second;
  }
  RankedRegion region;

 private:
  mutable std::vector<std::pair<const ClickSearch*, CellSet>> sets_;
  mutable Mask rows_;
};

//! Volume (mm³) that two regions share, counted in the cells of the first.
double shared(const Listed& a, const Listed& b) {
  const ClickSearch* search = a.region.search;
  return static_cast<double>(a.cellsOf(search).shared(b.cellsOf(search))) *
         search->image.cells.grid.voxelVolume();
}

//! Dice. In the finer cells, or those of the smaller region; regions of one map are nested.
double overlapOf(const Listed& a, const Listed& b) {
  const double least = std::min(a.region.volume, b.region.volume), sum = a.region.volume + b.region.volume;
  if (a.region.map == b.region.map) return 2 * least / sum;
  const auto cell = [](const Listed& l) { return l.region.search->image.cells.grid.voxelVolume(); };
  const bool countInA = cell(a) != cell(b) ? cell(a) < cell(b) : a.region.volume <= b.region.volume;
  return std::min(1.0, 2 * (countInA ? shared(a, b) : shared(b, a)) / sum);
}

//! Of a click near the rim of a region.
double costOfRim(const RankedRegion& r, const ObjectPolicy& p) {
  const double part = std::clamp(centrality(r), p.leastCentral, p.centralDepth);
  return p.central * std::log(p.centralDepth / part);
}

double diceOfIntersectionOverUnion(double iou) { return 2 * iou / (1 + iou); }

}  // namespace

std::vector<double> likelihoods(const std::vector<double>& scores, const ObjectPolicy& policy) {
  const double best = *std::max_element(scores.begin(), scores.end());
  std::vector<double> out;
  for (const double s : scores) out.push_back(std::exp((s - best) / policy.likelyScore));
  const double sum = std::accumulate(out.begin(), out.end(), 0.0);
  for (double& l : out) l /= sum;
  return out;
}

LikelyRegions likelyRegions(std::vector<RankedRegion>& ranked, const ObjectPolicy& policy) {
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const RankedRegion& a, const RankedRegion& b) { return a.score > b.score; });
  const double same = diceOfIntersectionOverUnion(policy.likelySame);
  LikelyRegions out;
  std::vector<Listed> kept;
  for (const RankedRegion& r : ranked) {
    if (kept.size() == policy.likely) break;
    Listed next(r);
    const auto differs = [&](const Listed& k) {
      const double sizes = 2 * std::min(r.volume, k.region.volume) / (r.volume + k.region.volume);
      return sizes <= same ||
             (r.map != k.region.map && 2 * shared(k, next) / (r.volume + k.region.volume) <= same);
    };
    if (std::all_of(kept.begin(), kept.end(), differs)) kept.push_back(std::move(next));
  }
  for (Listed& k : kept) k.region.score -= costOfRim(k.region, policy);
  std::stable_sort(kept.begin(), kept.end(),
                   [](const Listed& a, const Listed& b) { return a.region.score > b.region.score; });
  std::vector<double> scores;
  for (const Listed& k : kept) {
    out.regions.push_back(k.region);
    scores.push_back(k.region.score);
    std::vector<double> row;
    for (const Listed& other : kept) {
      const std::size_t i = out.overlap.size(), j = row.size();
      row.push_back(j < i ? out.overlap[j][i] : i == j ? 1 : overlapOf(k, other));
    }
    out.overlap.push_back(std::move(row));
  }
  if (!scores.empty()) out.likelihood = likelihoods(scores, policy);
  return out;
}

std::vector<OfferedRegion> offeredRegions(const LikelyRegions& likely, const ObjectPolicy& policy) {
  const std::size_t n = likely.regions.size();
  const auto expected = [&](std::size_t i, const std::vector<double>& already) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      sum += likely.likelihood[j] * std::max(likely.overlap[i][j], already[j]);
    return sum;
  };
  const std::vector<double> none(n, 0.0);
  std::vector<double> best = none;  // Dice of the best one offered, if this one is meant
  std::vector<std::size_t> left(n);
  std::iota(left.begin(), left.end(), 0);
  std::vector<OfferedRegion> out;
  while (!left.empty() && out.size() < policy.offered) {
    std::size_t next = left[0];
    double most = -1;
    for (const std::size_t i : left)
      if (const double e = expected(i, best); e > most) most = e, next = i;
    // Its compromise between much the same regions is worse than the best of them.
    next = *std::find_if(left.begin(), left.end(),  // sorted by score
                         [&](std::size_t i) { return i == next || likely.overlap[next][i] >= policy.crisp; });
    out.push_back({likely.regions[next], expected(next, none)});
    for (std::size_t j = 0; j < n; ++j) best[j] = std::max(best[j], likely.overlap[next][j]);
    std::erase_if(left, [&](std::size_t i) {
      return likely.overlap[next][i] > diceOfIntersectionOverUnion(policy.sameRegion);
    });
  }
  return out;
}

}  // namespace handlebody
