#pragma once
// The cheapest closed set of nodes: a minimum cut.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace handlebody {

//! Nodes with costs, and which node another one brings along. The cheapest set that holds with each node all
//! that it brings along: Picard (1976), "Maximal closure of a graph"; the maximum flow after Dinic (1970).
class Closure {
 public:
  //! Of each pair, whoever takes the first node takes the second, too.
  Closure(std::size_t nodes, const std::vector<std::array<std::size_t, 2>>& pairs);
  //! 1 for the nodes of the set, the smallest of the cheapest. Costs may be negative; they are rounded to
  //! 1/1024.
  std::vector<std::uint8_t> cheapest(const std::vector<double>& costs);

 private:
  using Flow = std::int64_t;
  //! What leads from nodes to others, in the order of the nodes.
  struct Ways {
    std::vector<std::uint32_t> first, to;  // of each node, and one more; nodes
  };
  bool setLevels();
  Flow push(std::uint32_t node, Flow most);
  std::vector<std::uint8_t> reachedFromSources();

  Ways pairs_, back_;                  // from the first node of a pair to the second, and back
  std::vector<Flow> through_;          // of each pair
  std::vector<std::uint32_t> pairOf_;  // of each way back
  std::vector<Flow> source_, sink_;    // capacities left between each node and the ends
  std::vector<std::int32_t> level_;    // steps to the nodes before the sink; -1 = no way
  std::vector<std::uint32_t> nextPair_, nextBack_, queue_;
};

}  // namespace handlebody
