#pragma once

#include "core/mesh/mesh.h"

namespace handlebody {

//! What two bodies have in common.
enum class BodyContact {
  none,      //!< no point: one may lie in a cavity of the other
  surfaces,  //!< their surfaces touch or cross
  inside     //!< a part of one lies in the other
};

//! Exact (predicates.h). Precondition: both meshes bound a body (Certificate::boundsBody).
BodyContact bodyContact(const TriangleSoup& a, const TriangleSoup& b);

}  // namespace handlebody
