#pragma once

#include <Eigen/Core>
#include <array>

namespace handlebody {

//! A point or vector in world millimetres (LPS) unless said otherwise.
using Vec3 = Eigen::Vector3d;

//! Three vertex indices, counter-clockwise seen from outside. (-1, -1, -1) marks a deleted face.
using Triangle = std::array<int, 3>;

}  // namespace handlebody
