#pragma once
// All self-intersections of a triangle mesh (paper, section 2): near vertices give candidates
// (vertex_pairs.h), exact predicates decide.

#include <memory>
#include <span>
#include <vector>

#include "core/collision/broad_phase.h"
#include "core/collision/face_pair.h"
#include "core/geometry/vec.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! All pairs of faces that intersect, sorted. Faces that share a vertex or an edge intersect if they have a
//! point in common outside that vertex or edge; degenerate triangles are treated as the point sets they are.
//! Faces (-1,-1,-1) are skipped. Two faces with the same three vertices intersect. Exact for coordinates in
//! the domain of predicates.h; no tolerance, so scale, exact rotation and permutation do not change the
//! answer.
//!
//! The same as CGAL's Polygon_mesh_processing::self_intersections on meshes of proper triangles. CGAL reports
//! a degenerate triangle as intersecting itself and looks no further; here it is the segment or point that it
//! is, and appears in the pairs that this segment or point intersects.
std::vector<FacePair> findSelfIntersections(std::span<const Vec3> points, std::span<const Triangle> faces);

//! Keeps its tables between calls, so that repeated detection allocates nothing, and sorts the faces by
//! vertex anew only when they have changed. Called by one thread at a time.
class CollisionDetector {
 public:
  CollisionDetector();
  ~CollisionDetector();
  CollisionDetector(CollisionDetector&&) noexcept;
  CollisionDetector& operator=(CollisionDetector&&) noexcept;

  //! From now on; at first the sorted one. What is found does not depend on it.
  void use(BroadPhase phase);
  //! At most so many from now on; at first one. What is found does not depend on it.
  void useThreads(int threads);

  //! As findSelfIntersections, over all faces.
  const std::vector<FacePair>& detectAll(std::span<const Vec3> points, std::span<const Triangle> faces);
  //! Only the pairs with at least one face that has a vertex v with moved[v] != 0 (one flag per point). Equal
  //! to detectAll when the faces without such a vertex do not intersect each other.
  const std::vector<FacePair>& detectMoved(std::span<const Vec3> points, std::span<const Triangle> faces,
                                           VertexMarkSpan moved);
  //! The same for a mesh, whose faces need not be sorted by vertex: costs what the moved vertices cost, and
  //! one look at each of the others.
  const std::vector<FacePair>& detectMoved(const Mesh& mesh, VertexMarkSpan moved);

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace handlebody
