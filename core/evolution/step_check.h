#pragma once
// What every step must fulfil before it is kept: the guarantee of the product, as code.

#include <span>
#include <vector>

#include "core/mesh/marks.h"
#include "core/mesh/smaller_components.h"
#include "core/mesh/structure.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

//! What a step has left, and what it says of it.
struct StepResult {
  const Mesh& before;  //!< valid, slot by slot what the step started from
  const Mesh& mesh;
  TopologyNumbers topology;  //!< of `before`
  VertexMarkSpan touched;    //!< per vertex: detection has looked at its faces as they are now
  std::span<const Event> events;
  double longest = 0;                 //!< mm, of an edge of the target length
  double longestAnywhere = 0;         //!< mm, of an edge
  const Components* parts = nullptr;  //!< of `mesh` as it is; null: they have to be looked for
};

//! Looks at what a step has changed, given that all was well before:
//! - the structure of the mesh (structure.h), wherever a face or half-edge differs from before;
//! - detection has been asked to look at every face that is new or has moved: those that it was not asked
//!   about cannot intersect each other, and what it found has been dealt with or rolled back;
//! - the surface encloses a positive volume (and no coordinate is out of bounds);
//! - Euler number, components and genus are those that the events predict, counted on the mesh;
//! - after a change of topology, or of the surface that may have taken one past another, the components lie
//!   in each other as those of a body (nesting.h).
//! Without surgery no component can have joined or parted: moving and regulating keep what hangs together.
//! Where HANDLEBODY_CHECK_WHOLE is defined (the presets for tests) the whole mesh is then certified from its
//! triangles alone, and a fault that only this finds throws std::logic_error.
class StepCheck {
 public:
  //! The places that are to be taken back, with the reasons; none if the step may be kept.
  std::vector<Conflict> faultsOf(const StepResult& step);
  //! mm³ enclosed by the mesh last looked at.
  double volume() const { return volume_; }
  //! After a step that was not kept.
  void forgetPlaces() { smaller_.forget(); }

 private:
  std::vector<Conflict> structureFaults(const StepResult& step);
  std::vector<Conflict> coverageFaults(const StepResult& step) const;
  std::vector<Conflict> topologyFaults(const StepResult& step);
  std::vector<Conflict> componentFaults(const StepResult& step, const TopologyNumbers& expected);
  StructureCheck structure_;
  SmallerComponents smaller_;  // of the mesh last looked at, as long as all went well
  double volume_ = 0;
};

}  // namespace handlebody
