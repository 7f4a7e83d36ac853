#pragma once
// How large that is which a change of topology would make: said where it is held, so that somebody can
// decide.

#include "core/mesh/mesh.h"
#include "core/surgery/event.h"

namespace handlebody {

//! All 0: it is not known.
struct HeldSize {
  double tunnel = 0;      //!< mm: a short loop through it, around what it would surround
  double part = 0;        //!< mm³ enclosed by what would come off, the smaller of two
  bool isCavity = false;  //!< that is a cavity
  bool operator==(const HeldSize&) const = default;
};

//! Of a change that made more components or a larger genus. `before`: the mesh before the step, `after`: with
//! all that the step changed; `longest`: mm, of their edges. The loop is that along edges of `before`, from
//! one front to the other, and across the gap.
HeldSize heldSize(const Event& event, const Mesh& before, const Mesh& after, double longest);

}  // namespace handlebody
