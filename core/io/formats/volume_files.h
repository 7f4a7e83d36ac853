#pragma once
// Which files a volume is in: none of them may be written while it is an input.

#include <string>
#include <vector>

namespace handlebody {

//! The file at `path` and, where it is a detached header (NRRD, MetaImage, NIfTI pairs), those that hold the
//! voxels, whether they are there or not. Of a folder its files (not those of folders in it), all of which
//! belong to the hash of the volume. Reads headers only; one that cannot be read has no other files. Never
//! throws.
std::vector<std::string> filesOfVolume(const std::string& path);

//! True if writing `file` would change the volume at `path`: it is one of filesOfVolume, or would be a new
//! one in a folder. Never throws.
bool belongsToVolume(const std::string& file, const std::string& path);

}  // namespace handlebody
