#pragma once
// Thin triangles and sharp folds of a finished mesh made better for solvers, where that is possible without
// leaving the surface. What is good stays bit for bit.

#include <cstddef>
#include <vector>

#include "core/finding.h"
#include "core/mesh/validity.h"
#include "core/polish/polished_surface.h"
#include "core/polish/shape.h"

namespace handlebody {

//! What a solver needs, degrees: a corner below the first makes a triangle bad, faces that meet at less than
//! the second an edge.
inline constexpr WantedShape kWantedShape{15, 20};
//! How far the surface may go, in voxels (of the smallest side); and in median edges, where a mesh has no
//! voxels.
inline constexpr double kPolishVoxels = 0.1;

struct PolishOptions {
  PolishBounds bounds{};
  WantedShape wanted = kWantedShape;
  //! Per triangle: may be bettered for its own sake. Empty: all. Others change only beside a bad one.
  std::vector<char> isOwn{};
};

struct PolishCount {
  int faces = 0, edges = 0;    //!< bad ones, of those that may be bettered
  double leastAngle = 180;     //!< degrees, of them and all others
  double leastDihedral = 180;  //!< the same
};

struct PolishReport {
  PolishCount before, after;
  double limit = 0;         //!< mm, how far the surface may go
  double farthest = 0;      //!< mm, how far it went: largest distance of the two surfaces, either way
  int changedFaces = 0;     //!< of the new mesh: that were not in the old one
  bool isCutShort = false;  //!< the budget of work was spent before all places had been tried
  bool isRefused = false;   //!< the whole failed its certificate, and the mesh is as it was
  std::vector<Vec3> left;   //!< the worst of the bad places that are left, kMaxLeft at most

  bool isChanged() const { return changedFaces > 0; }
};

inline constexpr std::size_t kMaxLeft = 10;

struct PolishedMesh {
  TriangleSoup mesh;
  Certificate certificate;  //!< of the whole, where something was changed
  PolishReport report;
};

//! Betters bad triangles and edges, the worst first: edges turned, collapsed and split, vertices moved. Each
//! change is made only if what is bad around it gets less and its worst no worse, if the old and the new
//! surface stay within bounds.distance of each other (both ways, to the mesh given), and if no face then
//! intersects another or an obstacle (exact predicates). Topology stays. New coordinates are in single
//! precision. The same input always gives the same mesh; a mesh without anything bad comes back as it is, and
//! so does one whose change would fail the certificate. Work is bounded by a count. Throws Cancelled
//! (cancellation.h).
//! Precondition: `mesh` passes the certificate, every point belongs to a face, and it meets no obstacle.
PolishedMesh polished(const TriangleSoup& mesh, const PolishOptions& options);

//! What is bad in a mesh. Precondition: as for polished.
PolishCount countBad(const TriangleSoup& mesh);

//! What is left, or none: how many, the least angles, why.
Finding polishWarning(const PolishReport& report);

}  // namespace handlebody
