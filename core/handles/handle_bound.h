#pragma once
// A lower bound of the length of a handle of which some faces are known.

#include <span>
#include <vector>

#include "core/handles/cross_edges.h"
#include "core/indices.h"

namespace handlebody {

//! The length of a handle is divided among its faces: each edge between two loops has two faces, which hold
//! it in the two directions, and the shares of the two directions make up its length. A handle has one face
//! on every edge of a loop, and Type 2 faces on certain triples of loops; the sum of the least shares that
//! these can have is a lower bound. Any shares do; tighten() looks for good ones.
class HandleBound {
 public:
  explicit HandleBound(const CrossEdges& edges);

  //! Looks again at the faces that are allowed, now without these edges as well.
  void update(std::span<const VertexPair> forbidden);

  //! Moves shares between the two directions of edges to raise the bound (subgradient steps of the dual
  //! problem, with Polyak's step towards `target`, the length of a good handle). Returns the rounds it took,
  //! each of O(n²). Throws Cancelled.
  int tighten(double target, int rounds);

  //! Share of a face; kNone if it has an edge that is not allowed.
  double share(const Triangle& face) const;
  //! The least share of a face on the loop edge from v to the next vertex, and the mean over all its third
  //! corners of what they have more.
  double least(int v) const { return least_[v]; }
  double meanExcess(int v) const;
  //! Lower bound of the length of all handles with these faces and one more.
  double with(std::span<const Triangle> faces, const Triangle& one) const;
  //! Of all handles; kNone if there is none.
  double ofAll() const { return sumOfLeast_ + leastCombination(0).sum; }

 private:
  // Type 2 faces are known by their class: three loops, and the cyclic order in which they hold them.
  static constexpr int kClasses = 8;
  double shareOf(int u, int v) const { return share_[idx(u) * count_ + idx(v)]; }
  int classOf(const Triangle& face) const;
  void findLeast();
  void findLeastOnLoopEdge(int v);
  void findLeastOfClass(const std::array<int, 3>& loops);
  //! A set of Type 2 classes that the faces of a handle can have, and the sum of their least shares.
  struct Combination {
    unsigned classes = 0;
    double sum = 0;
  };
  Combination leastCombination(unsigned usedClasses) const;
  int chooseFaces();
  void addSlope(const Triangle& face);

  const CrossEdges& edges_;
  std::size_t count_;          // of vertices
  std::vector<double> share_;  // of the directed edge from u to v
  std::vector<double> least_;
  std::vector<int> apex_;  // that has it
  double sumOfLeast_ = 0;
  std::vector<unsigned> combinations_;
  // Of the faces that make up the bound: how often they hold u before v less v before u, and the pairs for
  // which this may not be 0.
  std::vector<int> slope_;
  std::vector<std::array<int, 2>> sloped_;
  std::array<double, kClasses> leastOfClass_{};
  std::array<Triangle, kClasses> faceOfClass_{};
};

}  // namespace handlebody
