#pragma once
// Masks of simpler topology, as maskSurface counts it.

#include <optional>

#include "core/solid/mask.h"

namespace handlebody {

//! The part with the most voxels (6-connected); of equal ones the first.
Mask largestPart(const Mask& mask);

//! Tunnels of the object, over all its components.
int countTunnels(const Mask& mask);

//! The mask changed by the fewest voxels among closings and openings by balls of 1, 2 … kLargestBall times
//! the smallest spacing that leave no more than `genus` tunnels, and something at all; none if there is none.
//! A closing fills tunnels, an opening cuts the bridges around them.
std::optional<Mask> withFewerTunnels(const Mask& mask, int genus);

inline constexpr int kLargestBall = 8;

}  // namespace handlebody
