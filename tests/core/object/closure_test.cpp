#include "core/object/closure.h"

#include <algorithm>
#include <random>

#include "tests/support/catch.h"

using namespace handlebody;

namespace {

using Pairs = std::vector<std::array<std::size_t, 2>>;

bool isClosed(unsigned set, const Pairs& pairs) {
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const auto& p) { return !(set >> p[0] & 1) || (set >> p[1] & 1); });
}

//! The smallest of the cheapest closed sets, by looking at all of them.
unsigned cheapestOfAll(std::size_t nodes, const Pairs& pairs, const std::vector<double>& costs) {
  double least = 0;
  unsigned common = 0;  // what all of the cheapest have; the empty set is closed
  for (unsigned set = 1; set < 1U << nodes; ++set) {
    if (!isClosed(set, pairs)) continue;
    double cost = 0;
    for (std::size_t i = 0; i < nodes; ++i)
      if (set >> i & 1) cost += costs[i];
    if (cost < least) least = cost, common = set;
    if (cost == least) common &= set;
  }
  return common;
}

}  // namespace

TEST_CASE("the closure is the smallest of the cheapest closed sets") {
  std::mt19937 random(7);
  std::size_t nonEmpty = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const std::size_t nodes = 2 + random() % 9;
    Pairs pairs;
    for (std::size_t k = random() % 20; k > 0; --k) {
      const std::size_t a = random() % nodes, b = random() % nodes;
      if (a != b) pairs.push_back({a, b});
    }
    Closure closure(nodes, pairs);
    for (int again = 0; again < 3; ++again) {
      std::vector<double> costs(nodes);
      for (double& c : costs) c = static_cast<double>(random() % 13) / 2 - 3.5;  // exact, with ties
      const std::vector<std::uint8_t> in = closure.cheapest(costs);
      unsigned set = 0;
      for (std::size_t i = 0; i < nodes; ++i) set |= static_cast<unsigned>(in[i]) << i;
      REQUIRE(set == cheapestOfAll(nodes, pairs, costs));
      nonEmpty += set != 0;
    }
  }
  CHECK(nonEmpty > 300);
}
