#include "core/evolution/space_tree.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "core/evolution/wide_runs.h"

namespace handlebody {

SpaceTree::SpaceTree(const std::array<int, 3>& size, const std::vector<float>& radius)
    : size_(size), radius_(radius) {
  const std::ptrdiff_t row = size_[0], slab = row * size_[1];
  std::size_t n = 0;
  for (int dz = 0; dz <= 1; ++dz)
    for (int dy = dz == 0 ? 0 : -1; dy <= 1; ++dy)
      for (int dx = dz == 0 && dy == 0 ? 1 : -1; dx <= 1; ++dx) forward_[n++] = dx + dy * row + dz * slab;
  findBasins();
  findBorders();
}

void SpaceTree::findBasins() {
  basin_.assign(radius_.size(), -1);
  const auto count = static_cast<std::int32_t>(radius_.size());
  for (std::int32_t c = 0; c < count; ++c) {
    const float* here = &radius_[c];
    if (*here <= 0) continue;
    float widest = *here;
    std::ptrdiff_t to = 0;
    const auto look = [&](std::ptrdiff_t step) {
      if (here[step] < widest || (here[step] == widest && step > to)) return;
      widest = here[step];
      to = step;
    };
    for (std::size_t n = forward_.size(); n-- > 0;) look(-forward_[n]);
    for (const std::ptrdiff_t step : forward_) look(step);
    basin_[c] = c + static_cast<std::int32_t>(to);
  }
  std::vector<std::int32_t> way;
  for (std::int32_t c = 0; c < count; ++c) {
    if (basin_[c] < 0) continue;
    std::int32_t at = c;
    for (way.clear(); basin_[at] != at; at = basin_[at]) way.push_back(at);
    for (const std::int32_t w : way) basin_[w] = at;
  }
  // From peaks to numbers: every cell's peak is told by its place, which is not its number yet.
  std::vector<std::int32_t> numbers(radius_.size(), -1);
  for (std::int32_t c = 0; c < count; ++c)
    if (basin_[c] == c) {
      numbers[c] = static_cast<std::int32_t>(spaces_.size());
      spaces_.push_back({static_cast<std::uint32_t>(c)});
    }
  for (std::int32_t& b : basin_)
    if (b >= 0) b = numbers[b];
}

void SpaceTree::findBorders() {
  std::unordered_map<std::uint64_t, std::size_t> known;  // two basins → border
  for (std::size_t c = 0; c < radius_.size(); ++c) {
    const std::int32_t own = basin_[c];
    if (own < 0) continue;
    for (const std::ptrdiff_t step : forward_) {
      const std::size_t n = c + static_cast<std::size_t>(step);
      if (basin_[n] < 0 || basin_[n] == own) continue;
      const auto a = static_cast<std::uint32_t>(std::min(own, basin_[n]));
      const auto b = static_cast<std::uint32_t>(std::max(own, basin_[n]));
      const std::size_t narrow = radius_[n] < radius_[c] ? n : c;
      const Border border{radius_[narrow], static_cast<std::uint32_t>(narrow), a, b};
      const auto [at, isNew] = known.try_emplace((std::uint64_t{a} << 32) | b, borders_.size());
      if (isNew)
        borders_.push_back(border);
      else if (border.level > borders_[at->second].level)
        borders_[at->second] = border;
    }
  }
  std::sort(borders_.begin(), borders_.end(), [](const Border& x, const Border& y) {
    if (x.level != y.level) return x.level > y.level;
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
}

std::uint32_t SpaceTree::find(std::uint32_t basin) {
  while (parent_[basin] != basin) basin = parent_[basin] = parent_[parent_[basin]];
  return basin;
}

std::vector<Merging> SpaceTree::merge(std::span<const std::uint32_t> starts, const NarrowRule& rule) {
  parent_.resize(spaces_.size());
  std::iota(parent_.begin(), parent_.end(), 0u);
  marks_.assign(spaces_.size(), 0);
  told_.clear();
  start(starts);
  for (const Border& border : borders_) join(border, rule);
  judgeUnconnected(rule);
  return told_;
}

void SpaceTree::start(std::span<const std::uint32_t> starts) {
  for (Space& space : spaces_) {
    space.isStarted = false;
    space.past.clear();
  }
  for (const std::uint32_t cell : starts) {
    if (basin_[cell] < 0) continue;
    Space& space = spaces_[basin_[cell]];
    space.isStarted = true;
    space.past = {{peakOf(space), peakOf(space)}};
  }
}

void SpaceTree::join(const Border& border, const NarrowRule& rule) {
  std::uint32_t into = find(border.a), from = find(border.b);
  if (into == from) return;
  const bool isInto = spaces_[into].isStarted, isFrom = spaces_[from].isStarted;
  if (isInto != isFrom) judge(border, spaces_[isInto ? into : from], isInto ? from : into, rule);
  if (peakOf(spaces_[from]) > peakOf(spaces_[into])) std::swap(into, from);
  Space &wide = spaces_[into], &other = spaces_[from];
  wide.isStarted = isInto || isFrom;
  wide.past.insert(wide.past.end(), other.past.begin(), other.past.end());
  if (wide.isStarted && (wide.past.empty() || wide.past.back().widest < peakOf(wide) || isInto != isFrom))
    wide.past.push_back({border.level, peakOf(wide)});
  other.past = {};
  parent_[from] = into;
}

namespace {

template <typename Pasts>
double widestAbove(const Pasts& pasts, double level) {
  double widest = 0;
  for (const auto& past : pasts)
    if (static_cast<double>(past.level) >= level) widest = std::max(widest, static_cast<double>(past.widest));
  return widest;
}

bool isNarrow(const Merging& m, const NarrowRule& rule) {
  return m.level <= rule.narrow * std::min(m.before, m.behind) && m.behind >= rule.leastBehind &&
         m.behind >= rule.leastPart * m.before;
}

bool isWidening(const Merging& m, const NarrowRule& rule) {
  return m.behind >= rule.leastBehind && m.behind >= rule.widening * m.before;
}

}  // namespace

void SpaceTree::judge(const Border& border, const Space& before, std::uint32_t behind,
                      const NarrowRule& rule) {
  const double level = static_cast<double>(border.level);
  Merging m{level, border.at, widestAbove(before.past, rule.above * level),
            static_cast<double>(peakOf(spaces_[behind])), spaces_[behind].peak};
  if (!isNarrow(m, rule)) {
    m.before = std::max(level, widestAbove(before.past, 0));
    m.isWidening = true;
    if (!isWidening(m, rule)) return;
  }
  if (told_.size() >= kMaxPassages) return;
  told_.push_back(m);
  for (std::uint32_t b = 0; b < marks_.size(); ++b)
    if (find(b) == behind) marks_[b] = static_cast<std::uint8_t>(told_.size());
}

//! What the cells do not connect with a start.
void SpaceTree::judgeUnconnected(const NarrowRule& rule) {
  double before = 0;
  for (const Space& space : spaces_) before = std::max(before, widestAbove(space.past, 0));
  for (std::uint32_t b = 0; b < spaces_.size() && before > 0; ++b) {
    if (find(b) != b || spaces_[b].isStarted) continue;
    const Merging m{0, 0, before, static_cast<double>(peakOf(spaces_[b])), spaces_[b].peak};
    if (!isNarrow(m, rule) || told_.size() >= kMaxPassages) continue;
    told_.push_back(m);
    for (std::uint32_t other = 0; other < marks_.size(); ++other)
      if (find(other) == b) marks_[other] = static_cast<std::uint8_t>(told_.size());
  }
}

namespace {

constexpr std::size_t kMaxWidths = 32;
constexpr double kLess = 0.999;  // of the next width, so that rounding decides nothing

}  // namespace

//! Where what is as wide as w hangs together, a border in the tree's order joins every peak of at least w
//! with a start before one lower than w comes: the level is at least w, and so is what lies before it. What
//! lies behind is not wide enough beside that, to be told, up to the next width that is looked at.
bool surelyTellsNothing(const std::array<int, 3>& size, const std::vector<float>& radius,
                        std::span<const std::uint32_t> starts, const NarrowRule& rule) {
  if (std::none_of(starts.begin(), starts.end(), [&](std::uint32_t s) { return radius[s] > 0; })) return true;
  const double factor = kLess * std::min(1 / rule.narrow, rule.widening);
  const double widest = static_cast<double>(*std::max_element(radius.begin(), radius.end()));
  if (!(rule.leastBehind > 0) || factor < 1.1) return false;
  std::vector<double> widths;
  for (double w = rule.leastBehind; w <= widest; w *= factor) widths.push_back(w);
  if (widths.size() > kMaxWidths) return false;
  WideRuns runs(size, radius, Touching::corners);
  for (std::size_t w = widths.size(); w-- > 0;)  // the fewest cells first
    if (!runs.allHold(starts, widths[w])) return false;
  return true;
}

}  // namespace handlebody
