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
#include "core/mesh/loop_tree.h"

namespace handlebody {

//! A simple closed loop along edges.
struct EdgeLoop {
  std::vector<int> vertices;  //!< in order
  double length = 0;          //!< mm
  LoopKind kind = LoopKind::handle;
  ClassKey key;                           //!< of this direction
  std::vector<std::int64_t> coordinates;  //!< in the primal loops
};

//! Where loops are looked for: those through the vertex that consist of two shortest paths and an edge, up to
//! 2 · radius (mm) long.
struct LoopBase {
  int vertex;
  double radius = std::numeric_limits<double>::infinity();
};

class LoopSearch {
 public:
  //! Both must outlive it.
  LoopSearch(const Mesh& mesh, const LoopClasses& classes);
  LoopSearch(const LoopSearch&) = delete;
  LoopSearch& operator=(const LoopSearch&) = delete;

  //! Looks at the loops through the base and keeps the shortest of each class.
  void searchFrom(const LoopBase& base);
  //! The same through each of them in their order, on up to so many threads; what is kept does not depend on
  //! their number. A base that has been looked at, as far or farther, is left out: it has nothing new.
  void searchFrom(std::span<const LoopBase> bases, int threads);

  //! From now on loops of neither kind are kept, too: there are many.
  void keepOthers() {
    keepsOthers_ = true;
    searched_.clear();
  }

  //! The shortest loop of the class through the base; no vertices if there is none. Forgets nothing, keeps
  //! nothing.
  EdgeLoop loopThrough(const LoopBase& base, const ClassKey& key);

  //! The shortest loops found whose classes are independent (modulo 2): g of the kind if there are enough
  //! among them, ascending by length.
  std::vector<EdgeLoop> basis(LoopKind kind) const;

  //! The shortest loops of neither kind whose classes are independent of each other and of those of the given
  //! loops (modulo 2).
  std::vector<EdgeLoop> others(const std::vector<EdgeLoop>& given) const;

  //! Per vertex the length of the shortest path from the last single base, mm; infinite beyond the radius.
  std::span<const double> distances() const { return trees_.front().distances(); }

 private:
  struct Found {
    double length = std::numeric_limits<double>::infinity();
    std::vector<int> vertices;
  };
  using Key = std::pair<std::uint64_t, std::uint64_t>;
  //! The shortest loop of a class through one base.
  struct Candidate {
    LoopKind kind;
    Key key;
    double withPaths;  // mm, with what both paths share
    Found loop;
  };

  std::vector<Candidate> candidates(LoopTree& tree, const LoopBase& base) const;
  void keep(std::vector<Candidate> candidates);
  std::vector<LoopBase> notSearched(std::span<const LoopBase> bases);
  void searchAtOnce(std::span<const LoopBase> bases, int threads);
  std::vector<const Found*> byLength(LoopKind kind) const;
  EdgeLoop described(const Found& found, LoopKind kind) const;

  const LoopClasses& classes_;
  LoopGraph graph_;
  std::vector<LoopTree> trees_;     // one for each thread
  std::map<int, double> searched_;  // how far, by base
  std::map<Key, Found> found_[3];   // by kind; keys that differ by the sign are one class
  bool keepsOthers_ = false;
};

}  // namespace handlebody
