#pragma once
// All handles for two, three or four boundary loops of any sizes, shortest total edge length first.
//
// A handle (paper, Definition 5, with faces of Types 1 and 2) is a triangulated sphere with k holes without
// inner vertices, in which no edge joins two vertices of one loop but the edges of the loop. So every edge of
// a loop has one face of Type 1, whose third corner lies on another loop. Take such a face out, and its two
// loops with the two cut edges are one loop; take one out for k - 1 loops so that all are joined, and what
// is left is a disc, that is, a polygon to be triangulated. Its shortest triangulation is found by dynamic
// programming, O(n³) for n = m + 2(k - 1) places. Type 2 faces and the ways in which strips lie between them
// (one for k = 3; for k = 4 those of a tetrahedron, and those in which one pair of loops has two strips) come
// out by themselves.
//
// The choice of faces to take out is a search tree: an edge is fixed for each loop, and the branches are the
// places where the third corner of its face can be. As the face of an edge is unique, each handle is on one
// branch. If for k = 4 two pairs of loops have been joined first, the next edge may have its third corner on
// the same pair; its face then cuts a disc off, and the next edge is tried. Branches are searched best first
// by a lower bound: the length is divided among the faces, each edge of a loop contributes at least the least
// share of a face on it, and the Type 2 faces at least the least shares of theirs (HandleBound). So the first
// handle found is the shortest, and the n-th the n-th shortest: the shortest triangulations of a polygon are
// enumerated by their first difference from the ones before (Lawler 1972).
//
// A handle must be a simplicial complex: no two edges with the same ends. Equal ends on both sides of a cut
// are seen only when a triangulation is found; then its polygon is searched again in two parts, without the
// one and without the other of the two edges.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/handles/cross_edges.h"

namespace handlebody {

//! A handle: faces over vertices numbered one loop after the other from 0.
struct HandleCandidate {
  std::vector<Triangle> faces;  //!< m of Type 1 and 2k - 4 of Type 2
  double length = 0;            //!< sum of the lengths of the edges between the loops, mm
};

class ShortestHandles {
 public:
  //! Steps of the search (additions of the dynamic programming) after which it ends; some 50 ms. Reached for
  //! two loops only above some 100 vertices each, seldom for three, and for four above some 20.
  static constexpr std::size_t kMaxWork = 30'000'000;

  //! `loops`: two to four boundary loops of the opened mesh (mm), without common vertices, each in the order
  //! in which its boundary half-edges run when seen from the missing side: a handle face that uses the loop
  //! edge (v_i, v_i+1) holds it in exactly that direction, so that handle and opened mesh fit with consistent
  //! orientation. No handle has an edge of `forbiddenEdges`: name there what the opened mesh joins already.
  //! Coordinates that are not finite and loops of fewer than three vertices have no handles.
  explicit ShortestHandles(std::span<const std::vector<Vec3>> loops,
                           std::span<const VertexPair> forbiddenEdges = {}, std::size_t maxWork = kMaxWork);
  ~ShortestHandles();
  ShortestHandles(ShortestHandles&&) noexcept;
  ShortestHandles& operator=(ShortestHandles&&) noexcept;

  //! As next() before anything else was asked of it, or since forbid(), if the handle database tells the
  //! handle: the same faces in the same order, the same length and workDone(), and the same handles after it.
  //! None, and next() is to be asked, if the database does not tell it (listed_handles.h), or the work may
  //! not be enough for a search.
  std::optional<HandleCandidate> nextListed();

  //! The next handle; none if there are no more. Equal lengths come in an order that depends on the numbering
  //! only. After maxWork steps the search is not widened: handles still come shortest first, but not all of
  //! them.
  std::optional<HandleCandidate> next();

  //! From now on no handle has one of these faces (corners in any order) or edges. The next handle is the
  //! shortest of all without them, also if it came before.
  void forbid(std::span<const Triangle> faces, std::span<const VertexPair> edges = {});

  //! Steps taken so far, those after maxWork as well. The calls give up by Cancelled where the stop token is
  //! set (cancellation.h); the search is of no use then.
  std::size_t workDone() const;

  //! True if the search reached maxWork: the last handle may not have been the next, nor have been the last.
  bool gaveUp() const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace handlebody
