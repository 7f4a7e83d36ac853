#pragma once
// Internal: MetaImage headers.

#include <string>

namespace handlebody {

//! Path of the file that holds the voxels; empty if they follow the header, or are in several.
std::string metaDataFile(const std::string& path);

}  // namespace handlebody
