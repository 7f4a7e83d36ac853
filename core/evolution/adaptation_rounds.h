#pragma once
// Detection and surgery in one attempt at a step, again and again until nothing intersects.

#include "core/collision/self_intersection.h"
#include "core/evolution/transaction.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

//! Until nothing intersects, or until a place has to be rolled back: then it is in the attempt's conflicts.
//! Precondition: faces without a vertex that a.touched marks intersect nothing. `longest`: mm, of an edge.
void adaptInRounds(Mesh& mesh, CollisionDetector& detector, AdaptationSettings settings, double longest,
                   Attempt& a);

}  // namespace handlebody
