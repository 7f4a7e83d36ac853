#include "core/handles/cross_edges.h"

#include <algorithm>
#include <cassert>

namespace handlebody {

CrossEdges::CrossEdges(std::span<const std::vector<Vec3>> loops, std::span<const VertexPair> forbiddenEdges) {
  std::vector<Vec3> points;
  first_.push_back(0);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    points.insert(points.end(), loops[i].begin(), loops[i].end());
    loop_.resize(points.size(), static_cast<int>(i));
    first_.push_back(static_cast<int>(points.size()));
  }
  length_.assign(points.size() * points.size(), kNone);
  for (std::size_t u = 0; u < points.size(); ++u) {
    for (std::size_t v = 0; v < u; ++v) {
      const double length = (points[u] - points[v]).norm();
      if (loop_[u] == loop_[v] || !(length < kNone)) continue;
      length_[u * points.size() + v] = length_[v * points.size() + u] = length;
    }
  }
  forbid(forbiddenEdges);
}

void CrossEdges::forbid(std::span<const VertexPair> edges) {
  for (const auto& [u, v] : edges) {
    assert(u >= 0 && u < vertexCount() && v >= 0 && v < vertexCount());
    length_[idx(u) * loop_.size() + idx(v)] = length_[idx(v) * loop_.size() + idx(u)] = kNone;
  }
}

void CrossEdges::forbid(std::span<const Triangle> faces) {
  for (Triangle face : faces) {
    std::sort(face.begin(), face.end());
    forbiddenFaces_.push_back(face);
    isCorner_.resize(loop_.size(), 0);
    for (const int v : face) isCorner_[v] = 1;
  }
  std::sort(forbiddenFaces_.begin(), forbiddenFaces_.end());
}

double CrossEdges::lengthOf(std::span<const Triangle> faces) const {
  std::vector<VertexPair> pairs;
  for (const Triangle& t : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [u, v] = std::minmax(t[i], t[(i + 1) % 3]);
      if (loopOf(u) != loopOf(v)) pairs.push_back({u, v});
    }
  }
  sortUnique(pairs);
  double sum = 0;
  for (const auto& [u, v] : pairs) sum += length(u, v);
  return sum;
}

bool CrossEdges::isForbidden(const Triangle& face) const {
  Triangle corners = face;
  std::sort(corners.begin(), corners.end());
  return std::binary_search(forbiddenFaces_.begin(), forbiddenFaces_.end(), corners);
}

}  // namespace handlebody
