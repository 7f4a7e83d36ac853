#pragma once
// STL and most readers of meshes hold coordinates in single precision.

#include "core/mesh/mesh.h"

namespace handlebody {

//! The mesh with its coordinates rounded to single precision. Where that makes faces touch or cross that did
//! not, their vertices are moved apart by as few units in the last place as it takes, at most
//! kMaxNudge of them (of the vertex's largest coordinate). The same mesh always gives the same result. A
//! mesh that intersects itself by more than that is returned with its intersections.
TriangleSoup roundedToSingle(const TriangleSoup& mesh);

inline constexpr double kMaxNudge = 256;

//! The mesh as a program has it that reads it in single precision, without such care.
struct ReadInSingle {
  TriangleSoup mesh;
  double farthest = 0;  //!< mm, of a vertex from where it was; 0: nothing is lost
};
ReadInSingle readInSingle(const TriangleSoup& mesh);

}  // namespace handlebody
