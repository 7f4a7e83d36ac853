#pragma once
// What one detection works on: the triangles, which of them it looks at, and the pairs that it has found.

#include <algorithm>
#include <span>
#include <vector>

#include "core/collision/box_tree.h"
#include "core/collision/face_pair.h"
#include "core/collision/moved_faces.h"
#include "core/collision/star_test.h"
#include "core/collision/vertex_stars.h"
#include "core/indices.h"
#include "core/threads.h"

namespace handlebody {

//! Owned by the CollisionDetector, who hands it to one phase after the other: MovedFaces, AdjacentFaces,
//! NearVertices, SeparateFaces or CrowdedFaces. Its memory stays from detection to detection; what it says
//! holds for one.
struct DetectionWorkspace {
  // Room for rounding in distances that only reject: their relative errors are below 2^-48.
  static constexpr double kRounding = 1 + 0x1p-40;
  // Below this many vertices a thread costs more than it saves.
  static constexpr std::size_t kVerticesPerThread = 300;

  std::span<const Vec3> points;     //!< mm
  std::span<const Triangle> faces;  //!< by slot; (-1,-1,-1): none
  VertexStars stars;                //!< of all of `vertices`
  bool all = true;                  //!< else only pairs with a face in `moved`
  MovedFaces moved;                 //!< nothing is marked where all are wanted
  //! Those that are looked at: all that belong to a face; or the active ones, which are those of moved faces,
  //! and then those near to them.
  std::vector<int> vertices;
  std::vector<StarSize> sizes;    //!< per vertex in `vertices`
  double longestSquared = 0;      //!< mm², of all edges that may meet one of `vertices`
  std::vector<double> starSizes;  //!< squared, of `vertices`: see sizeSquared; filled by areLevelsWorth
  std::vector<FacePair> pairs;    //!< found so far, in any order, some of them twice
  int threads = 1;                //!< on which it works, at most

  //! True if the vertex belongs to a face that may be part of a pair that is wanted.
  bool isActive(int v) const { return all || moved.hasVertex(v); }
  bool isWanted(int f) const { return all || moved.hasFace(f); }
  bool isWanted(int f, int g) const { return all || moved.hasFace(f) || moved.hasFace(g); }
  //! Adds the pair if it intersects.
  void test(int f, int g, std::vector<FacePair>& to) const {
    if (facesIntersect(points, faces[f], faces[g])) to.emplace_back(std::min(f, g), std::max(f, g));
  }
  //! Of the work on `vertices`.
  std::size_t shares() const { return sharesOf(vertices.size(), threads, kVerticesPerThread); }
  //! f(share, found) on threads, for shares that are all of the work on `vertices` together; what they find
  //! comes to `pairs`.
  template <typename F>
  void findInShares(F&& f) {
    found_.resize(std::max(found_.size(), shares()));
    forSharesOnThreads(vertices.size(), threads, kVerticesPerThread,
                       [&](const Share& share) { f(share, found_[share.part]); });
    for (std::vector<FacePair>& found : found_) {
      pairs.insert(pairs.end(), found.begin(), found.end());
      found.clear();
    }
  }
  Box boxOf(int f) const {
    const Triangle& t = faces[f];
    const Vec3& a = points[t[0]];
    const Vec3& b = points[t[1]];
    const Vec3& c = points[t[2]];
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
  }
  //! How near (mm², squared) the vertex u of a face T must be to the vertex v = P; see SeparateFaces.
  double reachSquared(int u, int v) const {
    return (sizes[u].enclosingCircle + sizes[v].longestEdge * 0.25) * kRounding;
  }
  //! mm: no vertices that are farther apart have faces that meet.
  double reach() const;
  //! A size s of a star such that its spokes are not longer than s and its circles not larger than s/√3.
  double sizeSquared(int v) const { return std::max(sizes[v].longestEdge, 3 * sizes[v].enclosingCircle); }
  //! By the sizes of the stars listed so far, whose largest becomes part of longestSquared: see VertexLevels.
  bool areLevelsWorth();

 private:
  std::vector<std::vector<FacePair>> found_;  // by each share; empty between two phases
};

}  // namespace handlebody
