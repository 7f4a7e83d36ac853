#pragma once
// How far a surface has drifted when it comes back to a frame that has one already.

#include "core/mesh/mesh.h"

namespace handlebody {

//! How it is found out whether the surface drifts.
enum class DriftCheck {
  none,
  back,  //!< carried back from each end to the frame that was grown
  wrap   //!< the sequence is a cycle: carried from the last frame to the first
};

struct Drift {
  int from = 0;             //!< frame from which it came back
  int at = 0;               //!< frame to which it came
  bool isBack = false;      //!< it came; else it was lost on the way, and there are no figures
  double dice = 0;          //!< of the two surfaces' insides
  double mean = 0;          //!< mm, over the area of both surfaces
  double percentile95 = 0;  //!< mm, the larger of the two directions
  double volumeRatio = 0;   //!< of the surface that came back, to the one that was there
};

//! The figures; `edgeLength` (mm) sets how densely both are sampled. Precondition: both are closed and not
//! empty.
Drift driftBetween(const TriangleSoup& there, const TriangleSoup& back, double edgeLength);

}  // namespace handlebody
