#pragma once
// Walls piece by piece: which of them a surface lies in.

#include <optional>

#include "core/evolution/walls.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Those of the walls that are no pieces of `known`: balls, discs, objects, and the map if it is another.
WallList without(const WallList& walls, const WallList& known);

//! A point in the first wall: mm.
Vec3 placeOf(const WallList& walls, const Grid& grid);

//! The same of the first piece that is not wholly `known`; none if all are.
std::optional<Vec3> placeOfFresh(const WallList& walls, const WallList& known, const Grid& grid);

//! The pieces of walls that touch the mesh, and those that lie wholly in what it encloses. A piece is a ball,
//! a disc, an object, or voxels of the map that hang together (by faces, edges or corners).
struct Occupied {
  WallList touched, enclosed;
};
Occupied findOccupied(const Mesh& mesh, const Walls& walls);

//! True if the mesh encloses a wall within so many mm of a place.
bool enclosesAny(const Mesh& mesh, const Walls& walls, const Vec3& place, double within);

//! True if the mesh encloses one of the places.
bool enclosesAny(const Mesh& mesh, const std::vector<Vec3>& places);

//! True if the mesh touches a wall.
bool touchesAny(const Mesh& mesh, const Walls& walls);

}  // namespace handlebody
