#pragma once

#include "core/mesh/validity.h"

namespace handlebody {

//! The whole certificate: examine() and the exact count of self-intersecting pairs.
Certificate certify(const TriangleSoup& soup);

}  // namespace handlebody
