#pragma once
// What pins keep from happening in a step: looked for in the mesh that an attempt at it leaves.

#include <span>
#include <vector>

#include "core/evolution/pinned_parts.h"
#include "core/mesh/mesh.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

//! Components that have been pressed flat on pinned vertices of their own: a cavity over a pinned part, or a
//! body under one, cannot go, so what presses it stops. Each is told at a touched vertex, with its extent;
//! nothing is wrong there (Conflict::atPin). `touched`: per vertex slot, not 0 where the attempt has moved or
//! made something; slots that it does not reach are not. `edgeLength`: mm.
std::vector<Conflict> pressedFlat(const Mesh& mesh, const PinnedParts& pins,
                                  std::span<const unsigned char> touched, double edgeLength);

//! What no look ahead has kept from changing what is pinned: that place and those of all events, with that
//! radius (mm); none if all that is pinned is as it was. `before`: what the attempt started from, with the
//! same vertex slots.
std::vector<Conflict> changesOfPinned(const Mesh& before, const Mesh& mesh, const PinnedParts& pins,
                                      std::span<const Event> events, double radius);

}  // namespace handlebody
