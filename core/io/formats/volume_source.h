#pragma once
// Internal: one way to read a volume per format. A source is opened with its header read and checked; the
// voxels of one time point are read on demand.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/io/decimal_point.h"
#include "core/io/formats/time_axis.h"
#include "core/io/formats/volume_io.h"
#include "core/io/refuse_input.h"

namespace handlebody {

//! Types of one component as files hold them.
enum class Component { uint8, int8, uint16, int16, uint32, int32, float32, float64, int64, uint64 };

std::size_t bytesOf(Component component);

//! Calls f with `p` as a pointer to values of the component's type.
template <typename F>
void visitComponents(Component c, const void* p, F&& f) {
  switch (c) {
    case Component::uint8:
      return f(static_cast<const std::uint8_t*>(p));
    case Component::int8:
      return f(static_cast<const std::int8_t*>(p));
    case Component::uint16:
      return f(static_cast<const std::uint16_t*>(p));
    case Component::int16:
      return f(static_cast<const std::int16_t*>(p));
    case Component::uint32:
      return f(static_cast<const std::uint32_t*>(p));
    case Component::int32:
      return f(static_cast<const std::int32_t*>(p));
    case Component::float32:
      return f(static_cast<const float*>(p));
    case Component::float64:
      return f(static_cast<const double*>(p));
    case Component::int64:
      return f(static_cast<const std::int64_t*>(p));
    case Component::uint64:
      return f(static_cast<const std::uint64_t*>(p));
  }
}

struct VolumeHeader {
  std::string format{};
  std::vector<SeriesInfo> series{};
  Grid grid{};
  Component component = Component::uint8;
  int components = 1;  //!< per voxel: 1, or 3 or 4 for colour
  int frames = 1;
  bool hasLayers = false;  //!< the frames are no time points but layers of segments that overlap
  TimeAxis times{};        //!< of the time points; empty where the file does not say
  double slope = 1;        //!< value = slope · stored + intercept, applied after reading
  double intercept = 0;
  bool calibrated = true;
  GeometrySources sources{};
  std::vector<Finding> warnings{};
  std::shared_ptr<DicomOrigin> dicom{};  //!< of DICOM images, of all time points one behind the other
  bool isChoice = false;                 //!< several series and none chosen: it holds only them, no volume

  bool scaled() const { return slope != 1 || intercept != 0; }
  std::uint64_t bytesPerFrame() const {
    return static_cast<std::uint64_t>(grid.voxelCount()) * static_cast<std::uint64_t>(components) *
           bytesOf(component);
  }
};

//! Reports `part` (0 … 1). Throws Cancelled (cancellation.h).
void tellProgress(const ReadProgress& progress, double part);

//! Memory for a volume, not cleared: every byte is read from the file or the reading throws. Aligned for
//! every type. Throws InputError.
std::shared_ptr<void> allocate(std::uint64_t bytes, const std::string& path);

class VolumeSource {
 public:
  virtual ~VolumeSource() = default;
  //! header().bytesPerFrame() bytes, native byte order. Throws InputError, Cancelled.
  virtual std::shared_ptr<void> read(int frame, const std::string& path, const ReadProgress& progress) {
    std::shared_ptr<void> memory = allocate(header_.bytesPerFrame(), path);
    readFrame(frame, memory.get(), progress);
    return memory;
  }
  const VolumeHeader& header() const { return header_; }
  VolumeHeader& header() { return header_; }

 protected:
  //! The same into memory of the caller.
  virtual void readFrame(int frame, void* to, const ReadProgress& progress) = 0;
  VolumeHeader header_;
};

using SourcePointer = std::unique_ptr<VolumeSource>;

//! What openVolume is asked for.
struct OpenRequest {
  std::string path;
  VolumeSelection selection{};
  std::string format = "DICOM";  //!< of what the child process decodes
};

// The formats. Each throws InputError with one sentence that begins with the path.
SourcePointer openNifti(const std::string& path);
SourcePointer openMetaImage(const std::string& path);
SourcePointer openNrrd(const std::string& path);
//! A file, or a folder of the slices of a volume, in a child process: its reader cannot be cancelled
//! otherwise.
SourcePointer openTiff(const OpenRequest& request, const ReadProgress& progress);
//! A folder or a file, in a child process. With several series and none chosen the header is a choice.
SourcePointer openDicom(const OpenRequest& request, const ReadProgress& progress);

//! A folder of 3D volumes as the time points of one, in the order of their names, numbers by value. Null if
//! it holds other files than volumes that are told by their ending (.nii .nii.gz .nrrd .nhdr .mha .mhd, with
//! their data files), or none. `decoder` is for those that hold something else than their name says. Throws
//! InputError for volumes that do not go together.
SourcePointer openVolumeFolder(const std::string& path, const DecoderSettings& decoder);

//! True for a folder of TIFF files alone (data files, notes and hidden files aside). Throws InputError.
bool isTiffFolder(const std::string& path);

//! Finds the format by content and opens; a choice as for openDicom.
SourcePointer openVolume(const OpenRequest& request, const ReadProgress& progress);

// --- checks before memory is allocated ---

//! Sizes, spacing, direction (made exactly orthonormal) and the memory needed. Throws InputError.
void checkHeader(VolumeHeader& header, const std::string& path);
//! Throws InputError if `file` is too small to hold `bytes` from `offset` on. Compressed: deflate packs at
//! most 1032 to 1, so that a larger claim is wrong whatever the data are.
void checkDataSize(const std::string& path, const std::string& file, std::uint64_t offset,
                   std::uint64_t bytes, bool compressed);
//! Throws InputError: its header of this format is damaged, in that field.
[[noreturn]] void refuseHeader(const std::string& path, const std::string& format, const std::string& field);
//! Reverses the bytes of `count` values of `size` bytes.
void swapBytes(void* values, std::size_t count, std::size_t size);
//! The same for the components of all voxels of one time point.
void swapVoxels(const VolumeHeader& header, void* voxels);
//! True for a header field of the second or a later frame of a tracked sequence ("Seq_Frame0001_…"), as Plus
//! and 3D Slicer write them. (Volumes reconstructed by them may carry the fields of one frame, 0.)
bool isLaterFrame(const std::string& field);

//! Libraries below write to std::cerr, std::cout and their own channels; errors reach us as exceptions. Quiet
//! while one of these lives, and numbers have a point meanwhile. Not for several threads at once.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  struct Saved;
  std::unique_ptr<Saved> saved_;
  DecimalPoint point_{};
};

}  // namespace handlebody
