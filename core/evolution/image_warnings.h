#pragma once
// What the image says against a surface.

#include <vector>

#include "core/finding.h"
#include "core/mesh/mesh.h"

namespace handlebody {

class ObjectImage;

//! What the image shows where a face lies: an edge of the object; none, so that only curvature or a limit
//! carries the surface there; nothing, at the border of the volume.
enum class FaceSupport : unsigned char { edge, none, border };

//! How the image supports a surface; as it is made here, of one that was not compared with the image.
struct SurfaceSupport {
  std::vector<FaceSupport> faces;  //!< one per face, in the order of Mesh::compact()
  //! Part of the surface (by area, 0 … 1) with FaceSupport::none; what lies at the border does not count.
  double withoutEdge = 0;
  double atBorder = 0;  //!< part of the surface (by area, 0 … 1) with FaceSupport::border
  //! False for a surface of so many faces that was never compared with the image: then nothing else holds.
  bool covers(std::size_t count) const { return faces.size() == count; }
};

//! A face is without an edge if across it the intensity hardly changes: over two voxels along the normal by
//! less than a quarter of the step from the object to its boundary. All are with one for a surface on the
//! object's edges, none for one that ends in the open.
SurfaceSupport surfaceSupport(const Mesh& mesh, const ObjectImage& image);

//! Part of the surface (by area) that lies on the border of the field of view: not more than two voxels
//! before the padding around the image.
double partAtPadding(const Mesh& mesh, const ObjectImage& image);

//! The object was cut off at a neck; much of the surface shows no edge; much of it lies on the border of the
//! volume or of the field of view. `support`: of the same mesh and image.
std::vector<Finding> imageWarnings(const Mesh& mesh, const ObjectImage& image, const SurfaceSupport& support);

}  // namespace handlebody
