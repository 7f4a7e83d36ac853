#include "core/object/closure.h"

#include <algorithm>
#include <cmath>

#include "core/cancellation.h"

namespace handlebody {

namespace {
constexpr double kPerUnit = 1024;
}

Closure::Closure(std::size_t nodes, const std::vector<std::array<std::size_t, 2>>& pairs)
    : first_(nodes + 1, 0), arcs_(2 * pairs.size()), level_(nodes), next_(nodes) {
  for (const auto& [a, b] : pairs) ++first_[a + 1], ++first_[b + 1];
  for (std::size_t i = 0; i < nodes; ++i) first_[i + 1] += first_[i];
  std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
  for (const auto& [a, b] : pairs) {
    const std::uint32_t there = at[a]++, back = at[b]++;
    arcs_[there] = {static_cast<std::uint32_t>(b), back, true, 0};
    arcs_[back] = {static_cast<std::uint32_t>(a), there, false, 0};
  }
}

// From the sink backwards: so no path that is followed leads where it cannot go on.
bool Closure::setLevels() {
  std::fill(level_.begin(), level_.end(), -1);
  queue_.clear();
  for (std::uint32_t i = 0; i < level_.size(); ++i)
    if (sink_[i] > 0) {
      level_[i] = 0;
      queue_.push_back(i);
    }
  bool reachesSource = false;
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const std::uint32_t i = queue_[k];
    reachesSource = reachesSource || source_[i] > 0;
    for (std::uint32_t a = first_[i]; a < first_[i + 1]; ++a) {
      const Arc& arc = arcs_[a];
      if (level_[arc.to] >= 0 || (arc.isFree && arcs_[arc.opposite].left <= 0)) continue;
      level_[arc.to] = level_[i] + 1;
      queue_.push_back(arc.to);
    }
  }
  return reachesSource;
}

// Depth first; no path is longer than there are levels.
Closure::Flow Closure::push(std::uint32_t node, Flow most) {
  Flow pushed = 0;
  if (level_[node] == 0) {
    pushed = std::min(most, sink_[node]);
    sink_[node] -= pushed;
    return pushed;
  }
  for (std::uint32_t& a = next_[node]; a < first_[node + 1]; ++a) {
    Arc& arc = arcs_[a];
    if (level_[arc.to] != level_[node] - 1 || (!arc.isFree && arc.left <= 0)) continue;
    const Flow got = push(arc.to, arc.isFree ? most - pushed : std::min(most - pushed, arc.left));
    (arc.isFree ? arcs_[arc.opposite].left : arc.left) += arc.isFree ? got : -got;
    pushed += got;
    if (pushed == most) break;
  }
  return pushed;
}

// What is still reached from sources with something left: the smallest of the cheapest sets.
std::vector<std::uint8_t> Closure::reachedFromSources() {
  std::vector<std::uint8_t> in(source_.size(), 0);
  queue_.clear();
  const auto reach = [&](std::uint32_t i) {
    if (in[i]) return;
    in[i] = 1;
    queue_.push_back(i);
  };
  for (std::uint32_t i = 0; i < source_.size(); ++i)
    if (source_[i] > 0) reach(i);
  for (std::size_t k = 0; k < queue_.size(); ++k)
    for (std::uint32_t a = first_[queue_[k]]; a < first_[queue_[k] + 1]; ++a)
      if (arcs_[a].isFree || arcs_[a].left > 0) reach(arcs_[a].to);
  return in;
}

std::vector<std::uint8_t> Closure::cheapest(const std::vector<double>& costs) {
  for (Arc& a : arcs_) a.left = 0;
  source_.assign(costs.size(), 0);
  sink_.assign(costs.size(), 0);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const auto c = static_cast<Flow>(std::llround(costs[i] * kPerUnit));
    (c < 0 ? source_ : sink_)[i] = std::abs(c);
  }
  while (setLevels()) {
    giveUpIfCancelled();
    std::copy(first_.begin(), first_.end() - 1, next_.begin());
    for (std::uint32_t i = 0; i < source_.size(); ++i)
      if (source_[i] > 0 && level_[i] >= 0) source_[i] -= push(i, source_[i]);
  }
  return reachedFromSources();
}

}  // namespace handlebody
