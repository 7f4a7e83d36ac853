#pragma once
// Which vertices have converged: those that have not moved for some iterations.

#include <span>
#include <vector>

#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

inline constexpr double kUnmoved =
    0.015;  // edge lengths: a vertex that moves less than this counts as unmoved
inline constexpr int kStepsToConverge = 3;  // iterations

//! What one step did to the vertices.
struct StepMotion {
  std::span<const int> moving;        //!< those that were asked to move
  std::span<const double> distances;  //!< how far, mm
  VertexMarkSpan touched;             //!< per slot: moved, or with other faces than before
};

//! Counts in `unmovedSteps` (per slot, up to kStepsToConverge) the iterations in which a vertex has not
//! moved. What surgery made or changed is active, and so are the neighbours of what moves far.
void countUnmoved(const Mesh& mesh, const StepMotion& motion, double edgeLength,
                  std::vector<unsigned char>& unmovedSteps);

}  // namespace handlebody
