#include "core/object/expected_overlap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/cancellation.h"

namespace handlebody {

namespace {

//! A region and its cells.
struct Listed {
  RankedRegion region;
  std::vector<std::uint32_t> cells;
};

Listed listed(const RankedRegion& r) {
  giveUpIfCancelled();
  Listed out{r, {}};
  for (std::size_t i = 0; i < r.map->level.size(); ++i)
    if (r.holds(i)) out.cells.push_back(static_cast<std::uint32_t>(i));
  return out;
}

//! The cell of another grid of the same volume in which a cell's middle lies; it may lie beyond the grid.
std::array<int, 3> cellIn(const CellGrid& to, const CellGrid& from, const std::array<int, 3>& cell) {
  std::array<int, 3> out{};
  for (std::size_t a = 0; a < 3; ++a) {
    const int voxel = from.low[a] + cell[a] * from.factor[a] + from.factor[a] / 2 - to.low[a];
    out[a] = voxel < 0 ? -1 : voxel / to.factor[a];
  }
  return out;
}

bool isWithin(const CellGrid& cells, const std::array<int, 3>& c) {
  for (std::size_t a = 0; a < 3; ++a)
    if (c[a] < 0 || c[a] >= cells.grid.size[a]) return false;
  return true;
}

//! Volume (mm³) that two regions share, counted in the cells of the first.
double shared(const Listed& a, const RankedRegion& b) {
  const CellGrid &from = a.region.search->image.cells, &to = b.search->image.cells;
  std::size_t both = 0;
  if (a.region.search == b.search) {
    for (const std::uint32_t i : a.cells) both += b.holds(i);
  } else {
    for (const std::uint32_t i : a.cells) {
      const auto c = cellIn(to, from, from.cellOf(i));
      both += isWithin(to, c) && b.holds(to.at(c));
    }
  }
  return static_cast<double>(both) * from.grid.voxelVolume();
}

//! Dice. In the finer cells, or those of the smaller region; regions of one map are nested.
double overlapOf(const Listed& a, const Listed& b) {
  const double least = std::min(a.region.volume, b.region.volume), sum = a.region.volume + b.region.volume;
  if (a.region.map == b.region.map) return 2 * least / sum;
  const auto cell = [](const Listed& l) { return l.region.search->image.cells.grid.voxelVolume(); };
  const bool countInA = cell(a) != cell(b) ? cell(a) < cell(b) : a.region.volume <= b.region.volume;
  return std::min(1.0, 2 * (countInA ? shared(a, b.region) : shared(b, a.region)) / sum);
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
    const auto differs = [&](const Listed& k) {
      const double sizes = 2 * std::min(r.volume, k.region.volume) / (r.volume + k.region.volume);
      return sizes <= same ||
             (r.map != k.region.map && 2 * shared(k, r) / (r.volume + k.region.volume) <= same);
    };
    if (std::all_of(kept.begin(), kept.end(), differs)) kept.push_back(listed(r));
  }
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
