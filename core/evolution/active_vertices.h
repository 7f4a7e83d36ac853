#pragma once
// Which vertices are active: asked to move in the next step.

#include <cstddef>
#include <span>
#include <vector>

#include "core/evolution/converged_vertices.h"
#include "core/evolution/restraints.h"
#include "core/indices.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Counts, per vertex slot, the iterations in a row without motion: a byte each. A vertex that has come to
//! kStepsToConverge of them has converged and is not asked any more, until something near it moves. Owned by
//! the contour and copied with it; every slot of its mesh is known between two steps.
class ActiveVertices {
 public:
  //! No vertex of a mesh with that many slots has converged.
  void activateAll(int slots) { unmovedSteps_.assign(slots, 0); }
  //! The mesh has that many slots now; vertices in new ones have not converged.
  void resize(int slots) { unmovedSteps_.resize(slots, 0); }
  //! Precondition, here and below: the slot is known.
  void activate(int vertex) { unmovedSteps_[vertex] = 0; }
  bool isConverged(int vertex) const { return unmovedSteps_[vertex] >= kStepsToConverge; }
  //! After mesh.reorder(order).
  void reorder(std::span<const int> order);
  //! After a step, with what it did to the vertices (converged_vertices.h).
  void count(const Mesh& mesh, const StepMotion& motion, double edgeLength) {
    countUnmoved(mesh, motion, edgeLength, unmovedSteps_);
  }
  //! After an edit by hand: what it made or moved stays as it was made, until something near it moves.
  //! `touched`: per slot of the mesh, among them all such vertices.
  void convergeChanged(const Mesh& before, const Mesh& mesh, std::span<const unsigned char> touched);
  //! Those that have not converged and lie in no locked region, ascending.
  std::vector<int> list(const Mesh& mesh, const Restraints& locked, int iteration) const;
  //! Bytes.
  std::size_t memory() const { return unmovedSteps_.size(); }

 private:
  std::vector<unsigned char> unmovedSteps_;  // iterations in a row, up to kStepsToConverge
};

}  // namespace handlebody
