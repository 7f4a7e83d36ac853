#pragma once
// Faces that close an opened mesh: caps on single polygons, and the test whether caps and handles fit.

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/forbidden.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"
#include "core/surgery/face_blocks.h"
#include "core/surgery/opening.h"

namespace handlebody {

//! New faces and vertices. Face indices below `firstNew` are vertices of the mesh, the others index `points`
//! from there.
struct Patch {
  int firstNew = 0;
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  double length = 0;  //!< total length of the new edges, mm

  Vec3 position(const Mesh& mesh, int v) const {
    return v < firstNew ? mesh.position(v) : points[v - firstNew];
  }
  void append(const Patch& other);
};

//! Joins the barycentre of the polygon to its vertices (the paper's cap).
Patch fanCap(const Mesh& mesh, const std::vector<int>& loop);

//! The triangulation of the polygon of least area, without a new vertex (Barequet and Sharir's dynamic
//! programme), of those without a face that is next to a line. None if every one has such a face or would
//! repeat an edge that the mesh has outside the opening.
std::optional<Patch> leastAreaCap(const Mesh& mesh, const Opening& opening, const std::vector<int>& loop);

//! True if the opened mesh has the edge uv.
bool staysOpenOn(const Mesh& mesh, std::span<const Opening> openings, int u, int v);

//! Volume gained when the faces of the openings are replaced by the patch, mm³.
double volumeGain(const Mesh& mesh, std::span<const Opening> openings, const Patch& patch);

//! Area of the patch, mm².
double area(const Mesh& mesh, const Patch& patch);

//! The faces of openings as they were when this was made, which a patch is to replace.
class Replaced {
 public:
  Replaced(const Mesh& mesh, std::span<const Opening> openings, const Forbidden& forbidden);
  //! True if a forbidden place lies between them and the patch: it would come to the other side of the
  //! surface. Precondition: they and the patch have the same boundary.
  bool sweepsOver(const Mesh& mesh, const Patch& patch) const;

 private:
  Forbidden forbidden_;
  std::vector<std::array<Vec3, 3>> faces_;  // none if no place is forbidden
};

//! The faces of the mesh near an opening that stay: what a patch must not intersect.
class Surroundings {
 public:
  //! `blocks`: of the mesh. `ignored[f]` != 0: faces that do not count because they collide themselves and
  //! will be dealt with. What lies where it is forbidden counts as if it intersected a face that stays.
  //! `about`: mm; faces are known whose boxes meet the box of the openings' loops, widened by this.
  Surroundings(const Mesh& mesh, const FaceBlocks& blocks, std::span<const Opening> openings,
               FaceMarkSpan ignored, const Forbidden& forbidden = {}, double about = 0);
  //! True if all faces are known that the patch can meet.
  bool reach(const Patch& patch) const;
  //! True if no face of the patch intersects another or one that stays.
  bool fits(const Patch& patch) const;
  //! True if the face of the patch intersects a face that stays or one of `other`.
  bool hits(const Patch& patch, const Triangle& face, const Patch& other) const;
  //! True if a face that stays is pierced by the edge uv of the mesh, so that no face of a patch may have it.
  bool isBlocked(int u, int v) const;
  bool intersectsItself(const Patch& patch) const;
  //! True if the patch would swallow a forbidden place. Precondition: it closes all of the openings.
  bool sweepsOver(const Patch& patch) const { return replaced_.sweepsOver(mesh_, patch); }

 private:
  struct Staying {
    Eigen::AlignedBox3d box;
    int face;
  };
  template <typename F>
  bool anyNear(const Eigen::AlignedBox3d& box, F&& f) const;
  bool hitsStaying(const Patch& patch, const Triangle& face) const;
  const Mesh& mesh_;
  Forbidden forbidden_;
  Replaced replaced_;
  Eigen::AlignedBox3d known_;
  std::vector<Staying> faces_;  // along the first axis
  double widest_ = 0;           // of their boxes along it
};

}  // namespace handlebody
