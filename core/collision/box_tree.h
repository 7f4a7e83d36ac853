#pragma once
// Pairs of boxes by a tree: those that overlap, for meshes whose edges are too uneven for the spatial hash,
// and the best ones of two sets. O(n log n) to build and linear in memory whatever the sizes.

#include <span>
#include <utility>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

struct Box {
  Vec3 low;
  Vec3 high;

  bool overlaps(const Box& other) const {
    return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
           other.low.y() <= high.y() && low.z() <= other.high.z() && other.low.z() <= high.z();
  }
};

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Box> boxes) { build(boxes); }
  void build(std::span<const Box> boxes);

  //! Calls f(i, j) once for each pair of boxes that overlap (touching counts).
  template <typename F>
  void forEachOverlap(F&& f) const {
    if (nodes_.empty()) return;
    stack_.assign(1, {0, 0});
    while (!stack_.empty()) {
      const auto [a, b] = stack_.back();
      stack_.pop_back();
      visit(a, b, f);
    }
  }

  //! Calls f(i, j) for pairs of a box i of this tree and a box j of another (it may be the same). `bound(p,
  //! q)` is what boxes in the boxes p and q can reach at best, in the sense that larger is better; pairs that
  //! are not `hopeful(bound)` are left out, and the better half goes first.
  template <typename Bound, typename Hopeful, typename F>
  void forEachHopeful(const BoxTree& other, Bound&& bound, Hopeful&& hopeful, F&& f) const;

 private:
  static constexpr int kLeafSize = 4;
  struct Node {
    Box box;
    int first, last;  // into order_
    int right;        // the left child follows its parent; 0: a leaf
  };
  struct NodePair {
    int a, b;
  };

  int buildNode(std::span<const Box> boxes, int first, int last);
  template <typename F>
  void visit(int a, int b, F&& f) const;
  template <typename F>
  void visitLeaves(const Node& a, const Node& b, F&& f) const;

  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::vector<Box> boxes_;  // in that order
  mutable std::vector<NodePair> stack_;
};

template <typename F>
void BoxTree::visit(int a, int b, F&& f) const {
  const Node& na = nodes_[a];
  const Node& nb = nodes_[b];
  if (!na.box.overlaps(nb.box)) return;
  const bool leafA = na.right == 0;
  const bool leafB = nb.right == 0;
  if (leafA && leafB) {
    visitLeaves(na, nb, f);
  } else if (a == b) {
    stack_.insert(stack_.end(), {{a + 1, a + 1}, {a + 1, na.right}, {na.right, na.right}});
  } else if (leafB || (!leafA && na.last - na.first >= nb.last - nb.first)) {
    stack_.insert(stack_.end(), {{a + 1, b}, {na.right, b}});
  } else {
    stack_.insert(stack_.end(), {{a, b + 1}, {a, nb.right}});
  }
}

template <typename F>
void BoxTree::visitLeaves(const Node& a, const Node& b, F&& f) const {
  for (int i = a.first; i < a.last; ++i) {
    for (int j = &a == &b ? i + 1 : b.first; j < b.last; ++j) {
      const auto si = static_cast<std::size_t>(i);
      const auto sj = static_cast<std::size_t>(j);
      if (boxes_[si].overlaps(boxes_[sj])) f(order_[si], order_[sj]);
    }
  }
}

template <typename Bound, typename Hopeful, typename F>
void BoxTree::forEachHopeful(const BoxTree& other, Bound&& bound, Hopeful&& hopeful, F&& f) const {
  struct Waiting {
    int a, b;
    double bound;
  };
  if (nodes_.empty() || other.nodes_.empty()) return;
  const auto nodeA = [&](int i) -> const Node& { return nodes_[i]; };
  const auto nodeB = [&](int i) -> const Node& { return other.nodes_[i]; };
  const auto waiting = [&](int i, int j) { return Waiting{i, j, bound(nodeA(i).box, nodeB(j).box)}; };
  std::vector<Waiting> stack{waiting(0, 0)};
  while (!stack.empty()) {
    const Waiting w = stack.back();
    stack.pop_back();
    if (!hopeful(w.bound)) continue;
    const Node &na = nodeA(w.a), &nb = nodeB(w.b);
    if (na.right == 0 && nb.right == 0) {
      for (int i = na.first; i < na.last; ++i)
        for (int j = nb.first; j < nb.last; ++j) f(order_[i], other.order_[j]);
      continue;
    }
    const bool splitA = na.right != 0 && (nb.right == 0 || na.last - na.first >= nb.last - nb.first);
    Waiting worse = splitA ? waiting(w.a + 1, w.b) : waiting(w.a, w.b + 1);
    Waiting better = splitA ? waiting(na.right, w.b) : waiting(w.a, nb.right);
    if (worse.bound > better.bound) std::swap(worse, better);
    stack.push_back(worse);
    stack.push_back(better);
  }
}

}  // namespace handlebody
