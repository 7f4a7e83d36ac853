#include "core/object/arrival.h"

#include <algorithm>
#include <cmath>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/object/eight_cells.h"
#include "core/object/morphology.h"
#include "core/threads.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

using Cell = std::array<int, 3>;
using Levels = std::vector<std::uint8_t>;
//! Calls f(cell) for the cells at most `reach` from `centre` along each axis.
template <typename F>
void forBox(const CellGrid& cells, const Cell& centre, int reach, F&& f) {
  Cell lo, hi;
  for (std::size_t a = 0; a < 3; ++a) {
    lo[a] = std::max(0, centre[a] - reach);
    hi[a] = std::min(cells.grid.size[a] - 1, centre[a] + reach);
  }
  for (int z = lo[2]; z <= hi[2]; ++z)
    for (int y = lo[1]; y <= hi[1]; ++y)
      for (int x = lo[0]; x <= hi[0]; ++x) f(Cell{x, y, z});
}

//! Along which axes each pass of an opening goes: by turns the six and the eighteen nearest, along an axis
//! only when as much length has gathered as its cells are long.
std::vector<OpeningPass> passesOf(const CellGrid& cells, const ObjectPolicy& policy) {
  const double length = policy.passLength * cells.grid.meanSpacing();
  std::vector<OpeningPass> passes;
  Vec3 gathered(0, 0, 0);
  for (int p = 0; p < policy.openings.back(); ++p) {
    OpeningPass pass;
    for (int a = 0; a < 3; ++a) {
      gathered[a] += length;
      if (gathered[a] < 0.8 * cells.grid.spacing[a]) continue;
      pass.along[a] = true;
      gathered[a] = std::max(0.0, gathered[a] - policy.passLength * cells.grid.spacing[a]);
    }
    pass.diagonal = p % 2 == 1;
    passes.push_back(pass);
  }
  return passes;
}

//! The best cell to start from within the opening's reach: of the lowest level, then the nearest.
std::size_t startNear(const CellGrid& cells, const Levels& key, const Cell& click, int passes,
                      const ObjectPolicy& policy) {
  std::size_t best = cells.at(click);
  if (passes == 0) return best;
  const double reach = (passes + 0.5) * policy.passLength * cells.grid.meanSpacing();
  double bestDistance = 0;
  forBox(cells, click, passes + 1, [&](const Cell& c) {
    double d = 0;
    for (int a = 0; a < 3; ++a) d += std::pow((c[a] - click[a]) * cells.grid.spacing[a], 2);
    if (d > reach * reach) return;
    const std::size_t i = cells.at(c);
    if (key[i] > key[best] || (key[i] == key[best] && d >= bestDistance)) return;
    best = i;
    bestDistance = d;
  });
  return best;
}

//! Minimax paths: the lowest level at which each cell hangs together with the start.
class Flood {
 public:
  Flood(const CellGrid& cells, const ObjectPolicy& policy)
      : cells_(cells),
        nx_(cells.grid.size[0] + 2),
        ny_(cells.grid.size[1] + 2),
        most_(policy.largestPart * static_cast<double>(cells.count())) {
    const auto& n = cells.grid.size;
    mostBorder_ = policy.mostBorder * 2 *
                  (static_cast<double>(n[0]) * n[1] + static_cast<double>(n[1]) * n[2] +
                   static_cast<double>(n[0]) * n[2]);
    const std::size_t all = idx(nx_) * idx(ny_) * idx(n[2] + 2);
    key_.resize(all);
    level_.resize(all);
  }

  Levels run(const Levels& key, std::size_t start) {
    load(key);
    const auto n0 = idx(cells_.grid.size[0]), n1 = idx(cells_.grid.size[1]);
    const std::size_t s = padded(start % n0, start / n0 % n1, start / (n0 * n1));
    for (auto& q : queues_) q.clear();
    queues_[key_[s]].push_back(static_cast<std::uint32_t>(s));
    int level = key_[s];
    key_[s] = kTaken;
    taken_ = border_ = 0;
    const auto isBackground = [&] {
      return static_cast<double>(taken_) > most_ || static_cast<double>(border_) > mostBorder_;
    };
    for (; level < kNever && !isBackground(); ++level) {
      auto& queue = queues_[level];
      while (!queue.empty()) {
        const std::uint32_t v = queue.back();
        queue.pop_back();
        takeRow(v, static_cast<std::uint8_t>(level));
      }
    }
    end_ = level - (isBackground() ? 1 : 0);
    return unload();
  }
  //! Of the last run: rungs from here on are not known.
  int end() const { return end_; }

 private:
  static constexpr std::uint8_t kTaken = 254, kBorder = 255;
  std::size_t padded(std::size_t x, std::size_t y, std::size_t z) const {
    return ((z + 1) * idx(ny_) + y + 1) * idx(nx_) + x + 1;
  }
  //! A cell that was reached at this level, and those beside it in its row.
  void takeRow(std::size_t cell, std::uint8_t level) {
    std::size_t first = cell, last = cell;
    while (key_[first - 1] <= level) key_[--first] = kTaken;
    while (key_[last + 1] <= level) key_[++last] = kTaken;
    reach(first - 1, level);
    reach(last + 1, level);
    const std::size_t count = last - first + 1;
    std::fill_n(level_.begin() + static_cast<std::ptrdiff_t>(first), count, level);
    const std::size_t before = taken_ >> 16;
    taken_ += count;
    if (taken_ >> 16 != before) giveUpIfCancelled();
    const std::size_t row = idx(nx_), plane = row * idx(ny_);
    for (const std::size_t beside : {first - row, first + row, first - plane, first + plane})
      reachRow(beside, count, level);
  }
  void reach(std::size_t cell, std::uint8_t level) {
    const std::uint8_t k = key_[cell];
    border_ += k == kBorder;
    if (k >= kNever) return;
    key_[cell] = kTaken;
    queues_[std::max(k, level)].push_back(static_cast<std::uint32_t>(cell));
  }
  //! Cells beside each other. Of those that are reached at this level only the first in a row is noted: it
  //! takes the others with it.
  void reachRow(std::size_t from, std::size_t count, std::uint8_t level) {
    bool isNoted = false;
    for (std::size_t i = from; i < from + count; ++i) {
      if (i + 8 <= from + count && areTaken(i)) {
        i += 7;
        isNoted = false;
        continue;
      }
      const bool joins = key_[i] <= level;
      if (!(joins && isNoted)) reach(i, level);
      isNoted = joins;
    }
  }
  //! Eight of them.
  bool areTaken(std::size_t first) const {
    static_assert(kTaken == 0xfe);
    return eightCells(&key_[first]) == 0xfefefefefefefefeU;
  }
  void load(const Levels& key) {
    std::fill(key_.begin(), key_.end(), kBorder);
    std::fill(level_.begin(), level_.end(), kNever);
    forRows([&](std::size_t from, std::size_t to, std::size_t n) {
      std::copy_n(key.begin() + static_cast<std::ptrdiff_t>(from), n,
                  key_.begin() + static_cast<std::ptrdiff_t>(to));
    });
  }
  Levels unload() const {
    Levels out(cells_.count());
    forRows([&](std::size_t to, std::size_t from, std::size_t n) {
      std::copy_n(level_.begin() + static_cast<std::ptrdiff_t>(from), n,
                  out.begin() + static_cast<std::ptrdiff_t>(to));
    });
    return out;
  }
  template <typename F>
  void forRows(F&& f) const {
    for (int z = 0; z < cells_.grid.size[2]; ++z)
      for (int y = 0; y < cells_.grid.size[1]; ++y)
        f(cells_.at(0, y, z), padded(0, idx(y), idx(z)), idx(cells_.grid.size[0]));
  }

  const CellGrid& cells_;
  int nx_, ny_;
  double most_, mostBorder_ = 0;
  int end_ = 0;
  std::size_t taken_ = 0, border_ = 0;
  Levels key_, level_;
  std::array<std::vector<std::uint32_t>, kNever + 1> queues_;
};

std::vector<ArrivalMap> mapsOfBand(const CellGrid& cells, const RungImage& rungs, const Cell& click, int band,
                                   const ObjectPolicy& policy) {
  Flood flood(cells, policy);
  Levels key(cells.count());
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = rungs.above[i] <= band ? rungs.below[i] : kNever;
  const std::vector<OpeningPass> passes = passesOf(cells, policy);
  std::vector<ArrivalMap> maps;
  Morphology morphology(cells.grid.size);
  Levels eroded = key;
  int done = 0;
  for (const int n : policy.openings) {
    giveUpIfCancelled();
    for (; done < n; ++done) morphology.highest(eroded, passes[done]);
    const std::size_t start = startNear(cells, eroded, click, n, policy);
    if (eroded[start] >= kNever) continue;
    ArrivalMap map{band, n, n * policy.passLength * cells.grid.meanSpacing(), 0, 0, flood.run(eroded, start)};
    map.end = flood.end();
    for (int p = n; p-- > 0;) morphology.lowest(map.level, passes[p]);
    if (n > 0)
      std::transform(map.level.begin(), map.level.end(), key.begin(), map.level.begin(),
                     [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    maps.push_back(std::move(map));
  }
  return maps;
}

}  // namespace

double noiseAround(const CellGrid& cells, const std::vector<float>& raw, const Cell& click, int reach) {
  std::vector<double> differences;
  std::size_t step = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const int n = cells.grid.size[a];
    if (n >= 5)
      forBox(cells, click, reach, [&](const Cell& c) {
        if (c[a] < 1 || c[a] > n - 2) return;
        const std::size_t i = cells.at(c);
        const double d = static_cast<double>(raw[i - step]) + raw[i + step] - 2.0 * raw[i];
        if (d != 0) differences.push_back(std::abs(d));  // padding and saturation say nothing
      });
    step *= idx(n);
  }
  return differences.empty() ? 0 : quantile(std::move(differences), 0.5) / (0.6745 * std::sqrt(6.0));
}

ClickIntensities readClick(const CellGrid& cells, const std::vector<float>& raw,
                           const std::vector<float>& values, const Cell& click, const ObjectPolicy& policy) {
  std::vector<double> near, around;
  forBox(cells, click, 1, [&](const Cell& c) { near.push_back(values[cells.at(c)]); });
  forBox(cells, click, policy.rangeCells, [&](const Cell& c) { around.push_back(values[cells.at(c)]); });
  ClickIntensities out;
  out.level = quantile(std::move(near), 0.5);
  // A small object may lie beyond nearly all that is around it.
  const double low = std::min(quantile(around, policy.outliers), out.level);
  out.range = std::max(quantile(std::move(around), 1 - policy.outliers), out.level) - low;
  out.noise = std::clamp(noiseAround(cells, raw, click, policy.noiseCells), policy.leastNoise * out.range,
                         policy.mostNoise * out.range);
  const double ratio = policy.lastRung / policy.firstRung;
  for (int i = 0; i < kRungs; ++i)
    out.ladder[i] = static_cast<float>(out.range * policy.firstRung * std::pow(ratio, i / (kRungs - 1.0)));
  return out;
}

RungImage rungsOf(const CellImage& image, const std::vector<float>& values, const Cell& click,
                  const ClickIntensities& in) {
  const auto rung = [&](double distance) {
    return static_cast<std::uint8_t>(
        std::lower_bound(in.ladder.begin(), in.ladder.end(), static_cast<float>(distance)) -
        in.ladder.begin());
  };
  RungImage out{Levels(values.size()), Levels(values.size())};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double d = values[i] - in.level;
    out.below[i] = image.padding[i] ? kNever : rung(-d);
    out.above[i] = image.padding[i] ? kNever : rung(d);
  }
  // The click is inside whatever the noise there.
  forBox(image.cells, click, 1, [&](const Cell& c) {
    const std::size_t i = image.cells.at(c);
    if (!image.padding[i]) out.below[i] = out.above[i] = 0;
  });
  return out;
}

std::vector<ArrivalMap> arrivalMaps(const CellGrid& cells, const RungImage& rungs, const Cell& click,
                                    const ObjectPolicy& policy, int threads) {
  std::array<std::vector<ArrivalMap>, std::tuple_size_v<decltype(policy.bands)>> parts;
  forEachOnThreads(parts.size(), threads, [&](std::size_t b) {
    parts[b] = mapsOfBand(cells, rungs, click, policy.bands[b], policy);
  });
  std::vector<ArrivalMap> out;
  for (auto& part : parts) std::move(part.begin(), part.end(), std::back_inserter(out));
  return out;
}

}  // namespace handlebody
