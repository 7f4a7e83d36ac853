#pragma once
// The size of a body. docs/measure.md has the definitions.

#include "core/measure/farthest_pair.h"
#include "core/mesh/mesh.h"

namespace handlebody {

struct ShapeMeasures {
  double volume = 0;  //!< mm³, cavities taken off
  double area = 0;    //!< mm², cavities' too
  Vec3 centroid{0, 0, 0};
  FarthestPair largest;  //!< the largest diameter: of any two vertices
  //! Columns: the axes of inertia of the solid, unit vectors; the one along which it is longest first.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Vec3 extents{0, 0, 0};  //!< mm, along these axes
  Vec3 box{0, 0, 0};      //!< mm, along x, y, z
};

//! Integrals are exact for the polyhedron, but for rounding. Precondition: closed, oriented outwards, without
//! self-intersections, a volume above 0; points without a face are left out.
ShapeMeasures shapeMeasures(const TriangleSoup& mesh);

}  // namespace handlebody
