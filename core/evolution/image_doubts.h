#pragma once
// What the image says against a surface.

#include <string>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Part of the surface (by area) across which the intensity hardly changes: over two voxels along the normal
//! by less than a quarter of the step from the object to its boundary. 0 for a surface on the object's edges,
//! 1 for one that ends in the open. Where the surface ends at the border of the volume does not count.
double partWithoutEdge(const Mesh& mesh, const ObjectImage& image);

//! Part of the surface (by area) that lies on the border of the field of view: not more than two voxels
//! before the padding around the image.
double partAtPadding(const Mesh& mesh, const ObjectImage& image);

//! Sentences without a full stop: the object was cut off at a neck; much of the surface shows no edge; much
//! of it lies on the border of the field of view.
std::vector<std::string> imageDoubts(const Mesh& mesh, const ObjectImage& image);

//! Of an object that is cut where its passages have radii below `neckRadius` (mm).
std::string heldAtPassages(double neckRadius);

}  // namespace handlebody
