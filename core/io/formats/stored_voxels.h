#pragma once
// Internal: formats whose voxels lie in one file, x fastest and time points one after the other: NIfTI,
// MetaImage, GIPL. Read through our own stream, which sees truncation and wrong checksums.

#include <string>

#include "core/io/formats/volume_source.h"

namespace handlebody {

struct StoredVoxels {
  std::string file{};
  std::uint64_t offset = 0;  //!< where they, or the packed data, begin in the file
  std::uint64_t skip = 0;    //!< bytes before the first voxel of what is there, unpacked
  bool isPacked = false;
  bool isSwapped = false;  //!< bytes stand in the other order
};

//! A source of this header, whose checks it has passed. Throws InputError that begins with `path` if the file
//! is too small.
SourcePointer storedSource(const VolumeHeader& header, const StoredVoxels& voxels, const std::string& path);

}  // namespace handlebody
