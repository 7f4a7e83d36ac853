#pragma once
// Triangulations of polygons, shortest total edge length first: the last part of the choice of a handle.

#include <array>
#include <span>
#include <vector>

#include "core/handles/cross_edges.h"
#include "core/indices.h"

namespace handlebody {

//! A chord of a polygon, by the places of its ends.
struct Chord {
  int from = 0;
  int to = 0;  //!< > from
};

//! What is left of a handle when some of its faces have been chosen and taken out: one or several discs, each
//! a polygon of vertices of the loops. A vertex can occur several times, at different places.
//!
//! A triangulation joins places by chords. No chord joins two vertices of one loop, is forbidden, or repeats
//! an edge of the faces taken out; the same pair of vertices at two pairs of places is found out by
//! repeatedPair.
class DiscTriangulation {
 public:
  //! `places`: the vertices of the discs, one disc after the other; `ends[d]`: one past the last place of
  //! disc d (of at least 3 places). Faces hold the sides from each place to the next. `taken`: the
  //! faces taken out.
  DiscTriangulation(const CrossEdges& edges, std::vector<int> places, std::vector<int> ends,
                    std::span<const Triangle> taken);

  //! From now on no triangulation has this chord.
  void exclude(const Chord& chord);
  //! From now on every triangulation has this chord (that is, none that crosses it).
  void require(const Chord& chord);

  //! Sum of the lengths of the chords of the shortest triangulation, mm; kNone if there is none. O(n²) for
  //! two loops, whose triangulations are monotone paths between them; O(n³) for more.
  double solve();
  //! Rough number of operations of solve().
  std::size_t work() const { return edges_->loopCount() == 2 ? n_ * n_ : n_ * n_ * n_ / 8; }

  //! A triangulation as it is taken apart: for each sub-polygon (from, to), in the order of a stack, the
  //! place of the third corner of the face on its side `from to`.
  struct Derivation {
    std::vector<Chord> bases;
    std::vector<int> apexes;
  };
  //! The triangulation that has the first `prefix` apexes, then the one of the given rank (0 is the best)
  //! among those possible there, and from there on the best. No bases if there is none of this rank.
  //! Precondition: solve() was called.
  Derivation derive(std::span<const int> prefix, int rank) const;
  //! The triangulation with these faces, of two loops; each with its least vertex first, and sorted. No bases
  //! if it has others.
  Derivation derivationOf(std::span<const Triangle> faces) const;
  //! Sum of the lengths of its chords, added up as solve() does it: the same bits.
  double lengthOf(const Derivation& d) const;
  //! By how much the length grows if the apex at place `step` is replaced by the one of the given rank and
  //! the rest below it by the best, compared to the apex it has; kNone if there is none.
  double detour(const Derivation& d, std::size_t step, int rank) const;

  std::vector<Triangle> faces(const Derivation& d) const;
  //! Two chords that join the same two vertices; none: both 0.
  std::array<Chord, 2> repeatedPair(const Derivation& d) const;

 private:
  struct Option {
    double length;
    int apex;
    bool operator<(const Option& o) const { return length != o.length ? length < o.length : apex < o.apex; }
  };
  bool isSide(const Chord& c) const;
  void listRuns();
  const std::vector<std::array<int, 2>>& runs(const Chord& base) const;
  double through(const Chord& base, int apex) const;
  double bestThrough(const Chord& base) const;
  double bestOfRun(const Chord& base, int first, int end) const;
  template <typename F>
  Derivation takeApart(F&& apexOf) const;
  template <typename F>
  void forEachApex(const Chord& base, F&& f) const;
  std::vector<Option> options(const Chord& base) const;

  const CrossEdges* edges_;
  std::vector<int> places_;
  std::vector<int> ends_;
  std::size_t n_;
  // Per pair of loops: the places of all others, from the first to one past the last. A face on a chord
  // between the two has its third corner beside one of its ends, or there.
  std::vector<std::vector<std::array<int, 2>>> runs_;
  std::vector<double> chord_;  // lengths; 0 for sides
  std::vector<double> below_;  // of the chord and all below it, by (from, to) and by (to, from)
};

}  // namespace handlebody
