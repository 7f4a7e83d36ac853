#pragma once
// Keeps a moving mesh regular: long edges are split, short ones collapsed, valences kept near six.

#include <functional>
#include <vector>

#include "core/mesh/forbidden.h"
#include "core/mesh/mesh.h"

namespace handlebody {

struct RemeshLimits {
  double longest = 0;   //!< mm; longer edges are split
  double shortest = 0;  //!< mm; shorter edges are collapsed
  //! Both are multiplied by this, place by place (mm); on an edge by the lesser of its ends. None: by 1. It
  //! may not change so quickly that the halves of an edge that is too long are too short.
  std::function<double(const Vec3&)> size{};
  //! Where no face may lie that was not part of one before, and which vertices are pinned.
  //! Precondition: no pinned vertex is active.
  Forbidden forbidden{};
};

//! The dihedral angle up to which an edge may be turned or an edge beside it collapsed: the surface moves by
//! at most the longest edge times the sine of it. (cosine)
inline constexpr double kFlatEnough = 0.8;

//! One per vertex slot: it rests; it may be moved, merged and turned about; it rests, but faces of it
//! changed. Read as VertexMarks: something of it moved.
using VertexStates = std::vector<unsigned char>;
inline constexpr unsigned char kAtRest = 0, kActive = 1, kTouched = 2;

//! Regulates the mesh around the active vertices. Topology never changes. New vertices become active;
//! `active` grows with the mesh. Inactive vertices are neither moved nor removed. No edge beside an active
//! vertex is longer than limits.longest afterwards, unless its other faces hold longer edges between vertices
//! at rest; of those, what is half as long again is split too, unless it is the edge of a face between pinned
//! vertices (beside such an edge the others may be up to three quarters of it). Collapses and flips are done
//! only where the surface is nearly flat (kFlatEnough), so that it moves by little; they may still make it
//! intersect another sheet close by, which the caller's detection sees.
void regulate(Mesh& mesh, const RemeshLimits& limits, VertexStates& active);

}  // namespace handlebody
