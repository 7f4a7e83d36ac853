#pragma once
// Where the surface must not move, and for which of three reasons.

#include "core/evolution/held_changes.h"
#include "core/evolution/pinned_parts.h"
#include "core/evolution/resting_places.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

//! Places that were rolled back rest for some iterations or for good, changes that constraints forbid are
//! held, and what is pinned stays, with a margin where fronts came to it. Owned by the contour and copied
//! with it. A step adds to it while it is made; one that is cancelled takes that back.
struct LockedRegions {
  RestingPlaces resting;
  HeldChanges held;
  PinnedParts pins;

  //! True if constraints hold the vertex where it is. Precondition: mesh.isVertex(vertex).
  bool isHeld(const Mesh& mesh, int vertex) const {
    return held.rests(mesh.position(vertex)) || pins.holds(vertex) || pins.rests(mesh.position(vertex));
  }
  //! Locks a place that a step of that iteration could not deal with. `longest`: mm, of edges where they have
  //! the target length; `size`: edges there, in parts of it; `mesh`: as it was before the step.
  void lock(const Trouble& trouble, const Mesh& mesh, double longest, double size, int iteration);
  //! After a change of what moves the surface: what was rolled back may come again. What constraints hold
  //! stays.
  void forgetRollbacks();
  //! As it was at `before`, a copy of this. The mesh may have been put into another order since.
  void takeBack(const LockedRegions& before);
};

}  // namespace handlebody
