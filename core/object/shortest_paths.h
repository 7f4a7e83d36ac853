#pragma once
// Shortest paths through cells (Dijkstra 1959).

#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace handlebody {

//! Lowers `lengths`, 0 where paths start and infinite elsewhere, to those of the shortest paths; beyond the
//! limit they stay infinite. `forNeighbours(cell, f)` calls f(neighbour, what step() has to know of the way);
//! `step(cell, neighbour, that)` is the length of a step.
template <typename Neighbours, typename Step>
void followShortestPaths(std::vector<float>& lengths, double limit, Neighbours&& forNeighbours, Step&& step) {
  using Entry = std::pair<float, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto goOnFrom = [&](std::size_t cell) {
    const float so = lengths[cell];
    forNeighbours(cell, [&](std::size_t next, const auto& way) {
      if (lengths[next] <= so) return;
      const auto there = static_cast<float>(so + step(cell, next, way));
      if (!(there <= limit && there < lengths[next])) return;
      lengths[next] = there;
      queue.push({there, next});
    });
  };
  for (std::size_t cell = 0; cell < lengths.size(); ++cell)
    if (lengths[cell] == 0) goOnFrom(cell);
  while (!queue.empty()) {
    const auto [length, cell] = queue.top();
    queue.pop();
    if (length <= lengths[cell]) goOnFrom(cell);
  }
}

}  // namespace handlebody
