#pragma once
// Volumes from and to files, through ITK. No ITK type appears here.

#include <optional>
#include <string>
#include <vector>

#include "core/volume/volume.h"

namespace handlebody {

//! Which volume of a file or folder to read.
struct VolumeSelection {
  std::optional<std::string> series{};  //!< SeriesInstanceUID, for a folder with several series
  std::optional<int> frame{};           //!< time point of a 4D file, zero-based
};

//! One image series or file, as found.
struct SeriesInfo {
  std::string uid;          //!< SeriesInstanceUID; empty for other formats
  std::string description;  //!< modality and description where known
  int files = 1;
};

//! What is in a file or folder, without its voxels where possible.
struct VolumeInfo {
  std::string path;
  std::string format;  //!< "NIfTI", "NRRD", "MetaImage", "DICOM", "TIFF" …
  std::vector<SeriesInfo> series;
  Grid grid;
  VoxelType type = VoxelType::uint8;
  int frames = 1;  //!< time points
  std::vector<std::string> warnings;
};

//! Both throw InputError (one sentence, which begins with the path) for anything that is missing, damaged or
//! not supported, and UsageError for a frame or series that is not there. The type is the file's own; 64-bit
//! integers become float64, scaled integers float32 or float64, colour (RGB, RGBA of 8 or 16 bits) luminance.
//!
//! inspectVolume reads no voxels. A folder with several series of which none is chosen is listed: frames is 0
//! and the grid empty, where readVolume throws.
VolumeInfo inspectVolume(const std::string& path, const VolumeSelection& selection = {});
//! Besides, refuses float volumes with voxels that are NaN or infinite (their number and the first index).
//! Without a selection the first time point. Not for several threads at once: output of the libraries below
//! to std::cerr and std::cout is held back meanwhile.
Volume readVolume(const std::string& path, const VolumeSelection& selection = {});

//! Writes by extension (.nii.gz .nii .nrrd .mha), compressed except .nii, whole or not at all; what was
//! written is read back and compared. The volume has two voxels or more along each axis and only finite
//! values. Throws OutputError; UsageError for an unknown extension.
void writeVolume(const Volume& volume, const std::string& path);

//! SHA-256 of a file, or of the files of a folder in name order; lower-case hex. Throws InputError.
std::string sha256OfPath(const std::string& path);

}  // namespace handlebody
