#pragma once
// The structure of a valid mesh: closed, 2-manifold, oriented, nothing degenerate, nothing dangling. Looked
// at as a whole, or only where it differs from a mesh that was valid.

#include <optional>
#include <span>
#include <vector>

#include "core/finding.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! What is wrong with a mesh, and where.
struct StructureFault {
  FindingKind what = FindingKind::none;
  int vertex = -1;  //!< a vertex slot there; -1 where there is none
};

//! Keeps its arrays between calls. One thread at a time.
//!
//! What holds of a mesh without a fault: every face has three different vertices, every half-edge has one
//! opposite that runs the other way between the same vertices (closed, edges manifold, oriented); the faces
//! around every vertex form one fan and its neighbours are all different (the link is a single cycle); no two
//! faces have the same three vertices; every vertex has a face; the counts are those of the slots.
class StructureCheck {
 public:
  //! The first fault of the mesh, or none.
  std::optional<StructureFault> examine(const Mesh& mesh);
  //! The same where `before` has no fault, slot by slot: looks only at the faces and half-edges that differ
  //! from it, at what lay beside them, and at their vertices. It takes nobody's word for what has changed;
  //! the comparison goes once over all slots, whatever has changed.
  std::optional<StructureFault> examineChanges(const Mesh& before, const Mesh& mesh);
  //! The faces of the mesh last looked at that had other vertices before, ascending.
  std::span<const int> newFaces() const { return newFaces_; }

 private:
  struct Counts {
    int faces = 0, vertices = 0, corners = 0, fans = 0;
  };
  void listChanges(const Mesh& before, const Mesh& mesh);
  std::optional<StructureFault> examineFace(const Mesh& mesh, int f) const;
  std::optional<StructureFault> examineHalfedge(const Mesh& mesh, int h) const;
  std::optional<StructureFault> examineFaces(const Mesh& before, const Mesh& mesh);
  std::optional<StructureFault> examineVertices(const Mesh& before, const Mesh& mesh);
  std::optional<StructureFault> examineLink(const Mesh& mesh, int v);
  void listVertices(const Mesh& before, const Mesh& mesh);
  void markCorners(const Mesh& mesh, int f, Counts& counts);

  std::vector<int> changedFaces_;     // with other vertices or opposites than before
  std::vector<int> newFaces_;         // with other vertices than before
  VertexMarks isChanged_;             // per vertex: of a changed face, before or now, or made or removed
  std::vector<int> changedVertices_;  // the same, or with another half-edge of their own
  std::vector<int> seenAt_;           // per vertex: the last link in which it was met
  int links_ = 0;                     // looked at so far
  Counts was_, is_;                   // of what has changed
};

//! The same without a workspace.
std::optional<StructureFault> findStructureFault(const Mesh& mesh);

}  // namespace handlebody
