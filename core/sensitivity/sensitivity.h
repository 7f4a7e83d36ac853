#pragma once
// How much a result depends on what might as well have been a little different (docs/sensitivity.md).

#include <functional>
#include <string>
#include <vector>

#include "core/evolution/active_contour.h"
#include "core/finding.h"
#include "core/mesh/mesh.h"
#include "core/sensitivity/perturbation.h"

namespace handlebody {

//! One perturbed run.
struct PerturbedRun {
  std::string failure{};  //!< why it left no surface; empty: it did
  Finding why{};          //!< the same, where it is a finding
  double volume = 0;      //!< mm³
  int components = 0;
  int genus = 0;        //!< sum over the components
  double distance = 0;  //!< mm: mean of the result's vertices to this run's surface
};

struct Sensitivity {
  Perturbation by;
  std::vector<PerturbedRun> runs;
  int grown = 0;         //!< of them; the figures below are over these, 0 if there are none
  int sameTopology = 0;  //!< as many components and tunnels as the result
  double mean = 0, deviation = 0, least = 0, most = 0;  //!< volumes, mm³; deviation: standard, of one run
  double result = 0;                                    //!< mm³: the volume of the result itself
  //! Per vertex of the result: root mean square of its distances to the runs' surfaces, mm.
  std::vector<double> spread;
  double meanSpread = 0, spread95 = 0, largestSpread = 0;  //!< mm, over the vertices
};

//! The warnings of a result: runs that left no surface, another topology, a volume that changes by
//! more than a tenth, or that is more than a tenth of itself beyond those of all runs.
std::vector<Finding> sensitivityWarnings(const Sensitivity& s);

//! What is grown again.
struct GrownFrom {
  Volume volume;
  Request request;          //!< as it was in the end
  ResolvedParameters used;  //!< the same
};

//! Throws UsageError where a constraint names an iteration (vetoes, pins, edits): another run's is another
//! one; and where the surface was given as it is, and nothing has grown.
void requireRepeatable(const Constraints& constraints);

//! Grows `count` times, each perturbed by other random numbers, always the same ones for the same input, and
//! on up to `threads` threads, which change nothing. `mesh` is the result, with vertices. `progress` is
//! called, from any thread but one at a time, with the number of runs that have ended. Throws as
//! requireRepeatable, and Cancelled.
Sensitivity sensitivityOf(const TriangleSoup& mesh, const GrownFrom& from, int count, int threads,
                          const std::function<void(int)>& progress = {});

}  // namespace handlebody
