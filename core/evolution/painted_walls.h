#pragma once
// Walls as they are painted: strokes of a ball-shaped brush become balls, and an eraser takes them away.

#include <vector>

#include "core/evolution/constraints.h"
#include "core/evolution/parameters.h"

namespace handlebody {

//! Draws on to a place: balls half a radius apart along the straight line from the last one, which they are
//! not thinner than by more than 4 % of the radius. The first call puts one ball there.
//! Preconditions: `to` is finite (mm), `radius` (mm) is above 0.
void drawTo(std::vector<WallBall>& stroke, const Vec3& to, double radius);

//! The walls with the balls of a stroke. What reaches by no more than a quarter of its radius out of one that
//! is there already is left out: painting to and fro costs no more than painting once.
WallList painted(WallList walls, const std::vector<WallBall>& stroke);

//! The walls without the balls and discs that one of the eraser's balls touches.
WallList erased(WallList walls, const std::vector<WallBall>& eraser);

//! The balls that reach into the volume (its border voxels count whole).
std::vector<WallBall> reachingInto(const Grid& grid, std::vector<WallBall> stroke);

//! The first click inside of the object that a wall would lie over, or to which it would leave less than
//! `room` (mm) on one side; -1: none.
int coveredSeed(const std::vector<Seed>& seeds, const std::vector<WallBall>& walls, double room);

}  // namespace handlebody
