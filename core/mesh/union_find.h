#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace handlebody {

//! Disjoint sets over 0 … n-1. The representative of a set is its lowest member, whatever the order of
//! joining.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  //! Every i begins in the set of lower[i] <= i. Most of the joining done in this way, without a search,
  //! makes what is left far quicker where members lie in any order.
  explicit UnionFind(std::vector<int> lower) : parent_(std::move(lower)) {
    for (int& p : parent_) p = at(p);
  }

  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(int a, int b) {
    if (at(a) == at(b)) return;  // the rule on a mesh, where neighbours have mostly been joined already
    a = find(a);
    b = find(b);
    at(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& at(int i) { return parent_[i]; }
  std::vector<int> parent_;
};

}  // namespace handlebody
