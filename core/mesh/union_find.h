#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace handlebody {

//! Disjoint sets over 0 … n-1. The representative of a set is its lowest member, whatever the order of
//! joining.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(int a, int b) {
    a = find(a);
    b = find(b);
    at(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

}  // namespace handlebody
