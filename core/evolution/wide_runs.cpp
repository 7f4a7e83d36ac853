#include "core/evolution/wide_runs.h"

#include <algorithm>
#include <numeric>

namespace handlebody {

bool WideRuns::allHold(std::span<const std::uint32_t> starts, double width) {
  find(width);
  join();
  std::vector<bool> isHeld(runs_.size(), false);
  for (const std::uint32_t s : starts)
    if (const auto run = runOf(s)) isHeld[root(*run)] = true;
  for (std::uint32_t r = 0; r < runs_.size(); ++r)
    if (!isHeld[root(r)]) return false;
  return true;
}

void WideRuns::find(double width) {
  runs_.clear();
  firstOfRow_.clear();
  const auto n = static_cast<std::uint32_t>(size_[0]);
  const auto isWide = [&](float r) { return static_cast<double>(r) >= width; };
  for (std::uint32_t row = 0; row < radius_.size(); row += n) {
    firstOfRow_.push_back(static_cast<std::uint32_t>(runs_.size()));
    const float* r = &radius_[row];
    for (std::uint32_t x = 0; x < n; ++x) {
      if (!isWide(r[x])) continue;
      const std::uint32_t from = x;
      while (x + 1 < n && isWide(r[x + 1])) ++x;
      runs_.push_back({row + from, row + x});
    }
  }
  firstOfRow_.push_back(static_cast<std::uint32_t>(runs_.size()));
}

//! With those of the rows before that they touch.
void WideRuns::join() {
  parent_.resize(runs_.size());
  std::iota(parent_.begin(), parent_.end(), 0u);
  const std::ptrdiff_t slab = size_[1];
  for (std::ptrdiff_t row = slab + 1; row < std::ssize(firstOfRow_) - 1; ++row) {
    joinRows(row, 1);
    joinRows(row, slab);
    if (touching_ == Touching::faces) continue;
    joinRows(row, slab - 1);
    joinRows(row, slab + 1);
  }
}

void WideRuns::joinRows(std::ptrdiff_t row, std::ptrdiff_t back) {
  const auto first = [&](std::ptrdiff_t r) { return firstOfRow_[r]; };
  const std::uint32_t shift = static_cast<std::uint32_t>(back) * static_cast<std::uint32_t>(size_[0]);
  const std::uint32_t beside = touching_ == Touching::corners ? 1 : 0;
  std::uint32_t b = first(row - back);
  const std::uint32_t endB = first(row - back + 1);
  for (std::uint32_t a = first(row); a < first(row + 1) && b < endB;) {
    const Run &here = runs_[a], there{runs_[b].from + shift, runs_[b].to + shift};
    if (there.to + beside >= here.from && there.from <= here.to + beside) parent_[root(a)] = root(b);
    if (there.to < here.to)
      ++b;
    else
      ++a;
  }
}

std::optional<std::uint32_t> WideRuns::runOf(std::uint32_t cell) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), cell,
                                      [](std::uint32_t c, const Run& r) { return c < r.from; });
  if (after == runs_.begin() || (after - 1)->to < cell) return {};
  return static_cast<std::uint32_t>(after - runs_.begin()) - 1;
}

std::uint32_t WideRuns::root(std::uint32_t run) {
  while (parent_[run] != run) run = parent_[run] = parent_[parent_[run]];
  return run;
}

}  // namespace handlebody
