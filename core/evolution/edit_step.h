#pragma once
// Makes the edits of mesh_edit.h, and knows which of them are still to come.

#include <optional>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/finding.h"
#include "core/mesh/mesh.h"
#include "core/surgery/event.h"
#include "core/surgery/touched_mesh.h"

namespace handlebody {

//! What an edit did to a mesh.
struct EditOutcome {
  std::vector<Event>
      events;  //!< at least one; each goes on from the one before; their iteration is left at 0
  //! Vertex slots beside all new or moved faces, at which the mesh has been searched for self-intersections.
  std::vector<int> touched;
};

//! Changes the mesh. Throws UsageError, with a sentence, if there is nothing at that place or it cannot be
//! done: the mesh is then to be taken back. A place is that of a thing if it is no further from it than the
//! thing is large. Throws Cancelled (cancellation.h). Precondition: the mesh passes the certificate.
EditOutcome makeEdit(Mesh& mesh, const MeshEdit& edit);

//! What is wrong with its numbers; FindingKind::none: nothing.
Finding faultOf(const MeshEdit& edit);

//! One of the kinds smooth, pull and cut, whatever its iteration.
TouchedMesh touched(const Mesh& mesh, const MeshEdit& edit);

//! The event of such an edit.
Event eventOf(const MeshEdit& edit, const TouchedMesh& done);

//! The edits that were asked for, and which of them have been made.
class EditSchedule {
 public:
  //! From after `iteration` on. Throws UsageError for an edit of an iteration that is over, unless it has
  //! been made.
  void choose(const std::vector<MeshEdit>& edits, int iteration);
  //! What the step to `iteration` is; null: motion.
  const MeshEdit* dueAt(int iteration) const;
  //! The first that has not been made.
  std::optional<MeshEdit> waiting() const;
  //! Precondition: one that was chosen.
  void setMade(const MeshEdit& edit) { made_.push_back(edit); }

 private:
  std::vector<MeshEdit> asked_, made_;
};

}  // namespace handlebody
