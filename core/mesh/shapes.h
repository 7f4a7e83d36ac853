#pragma once

#include "core/mesh/mesh.h"

namespace handlebody {

//! A sphere of nearly equal triangles (subdivided icosahedron), with edges of at most `edgeLength` mm.
TriangleSoup icosphere(const Vec3& centre, double radius, double edgeLength);

}  // namespace handlebody
