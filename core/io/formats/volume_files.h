#pragma once
// Which files a volume is in: none of them may be written while it is an input.

#include <string>

namespace handlebody {

//! True if writing `file` would change the volume at `path`: it is that file or, where this is a detached
//! header (NRRD, MetaImage, NIfTI pairs), one that holds the voxels, or it lies in that folder, all of whose
//! files (not those of folders in it) belong to the hash of the volume. Never throws.
bool belongsToVolume(const std::string& file, const std::string& path);

}  // namespace handlebody
