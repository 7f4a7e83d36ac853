#pragma once
// Internal: the headers of NIfTI-1 and NIfTI-2 in one form.

#include <array>
#include <cstdint>
#include <string>

#include "core/io/formats/volume_source.h"

namespace handlebody {

struct NiftiHeader {
  int version = 1;
  std::array<std::int64_t, 8> dim{};
  int datatype = 0;
  std::int64_t voxOffset = 0;
  double slope = 0, intercept = 0;
  int qform = 0, sform = 0, units = 0;
  std::array<double, 8> pixdim{};
  std::array<double, 3> quaternion{}, offset{};  //!< b, c, d; mm, RAS
  std::array<double, 12> rows{};                 //!< sform: voxel index to RAS
  bool swapped = false, pair = false;

  std::int64_t headerBytes() const { return version == 1 ? 348 : 540; }
};

//! Throws InputError for what is neither.
NiftiHeader readNiftiHeader(const std::string& path);

//! Spacing, origin, direction and where they come from: the qform, else the sform, else the voxel size alone
//! with axes taken as RAS, as the standard says. Warns where the header is doubtful.
void setNiftiGeometry(const NiftiHeader& nifti, VolumeHeader& header, const std::string& path);

}  // namespace handlebody
