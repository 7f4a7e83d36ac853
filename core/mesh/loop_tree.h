#pragma once
// Shortest paths along the edges of a surface from one vertex, and the loops that two of them make with an
// edge.

#include <algorithm>
#include <span>
#include <vector>

#include "core/mesh/loop_classes.h"

namespace handlebody {

//! The nodes of a loop that two paths of a tree make: from the place where they part, to one end, to the
//! other and back. parent(n): the node before n; negative at the base.
template <typename Parent>
std::vector<int> loopOfPaths(int oneEnd, int otherEnd, Parent&& parent) {
  const auto toBase = [&](int n) {
    std::vector<int> out{n};
    while ((n = parent(n)) >= 0) out.push_back(n);
    return out;
  };
  std::vector<int> there = toBase(oneEnd), back = toBase(otherEnd);
  while (there.size() > 1 && back.size() > 1 && there[there.size() - 2] == back[back.size() - 2]) {
    there.pop_back();
    back.pop_back();
  }
  std::reverse(there.begin(), there.end());
  there.insert(there.end(), back.begin(), back.end() - 1);
  return there;
}

//! The edges at each vertex, in flat arrays. Any number of trees may use it.
class LoopGraph {
 public:
  struct Arc {
    int halfedge, target;
    double length;  //!< mm
    ClassKey key;   //!< of the half-edge, beside what else is asked of it
  };
  //! The mesh must outlive it.
  LoopGraph(const Mesh& mesh, const LoopClasses& classes);
  std::span<const Arc> arcs(int v) const {
    return std::span(arcs_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  const Mesh& mesh() const { return mesh_; }
  //! mm, of a closed loop along edges.
  double lengthOf(std::span<const int> loop) const;

 private:
  const Mesh& mesh_;
  std::vector<std::size_t> first_;
  std::vector<Arc> arcs_;
};

//! Keeps its tables from one vertex to the next.
class LoopTree {
 public:
  //! The graph must outlive it.
  explicit LoopTree(const LoopGraph& graph);

  //! The shortest paths from `base` that are not longer than `radius` (mm). Throws Cancelled.
  void spread(int base, double radius);

  //! Of the last base, per vertex: the length of the shortest path, mm; infinite beyond the radius.
  std::span<const double> distances() const { return distance_; }

  //! f(length, arc, key) for each edge that closes a loop of two paths up to `most` long (mm); key: of the
  //! loop from the base to the arc, along it and back. Both directions of a loop come.
  template <typename F>
  void forEachLoop(double most, F&& f) const {
    for (const int v : reached_)
      for (const LoopGraph::Arc& arc : graph_->arcs(v)) {
        const double length = distance_[v] + arc.length + distance_[arc.target];
        if (length > most || parent_[arc.target] == arc.halfedge) continue;
        ClassKey key = key_[v];
        key += arc.key;
        key -= key_[arc.target];
        f(length, arc, key);
      }
  }

  //! The vertices of the loop that the arc closes, but for what both paths share.
  std::vector<int> loopOf(const LoopGraph::Arc& arc) const;

 private:
  const LoopGraph* graph_;
  std::vector<double> distance_;
  std::vector<int> parent_;  // half-edge that arrives
  std::vector<ClassKey> key_;
  std::vector<int> reached_;
};

}  // namespace handlebody
