#pragma once
// Which files a volume is in: none of them may be written while it is an input.

#include <string>
#include <vector>

namespace handlebody {

//! The file itself and, where it is a detached header (NRRD, MetaImage, NIfTI pairs), those that hold the
//! voxels, in the order of the header, whether they are there or not. Reads headers only; never throws.
std::vector<std::string> filesOfVolume(const std::string& path);

//! True if writing `file` would change the volume at `path`: it is that file or, where this is a detached
//! header (NRRD, MetaImage, NIfTI pairs), one that holds the voxels, or it lies in that folder, all of whose
//! files (not those of folders in it) belong to the hash of the volume. Never throws.
bool belongsToVolume(const std::string& file, const std::string& path);

}  // namespace handlebody
