// NIfTI-1 and NIfTI-2, with their voxels through our own stream, which sees truncation and wrong checksums.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/io/formats/byte_stream.h"
#include "core/io/formats/nifti_header.h"

namespace handlebody {
namespace {

void checkDimensions(const NiftiHeader& h, const std::string& path) {
  if (h.dim[0] < 1 || h.dim[0] > 7)
    refuseInput(path, {FindingKind::headerDamaged,
                       {{"format", std::string("NIfTI")}, {"field", std::string("number of dimensions")}}});
  const auto dim = [&](int a) { return h.dim[static_cast<std::size_t>(a)]; };
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

class NiftiSource : public VolumeSource {
 public:
  explicit NiftiSource(const std::string& path);

 protected:
  void readFrame(int frame, void* to, const ReadProgress& progress) override;

 private:
  NiftiHeader nifti_;
  std::string dataFile_;
  std::uint64_t offset_ = 0;
  bool compressed_ = false;
};

NiftiSource::NiftiSource(const std::string& path) : nifti_(readNiftiHeader(path)) {
  checkDimensions(nifti_, path);
  dataFile_ = nifti_.pair ? pairOf(path) : path;
  compressed_ = isGzip(dataFile_);
  header_.format = nifti_.version == 1 ? "NIfTI" : "NIfTI-2";
  setStoredType(nifti_, path, header_);
  for (std::size_t a = 0; a < 3; ++a) header_.grid.size[a] = static_cast<int>(nifti_.dim[a + 1]);
  header_.frames = nifti_.dim[0] >= 4 ? static_cast<int>(nifti_.dim[4]) : 1;
  setNiftiGeometry(nifti_, header_, path);
  setTimes(nifti_, header_);
  setScaling(nifti_, header_);
  checkHeader(header_, path);
  if (nifti_.voxOffset < 0)
    refuseInput(path, {FindingKind::headerDamaged,
                       {{"format", std::string("NIfTI")}, {"field", std::string("offset")}}});
  offset_ = static_cast<std::uint64_t>(nifti_.voxOffset);
  const auto first = static_cast<std::uint64_t>(nifti_.headerBytes());
  if (!nifti_.pair && offset_ < first) offset_ = first + 4;
  checkDataSize(path, dataFile_, compressed_ ? 0 : offset_,
                header_.bytesPerFrame() * static_cast<std::uint64_t>(header_.frames), compressed_);
}

void NiftiSource::readFrame(int frame, void* to, const ReadProgress& progress) {
  const std::uint64_t bytes = header_.bytesPerFrame();
  const std::uint64_t before = offset_ + bytes * static_cast<std::uint64_t>(frame);
  ByteStream stream(dataFile_, compressed_ ? 0 : before,
                    compressed_ ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  if (compressed_) stream.skip(before, progress);
  stream.readAll(to, static_cast<std::size_t>(bytes), progress);
  stream.checkEnd(frame + 1 < header_.frames);
  if (nifti_.swapped)
    swapBytes(to, header_.grid.voxelCount() * static_cast<std::size_t>(header_.components),
              bytesOf(header_.component));
}

}  // namespace

SourcePointer openNifti(const std::string& path) {
  std::string headerPath = path;
  // A pair begins with its header.
  for (const std::string ending : {".img", ".img.gz"})
    if (path.ends_with(ending)) headerPath = path.substr(0, path.size() - ending.size()) + ".hdr";
  return std::make_unique<NiftiSource>(headerPath);
}

}  // namespace handlebody
