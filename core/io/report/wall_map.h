#pragma once
// Label maps as walls.

#include <string>

#include "core/evolution/constraints.h"
#include "core/io/report/session.h"

namespace handlebody {

//! The voxels of a label map that are not 0, in any of its layers, of a file of any format that readVolume
//! reads. Throws InputError if it cannot be read, has values that are no whole numbers or several time
//! points, lies on another grid than `grid` (by a tenth of a voxel), or holds nothing but 0.
WallMap readWallMap(const std::string& path, const Grid& grid, const DecoderSettings& decoder = {});

//! Reads the label maps that the session names, at its beginning and in its changes, decoding as its volume
//! (VolumeSelection::decoder). Throws as readWallMap, and InputError if a file is not the one that the
//! session was made with.
void loadWalls(Session& session, const Grid& grid);

}  // namespace handlebody
