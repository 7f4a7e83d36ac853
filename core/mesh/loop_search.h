#pragma once
// Short handle and tunnel loops along the edges of a surface: the greedy homology basis of J. Erickson and
// K. Whittlesey, "Greedy optimal homotopy and homology generators" (2005), with few base points, then more
// where the loops found so far run.

#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/loop_classes.h"

namespace handlebody {

//! A simple closed loop along edges.
struct EdgeLoop {
  std::vector<int> vertices;  //!< in order
  double length = 0;          //!< mm
  LoopKind kind = LoopKind::handle;
  ClassKey key;                           //!< of this direction
  std::vector<std::int64_t> coordinates;  //!< in the primal loops
};

class LoopSearch {
 public:
  //! Both must outlive it.
  LoopSearch(const Mesh& mesh, const LoopClasses& classes);

  //! Looks at the loops through `base` that consist of two shortest paths and an edge, up to 2 · radius
  //! (mm) long, and keeps the shortest of each class.
  void searchFrom(int base, double radius = std::numeric_limits<double>::infinity());

  //! From now on loops of neither kind are kept, too: there are many.
  void keepOthers() { keepsOthers_ = true; }

  //! The shortest loop of the class through `base` that consists of two shortest paths and an edge and is up
  //! to 2 · radius (mm) long; no vertices if there is none. Forgets nothing, keeps nothing.
  EdgeLoop loopThrough(int base, const ClassKey& key, double radius);

  //! The shortest loops found whose classes are independent (modulo 2): g of the kind if there are enough
  //! among them, ascending by length.
  std::vector<EdgeLoop> basis(LoopKind kind) const;

  //! The shortest loops of neither kind whose classes are independent of each other and of those of the given
  //! loops (modulo 2).
  std::vector<EdgeLoop> others(const std::vector<EdgeLoop>& given) const;

  //! Per vertex the length of the shortest path from the last base, mm; infinite beyond the radius.
  std::span<const double> distances() const { return distance_; }

 private:
  struct Arc {
    int halfedge, target;
    double length;
  };
  struct Found {
    double length = std::numeric_limits<double>::infinity();
    std::vector<int> vertices;
  };
  using Key = std::pair<std::uint64_t, std::uint64_t>;

  void spread(int base, double radius);
  void collect(double radius);
  std::vector<int> path(int u, int w) const;
  double lengthOf(const std::vector<int>& loop) const;
  std::vector<const Found*> byLength(LoopKind kind) const;
  EdgeLoop described(const Found& found, LoopKind kind) const;

  const Mesh& mesh_;
  const LoopClasses& classes_;
  std::vector<std::size_t> firstArc_;
  std::vector<Arc> arcs_;
  // Of the tree of the last search:
  std::vector<double> distance_;
  std::vector<int> parent_;  // half-edge that arrives
  std::vector<ClassKey> key_;
  std::vector<int> reached_;
  std::map<Key, Found> found_[3];  // by kind; keys that differ by the sign are one class
  bool keepsOthers_ = false;
};

}  // namespace handlebody
