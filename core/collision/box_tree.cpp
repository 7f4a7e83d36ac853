#include "core/collision/box_tree.h"

#include <algorithm>
#include <numeric>

namespace handlebody {

void BoxTree::build(std::span<const Box> boxes) {
  nodes_.clear();
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes.empty()) buildNode(boxes, 0, static_cast<int>(boxes.size()));
  boxes_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes_[i] = boxes[order_[i]];
}

//! Halves at the median along the longest axis, so the depth is at most log2 of the number of boxes.
int BoxTree::buildNode(std::span<const Box> boxes, int first, int last) {
  const int node = static_cast<int>(nodes_.size());
  Box all = boxes[order_[first]];
  for (int i = first + 1; i < last; ++i) {
    const Box& b = boxes[order_[i]];
    all.low = all.low.cwiseMin(b.low);
    all.high = all.high.cwiseMax(b.high);
  }
  nodes_.push_back({all, first, last, 0});
  if (last - first <= kLeafSize) return node;
  Eigen::Index axis = 0;
  (all.high - all.low).maxCoeff(&axis);
  const auto middleOf = [&](int i) {
    const Box& b = boxes[i];
    return b.low[axis] + b.high[axis];
  };
  const int middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](int i, int j) { return middleOf(i) < middleOf(j); });
  buildNode(boxes, first, middle);
  const int right = buildNode(boxes, middle, last);
  nodes_[node].right = right;
  return node;
}

}  // namespace handlebody
