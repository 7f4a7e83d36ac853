#pragma once
// The active contour: seeds grow into the object; each step is a transaction that leaves a certified mesh.

#include <memory>

#include "core/evolution/parameters.h"
#include "core/evolution/step_report.h"
#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Grows a closed surface from seeds in a volume. The same volume, seeds, parameters and version give the
//! same mesh, bit for bit, with any number of threads.
class ActiveContour {
 public:
  //! Resolves the automatic parameters from the image around the seeds and makes the seed spheres.
  //! Throws SeedError (seed outside the volume or not in an object), UsageError (a parameter without meaning,
  //! a range without voxels).
  ActiveContour(Volume volume, std::vector<Seed> seeds, Parameters parameters);
  ~ActiveContour();
  ActiveContour(ActiveContour&&) noexcept;
  ActiveContour& operator=(ActiveContour&&) noexcept;

  //! One iteration, all or nothing: the mesh it leaves is closed, manifold, oriented and free of
  //! self-intersections.
  StepReport step();

  //! StopReason::running while step() would go on.
  StopReason stopReason() const;
  int iteration() const;
  const Mesh& mesh() const;
  const ResolvedParameters& parameters() const;
  //! Traces of events are recorded from the next step on. Off by default.
  void recordTraces(bool on);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace handlebody
