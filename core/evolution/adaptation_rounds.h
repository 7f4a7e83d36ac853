#pragma once
// Detection and surgery in one attempt at a step, again and again until nothing intersects.

#include "core/collision/self_intersection.h"
#include "core/evolution/transaction.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

//! Keeps its memory from step to step.
class AdaptationRounds {
 public:
  //! What changes the mesh where faces collide, as adaptTopology does. Tests give one that is broken.
  using Surgery = AdaptationResult (*)(Mesh& mesh, std::span<const FacePair> pairs,
                                       const AdaptationSettings& settings, VertexMarks& touched);
  explicit AdaptationRounds(Surgery surgery = adaptTopology) : surgery_(surgery) {}

  //! Until nothing intersects, or until a place has to be rolled back: then it is in the attempt's conflicts.
  //! So is one that surgery has changed without a word: the next detection would not look at it, though what
  //! was marked before it, and looked at as it was then, may be all that is known of it at the end.
  //! Precondition: faces without a vertex that a.touched marks intersect nothing. `longest`: mm, of an edge.
  void run(Mesh& mesh, CollisionDetector& detector, AdaptationSettings settings, double longest, Attempt& a);

 private:
  Surgery surgery_;
  Mesh seen_;  // as the last detection has looked at it
};

}  // namespace handlebody
