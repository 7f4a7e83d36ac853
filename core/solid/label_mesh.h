#pragma once
// From the voxels of an object to a smooth, even mesh of the same topology.

#include <vector>

#include "core/finding.h"
#include "core/mesh/validity.h"
#include "core/solid/mask.h"

namespace handlebody {

struct LabelMeshOptions {
  double smoothing = -1;  //!< mm, standard deviation; negative: a voxel along each axis; 0: none
  //! mm; 0: the mean spacing, or the smallest one where much of the volume of one object is lost with that
  double edgeLength = 0;
  int threads = 1;
};

struct LabelMesh {
  TriangleSoup mesh;
  Certificate certificate;  //!< passes, and bounds a body
  double farthest = 0;      //!< voxels: of a vertex from the surface between the voxels
};

//! The maskSurface, smoothed and regulated. No vertex is moved farther
//! than kMaxMove voxels from that surface, nor put farther than kMaxApart where edges are regulated; what
//! would make the mesh intersect itself is not done, vertex by vertex. Components, cavities and genus are
//! those of the mask (see maskSurface). Throws as maskSurface; std::logic_error if a step has broken the
//! topology. Precondition: the mask has a voxel.
LabelMesh meshOf(const Mask& mask, const LabelMeshOptions& options);

//! The same of several objects of one label map, in their order, so that no two meshes meet: where objects
//! touch there is a gap of some fifth of a voxel between them, and nowhere does one lie in another. Throws
//! InputError, without a subject, also if they lie in each other too finely for that. Precondition: the masks
//! are cut from one grid, no voxel is in two of them, and each has one.
std::vector<LabelMesh> meshesOf(const std::vector<Mask>& masks, const LabelMeshOptions& options);

//! What is to be told of a mesh of the mask, as it is in the end: its volume differs by more than kMuchVolume
//! from that of the voxels, its edges are not of the length that was asked for.
std::vector<Finding> labelMeshWarnings(const TriangleSoup& mesh, const Certificate& its, const Mask& mask,
                                       const LabelMeshOptions& options);

inline constexpr double kMaxMove = 0.5, kMaxApart = 0.8;
inline constexpr double kMuchVolume = 0.05;                           //!< of that of the voxels
inline constexpr double kLongestWanted = 1.5, kShortestWanted = 0.6;  //!< edges, of the length asked for

}  // namespace handlebody
