// NIfTI-1: geometry through ITK, voxels through our own stream. ITK's reader holds every voxel twice and
// takes all time points to reach one; and the stream sees truncation and wrong checksums.

#include <itkNiftiImageIO.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/io/byte_stream.h"
#include "core/io/itk_source.h"

namespace handlebody {
namespace {

struct NiftiHeader {
  std::int16_t dim[8];
  std::int16_t datatype;
  float voxOffset, slope, intercept;
  std::int16_t qform, sform;
  unsigned char units;
  float rows[12];  // sform: voxel index to RAS
  bool swapped = false, pair = false;
};

constexpr std::size_t kHeaderBytes = 348;

template <typename T>
T field(const unsigned char* bytes, std::size_t offset, bool swapped) {
  T value;
  std::memcpy(&value, bytes + offset, sizeof value);
  if (swapped) swapBytes(&value, 1, sizeof value);
  return value;
}

NiftiHeader readHeader(const std::string& path) {
  unsigned char bytes[kHeaderBytes] = {};
  ByteStream stream(path, 0, isGzip(path) ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  const std::size_t got = stream.read(bytes, kHeaderBytes);
  std::int32_t size = field<std::int32_t>(bytes, 0, false);
  NiftiHeader h{};
  h.swapped = size != 348 && size != 540;
  if (h.swapped) size = field<std::int32_t>(bytes, 0, true);
  if (size == 540) refuseInput(path, "this is a NIfTI-2 file, which is not supported; convert it to NIfTI-1");
  if (size != 348) refuseInput(path, "it is not a NIfTI file, whatever its name says");
  if (got != kHeaderBytes) refuseInput(path, "it is truncated within its NIfTI header");
  h.pair = std::memcmp(bytes + 344, "ni1", 4) == 0;
  if (!h.pair && std::memcmp(bytes + 344, "n+1", 4) != 0)
    refuseInput(path, "this is an Analyze 7.5 file, whose orientation is not reliable; convert it to NIfTI");
  for (std::size_t i = 0; i < 8; ++i) h.dim[i] = field<std::int16_t>(bytes, 40 + 2 * i, h.swapped);
  h.datatype = field<std::int16_t>(bytes, 70, h.swapped);
  h.voxOffset = field<float>(bytes, 108, h.swapped);
  h.slope = field<float>(bytes, 112, h.swapped);
  h.intercept = field<float>(bytes, 116, h.swapped);
  h.units = bytes[123];
  for (std::size_t i = 0; i < 12; ++i) h.rows[i] = field<float>(bytes, 280 + 4 * i, h.swapped);
  h.qform = field<std::int16_t>(bytes, 252, h.swapped);
  h.sform = field<std::int16_t>(bytes, 254, h.swapped);
  return h;
}

void checkDimensions(const NiftiHeader& h, const std::string& path) {
  if (h.dim[0] < 1 || h.dim[0] > 7) refuseInput(path, "its NIfTI header is damaged (number of dimensions)");
  for (int a = 1; a <= h.dim[0]; ++a)
    if (h.dim[a] < 1) refuseInput(path, "the volume has no voxels (a size of 0 in its header)");
  if (h.dim[0] < 3) refuseInput(path, "this is a 2D image, a volume is needed");
  if (h.dim[0] >= 5 && h.dim[5] > 1)
    refuseInput(path, "its voxels have " + std::to_string(h.dim[5]) +
                          " components (vectors); only scalar and colour volumes are supported");
  for (int a = 6; a <= h.dim[0]; ++a)
    if (h.dim[a] > 1) refuseInput(path, "it has more than four dimensions");
}

//! The stored type; ITK's header says what the values become after scaling.
void setStoredType(const NiftiHeader& h, const std::string& path, VolumeHeader& header) {
  header.components = 1;
  switch (h.datatype) {
    case 2:
      header.component = Component::uint8;
      break;
    case 4:
      header.component = Component::int16;
      break;
    case 8:
      header.component = Component::int32;
      break;
    case 16:
      header.component = Component::float32;
      break;
    case 64:
      header.component = Component::float64;
      break;
    case 256:
      header.component = Component::int8;
      break;
    case 512:
      header.component = Component::uint16;
      break;
    case 768:
      header.component = Component::uint32;
      break;
    case 1024:
      header.component = Component::int64;
      break;
    case 1280:
      header.component = Component::uint64;
      break;
    case 128:
    case 2304:
      header.component = Component::uint8;
      header.components = h.datatype == 128 ? 3 : 4;
      break;
    default:
      refuseInput(path, "its NIfTI voxel type " + std::to_string(h.datatype) + " is not supported");
  }
}

void setScaling(const NiftiHeader& h, VolumeHeader& header) {
  // The standard: a slope of 0 means that there is no scaling; colour is never scaled.
  if (h.slope == 0 || !std::isfinite(h.slope) || !std::isfinite(h.intercept) || header.components > 1) return;
  header.slope = static_cast<double>(h.slope);
  header.intercept = static_cast<double>(h.intercept);
}

class NiftiSource : public VolumeSource {
 public:
  explicit NiftiSource(const std::string& path);
  void readFrame(int frame, void* to, const ReadControl& control) override;

 private:
  void addWarnings(const std::string& path);
  NiftiHeader nifti_;
  std::string dataFile_;
  std::uint64_t offset_ = 0;
  bool compressed_ = false;
};

std::string pairOf(const std::string& headerPath) {
  const std::string stem = headerPath.substr(0, headerPath.rfind(".hdr"));
  for (const char* ending : {".img", ".img.gz"})
    if (std::filesystem::exists(stem + ending)) return stem + ending;
  refuseInput(headerPath, "its data file " + stem + ".img is missing");
}

NiftiSource::NiftiSource(const std::string& path) : nifti_(readHeader(path)) {
  checkDimensions(nifti_, path);
  dataFile_ = nifti_.pair ? pairOf(path) : path;
  compressed_ = isGzip(dataFile_);
  if (!nifti_.pair && compressed_ != (path.ends_with(".gz") || path.ends_with(".GZ")))
    refuseInput(path, compressed_ ? "it is compressed but its name does not end with .nii.gz; rename it"
                                  : "it is not compressed but its name ends with .gz; rename it");
  auto io = itk::NiftiImageIO::New();
  VolumeHeader stored;
  setStoredType(nifti_, path, stored);  // before ITK, whose library prints what it does not like
  header_ = readItkHeader(*io, path, "NIfTI");
  header_.component = stored.component;
  header_.components = stored.components;
  setScaling(nifti_, header_);
  header_.frames = nifti_.dim[0] >= 4 ? nifti_.dim[4] : 1;
  checkHeader(header_, path);
  if (!(nifti_.voxOffset >= 0 && nifti_.voxOffset < 1e9f))
    refuseInput(path, "its NIfTI header is damaged (offset)");
  offset_ = static_cast<std::uint64_t>(nifti_.voxOffset);
  if (!nifti_.pair && offset_ < kHeaderBytes) offset_ = 352;
  checkDataSize(path, dataFile_, compressed_ ? 0 : offset_,
                header_.bytesPerFrame() * static_cast<std::uint64_t>(header_.frames), compressed_);
  addWarnings(path);
}

//! Largest distance (mm) between where the sform and the grid put a corner of the volume.
double distanceFromSform(const NiftiHeader& h, const Grid& grid) {
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index(0, 0, 0);
    for (int a = 0; a < 3; ++a)
      if (corner >> a & 1) index[a] = grid.size[static_cast<std::size_t>(a)];
    Vec3 world;
    for (int r = 0; r < 3; ++r) {
      const float* row = h.rows + 4 * r;
      const double value = row[0] * index[0] + row[1] * index[1] + row[2] * index[2] + row[3];
      world[r] = r < 2 ? -value : value;
    }
    largest = std::max(largest, (world - grid.toWorld(index)).norm());
  }
  return largest;
}

void NiftiSource::addWarnings(const std::string& path) {
  const int unit = nifti_.units & 7;
  if (unit == 1 || unit == 3)
    refuseInput(path, unit == 1 ? "its lengths are in metres, only millimetres are supported"
                                : "its lengths are in micrometres, only millimetres are supported");
  if (nifti_.qform <= 0 && nifti_.sform <= 0)
    header_.warnings.push_back(
        "The header does not say how the volume lies in space (qform and sform codes are 0).");
  const double apart = nifti_.sform > 0 ? distanceFromSform(nifti_, header_.grid) : 0;
  if (apart > 0.1)
    header_.warnings.push_back("The sform and the qform of the header disagree (by up to " +
                               std::to_string(std::lround(std::ceil(apart))) + " mm); the qform is used.");
}

void NiftiSource::readFrame(int frame, void* to, const ReadControl& control) {
  const std::uint64_t bytes = header_.bytesPerFrame();
  const std::uint64_t before = offset_ + bytes * static_cast<std::uint64_t>(frame);
  ByteStream stream(dataFile_, compressed_ ? 0 : before,
                    compressed_ ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  if (compressed_) stream.skip(before, control);
  stream.readAll(to, static_cast<std::size_t>(bytes), control);
  stream.checkEnd();
  if (nifti_.swapped)
    swapBytes(to, header_.grid.voxelCount() * static_cast<std::size_t>(header_.components),
              bytesOf(header_.component));
}

}  // namespace

SourcePointer openNifti(const std::string& path) {
  std::string headerPath = path;
  // Of a pair, ITK and we begin with the header.
  for (const std::string ending : {".img", ".img.gz"})
    if (path.ends_with(ending)) headerPath = path.substr(0, path.size() - ending.size()) + ".hdr";
  return std::make_unique<NiftiSource>(headerPath);
}

}  // namespace handlebody
