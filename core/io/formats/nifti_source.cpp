// NIfTI-1 and NIfTI-2, in one file or as a pair.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/io/formats/byte_stream.h"
#include "core/io/formats/nifti_header.h"
#include "core/io/formats/stored_voxels.h"

namespace handlebody {
namespace {

void checkDimensions(const NiftiHeader& h, const std::string& path) {
  if (h.dim[0] < 1 || h.dim[0] > 7) refuseHeader(path, "NIfTI", "number of dimensions");
  const auto dim = [&](int a) { return h.dim[a]; };
  for (int a = 1; a <= h.dim[0]; ++a) {
    if (dim(a) < 1) refuseInput(path, FindingKind::noVoxelsInHeader);
    if (dim(a) > std::numeric_limits<int>::max())
      refuseInput(path, {FindingKind::implausibleSize, {{"size", std::to_string(dim(a))}}});
  }
  if (h.dim[0] < 3) refuseInput(path, FindingKind::flatImage);
  if (h.dim[0] >= 5 && dim(5) > 1)
    refuseInput(path, {FindingKind::vectorVoxels, {{"components", std::to_string(dim(5))}}});
  for (int a = 6; a <= h.dim[0]; ++a)
    if (dim(a) > 1) refuseInput(path, FindingKind::fourDimensions);
}

void setStoredType(const NiftiHeader& h, const std::string& path, VolumeHeader& header) {
  struct Type {
    int code;
    Component component;
    int components;
  };
  static constexpr Type kTypes[] = {
      {2, Component::uint8, 1},    {4, Component::int16, 1},     {8, Component::int32, 1},
      {16, Component::float32, 1}, {64, Component::float64, 1},  {128, Component::uint8, 3},
      {256, Component::int8, 1},   {512, Component::uint16, 1},  {768, Component::uint32, 1},
      {1024, Component::int64, 1}, {1280, Component::uint64, 1}, {2304, Component::uint8, 4}};
  const auto* type =
      std::find_if(std::begin(kTypes), std::end(kTypes), [&](const Type& t) { return t.code == h.datatype; });
  if (type == std::end(kTypes))
    refuseInput(path, {FindingKind::niftiVoxelType, {{"type", std::to_string(h.datatype)}}});
  header.component = type->component;
  header.components = type->components;
  if (type->components > 1) header.warnings.push_back(FindingKind::colourAsLuminance);
}

void setScaling(const NiftiHeader& h, VolumeHeader& header) {
  // The standard: a slope of 0 means that there is no scaling; colour is never scaled.
  if (h.slope == 0 || !std::isfinite(h.slope) || !std::isfinite(h.intercept) || header.components > 1) return;
  header.slope = h.slope;
  header.intercept = h.intercept;
}

//! The step of the fourth dimension, where it has a unit of time.
void setTimes(const NiftiHeader& h, VolumeHeader& header) {
  const int unit = h.units & 0x38;
  const double ms = unit == 8 ? 1000 : unit == 16 ? 1 : unit == 24 ? 1e-3 : 0;  // s, ms, µs
  header.times = evenTimes(header.frames, h.pixdim[4] * ms, "pixdim[4], xyzt_units");
}

std::string pairOf(const std::string& headerPath) {
  const std::string stem = headerPath.substr(0, headerPath.rfind(".hdr"));
  for (const char* ending : {".img", ".img.gz"})
    if (std::filesystem::exists(stem + ending)) return stem + ending;
  refuseInput(headerPath, {FindingKind::dataFileMissing, {{"data", stem + ".img"}}});
}

VolumeHeader headerOf(const NiftiHeader& nifti, const std::string& path) {
  VolumeHeader header;
  header.format = nifti.version == 1 ? "NIfTI" : "NIfTI-2";
  setStoredType(nifti, path, header);
  for (std::size_t a = 0; a < 3; ++a) header.grid.size[a] = static_cast<int>(nifti.dim[a + 1]);
  header.frames = nifti.dim[0] >= 4 ? static_cast<int>(nifti.dim[4]) : 1;
  setNiftiGeometry(nifti, header, path);
  setTimes(nifti, header);
  setScaling(nifti, header);
  checkHeader(header, path);
  return header;
}

//! The offset counts in what is unpacked.
std::uint64_t offsetOf(const NiftiHeader& nifti, const std::string& path) {
  if (nifti.voxOffset < 0) refuseHeader(path, "NIfTI", "offset");
  return !nifti.pair && nifti.voxOffset < nifti.headerBytes()
             ? static_cast<std::uint64_t>(nifti.headerBytes()) + 4
             : static_cast<std::uint64_t>(nifti.voxOffset);
}

}  // namespace

SourcePointer openNifti(const std::string& path) {
  std::string headerPath = path;
  // A pair begins with its header.
  for (const std::string ending : {".img", ".img.gz"})
    if (path.ends_with(ending)) headerPath = path.substr(0, path.size() - ending.size()) + ".hdr";
  const NiftiHeader nifti = readNiftiHeader(headerPath);
  checkDimensions(nifti, headerPath);
  const std::string data = nifti.pair ? pairOf(headerPath) : headerPath;
  const VolumeHeader header = headerOf(nifti, headerPath);
  return storedSource(header, {data, 0, offsetOf(nifti, headerPath), isGzip(data), nifti.swapped},
                      headerPath);
}

}  // namespace handlebody
