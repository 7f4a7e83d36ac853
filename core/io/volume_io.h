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

//! Throws InputError (one sentence, with the path) for anything that is missing, damaged or not supported.
VolumeInfo inspectVolume(const std::string& path, const VolumeSelection& selection = {});
Volume readVolume(const std::string& path, const VolumeSelection& selection = {});

//! Writes by extension (.nii.gz .nii .nrrd .mha), whole or not at all. Throws OutputError; UsageError for an
//! unknown extension.
void writeVolume(const Volume& volume, const std::string& path);

//! SHA-256 of a file, or of the files of a folder in name order; lower-case hex. Throws InputError.
std::string sha256OfPath(const std::string& path);

}  // namespace handlebody
