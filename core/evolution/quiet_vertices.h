#pragma once
// Which vertices sleep: those that have not moved for a while.

#include <span>
#include <vector>

#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"

namespace handlebody {

inline constexpr double kQuiet = 0.015;  // edge lengths: a vertex that moves less than this is quiet
inline constexpr int kQuietToSleep = 3;  // iterations

//! What one step did to the vertices.
struct StepMotion {
  std::span<const int> moving;        //!< those that were asked to move
  std::span<const double> distances;  //!< how far, mm
  VertexMarkSpan touched;             //!< per slot: moved, or with other faces than before
};

//! Counts in `quiet` (per slot, up to kQuietToSleep) the iterations in which a vertex was quiet. What surgery
//! made or changed is awake, and so are the neighbours of what stirs.
void countQuiet(const Mesh& mesh, const StepMotion& motion, double edgeLength,
                std::vector<unsigned char>& quiet);

}  // namespace handlebody
