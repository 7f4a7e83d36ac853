#pragma once
// The sets Λ of colliding vertices and which of them collide with each other (paper, section 4, "Mesh
// Opening").

#include <span>
#include <vector>

#include "core/collision/self_intersection.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Colliding parts of the mesh.
struct CollisionGroup {
  //! The sets Λ, vertices ascending. Vertices of two sets have no common neighbour.
  std::vector<std::vector<int>> lambda;
  //! Colliding pairs of faces between or within the sets.
  std::vector<FacePair> pairs;
};

//! Groups the vertices of the colliding faces into sets Λ (vertices at graph distance at most 2 join) and the
//! sets into groups that collide with each other, in the order of their lowest vertex.
std::vector<CollisionGroup> groupCollisions(const Mesh& mesh, std::span<const FacePair> pairs);

//! The sets of a group to work on, at most `limit`: all, or first the two with the most collisions between
//! them and then one by one that with the most collisions with those; the rest waits for the next round.
std::vector<std::vector<int>> mostColliding(const Mesh& mesh, const CollisionGroup& group, std::size_t limit);

//! Makes one of any sets that have come to share a neighbour, with the neighbours that they share.
void mergeTouching(const Mesh& mesh, std::vector<std::vector<int>>& sets);

}  // namespace handlebody
