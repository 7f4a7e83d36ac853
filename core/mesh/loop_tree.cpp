#include "core/mesh/loop_tree.h"

#include <limits>
#include <queue>

#include "core/cancellation.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

LoopGraph::LoopGraph(const Mesh& mesh, const LoopClasses& classes) : mesh_(mesh) {
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    first_.push_back(arcs_.size());
    mesh.forEachOutgoing(v, [&](int h) {
      const int w = mesh.target(h);
      arcs_.push_back({h, w, (mesh.position(w) - mesh.position(v)).norm(), classes.key(h)});
    });
  }
  first_.push_back(arcs_.size());
}

double LoopGraph::lengthOf(std::span<const int> loop) const {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (mesh_.position(loop[(i + 1) % loop.size()]) - mesh_.position(loop[i])).norm();
  return length;
}

LoopTree::LoopTree(const LoopGraph& graph) : graph_(&graph) {
  const std::size_t n = idx(graph.mesh().vertexSlots());
  distance_.assign(n, kFar);
  parent_.assign(n, -1);
  key_.assign(n, {});
}

void LoopTree::spread(int base, double radius) {
  giveUpIfCancelled();
  for (const int v : reached_) distance_[v] = kFar;
  reached_.clear();
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance_[base] = 0;
  parent_[base] = -1;
  key_[base] = {};
  reached_.push_back(base);
  queue.emplace(0, base);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance_[v]) continue;
    for (const LoopGraph::Arc& arc : graph_->arcs(v)) {
      const double there = d + arc.length;
      double& known = distance_[arc.target];
      if (there >= known || there > radius) continue;
      if (known == kFar) reached_.push_back(arc.target);
      known = there;
      parent_[arc.target] = arc.halfedge;
      key_[arc.target] = key_[v];
      key_[arc.target] += arc.key;
      queue.emplace(there, arc.target);
    }
  }
}

std::vector<int> LoopTree::loopOf(const LoopGraph::Arc& arc) const {
  const Mesh& mesh = graph_->mesh();
  return loopOfPaths(mesh.origin(arc.halfedge), arc.target,
                     [&](int v) { return parent_[v] >= 0 ? mesh.origin(parent_[v]) : -1; });
}

}  // namespace handlebody
