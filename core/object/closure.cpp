#include "core/object/closure.h"

#include <algorithm>
#include <cmath>

#include "core/cancellation.h"

namespace handlebody {

namespace {
constexpr double kPerUnit = 1024;
}

Closure::Closure(std::size_t nodes, const std::vector<std::array<std::size_t, 2>>& pairs)
    : through_(pairs.size(), 0), pairOf_(pairs.size()), level_(nodes) {
  for (Ways* ways : {&pairs_, &back_}) {
    ways->first.assign(nodes + 1, 0);
    ways->to.resize(pairs.size());
  }
  for (const auto& [a, b] : pairs) ++pairs_.first[a + 1], ++back_.first[b + 1];
  for (std::size_t i = 0; i < nodes; ++i)
    for (Ways* ways : {&pairs_, &back_}) ways->first[i + 1] += ways->first[i];
  std::vector<std::uint32_t> pair(pairs_.first), back(back_.first);
  for (const auto& [a, b] : pairs) {
    const std::uint32_t p = pair[a]++, q = back[b]++;
    pairs_.to[p] = static_cast<std::uint32_t>(b);
    back_.to[q] = static_cast<std::uint32_t>(a);
    pairOf_[q] = p;
  }
}

// From the sink backwards: so no path that is followed leads where it cannot go on.
bool Closure::setLevels() {
  std::fill(level_.begin(), level_.end(), -1);
  queue_.clear();
  const auto reach = [&](std::uint32_t i, std::int32_t level) {
    if (level_[i] >= 0) return;
    level_[i] = level;
    queue_.push_back(i);
  };
  for (std::uint32_t i = 0; i < level_.size(); ++i)
    if (sink_[i] > 0) reach(i, 0);
  bool reachesSource = false;
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const std::uint32_t i = queue_[k];
    reachesSource = reachesSource || source_[i] > 0;
    for (std::uint32_t q = back_.first[i]; q < back_.first[i + 1]; ++q) reach(back_.to[q], level_[i] + 1);
    for (std::uint32_t p = pairs_.first[i]; p < pairs_.first[i + 1]; ++p)
      if (through_[p] > 0) reach(pairs_.to[p], level_[i] + 1);
  }
  return reachesSource;
}

// Depth first; no path is longer than there are levels.
Closure::Flow Closure::push(std::uint32_t node, Flow most) {
  if (level_[node] == 0) {
    const Flow pushed = std::min(most, sink_[node]);
    sink_[node] -= pushed;
    return pushed;
  }
  Flow pushed = 0;
  for (std::uint32_t& p = nextPair_[node]; p < pairs_.first[node + 1]; ++p) {
    if (level_[pairs_.to[p]] != level_[node] - 1) continue;
    const Flow got = push(pairs_.to[p], most - pushed);
    through_[p] += got;
    pushed += got;
    if (pushed == most) return pushed;
  }
  for (std::uint32_t& q = nextBack_[node]; q < back_.first[node + 1]; ++q) {
    Flow& left = through_[pairOf_[q]];
    if (level_[back_.to[q]] != level_[node] - 1 || left <= 0) continue;
    const Flow got = push(back_.to[q], std::min(most - pushed, left));
    left -= got;
    pushed += got;
    if (pushed == most) return pushed;
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
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const std::uint32_t i = queue_[k];
    for (std::uint32_t p = pairs_.first[i]; p < pairs_.first[i + 1]; ++p) reach(pairs_.to[p]);
    for (std::uint32_t q = back_.first[i]; q < back_.first[i + 1]; ++q)
      if (through_[pairOf_[q]] > 0) reach(back_.to[q]);
  }
  return in;
}

std::vector<std::uint8_t> Closure::cheapest(const std::vector<double>& costs) {
  std::fill(through_.begin(), through_.end(), 0);
  source_.assign(costs.size(), 0);
  sink_.assign(costs.size(), 0);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const auto c = static_cast<Flow>(std::llround(costs[i] * kPerUnit));
    (c < 0 ? source_ : sink_)[i] = std::abs(c);
  }
  while (setLevels()) {
    giveUpIfCancelled();
    nextPair_.assign(pairs_.first.begin(), pairs_.first.end() - 1);
    nextBack_.assign(back_.first.begin(), back_.first.end() - 1);
    for (std::size_t k = 0; k < queue_.size(); ++k)
      if (const std::uint32_t i = queue_[k]; source_[i] > 0) source_[i] -= push(i, source_[i]);
  }
  return reachedFromSources();
}

}  // namespace handlebody
