#pragma once
// Where the surface must not move, and for which of three reasons.

#include "core/evolution/held_changes.h"
#include "core/evolution/locked_regions.h"
#include "core/evolution/pinned_parts.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

//! Places that were rolled back rest for some iterations or for good, changes that constraints forbid are
//! held, and what is pinned stays, with a margin where fronts came to it. Owned by the contour and copied
//! with it. A step adds to it while it is made; one that is cancelled takes that back.
struct Restraints {
  LockedRegions regions;
  HeldChanges held;
  PinnedParts pins;

  //! True if constraints hold the vertex where it is. Precondition: mesh.isVertex(vertex).
  bool isHeld(const Mesh& mesh, int vertex) const {
    return held.isLocked(mesh.position(vertex)) || pins.holds(vertex) || pins.isLocked(mesh.position(vertex));
  }
  //! Locks a place that a step of that iteration could not deal with. `longest`: mm, of edges where they have
  //! the target length; `size`: edges there, in parts of it; `mesh`: as it was before the step.
  void lock(const Conflict& conflict, const Mesh& mesh, double longest, double size, int iteration);
  //! After a change of what moves the surface: what was rolled back may come again. What constraints hold
  //! stays.
  void forgetRollbacks();
  //! As it was at `before`, a copy of this. The mesh may have been put into another order since.
  void takeBack(const Restraints& before);
};

}  // namespace handlebody
