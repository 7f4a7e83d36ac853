#pragma once
// Internal: volumes written with further header fields.

#include <map>
#include <string>

#include "core/volume/volume.h"

namespace handlebody {

//! As writeVolume; `keys` and their values are written as NRRD's key/value pairs. Other formats have none.
void writeVolumeWithKeys(const Volume& volume, const std::string& path,
                         const std::map<std::string, std::string>& keys);

//! Whether the corners of `back`, read from a file at `path`, lie where those of `meant` do, but for what its
//! format rounds.
bool isGridKept(const Grid& back, const Grid& meant, const std::string& path);

}  // namespace handlebody
