#pragma once
// Internal: one way to read a volume per format. A source is opened with its header read and checked; the
// voxels of one time point are read on demand into memory of the caller.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/io/volume_io.h"

namespace handlebody {

//! Types of one component as files hold them.
enum class Component { uint8, int8, uint16, int16, uint32, int32, float32, float64, int64, uint64 };

std::size_t bytesOf(Component component);

struct VolumeHeader {
  std::string format;
  std::vector<SeriesInfo> series{};
  Grid grid;
  Component component = Component::uint8;
  int components = 1;  //!< per voxel: 1, or 3 or 4 for colour
  int frames = 1;
  double slope = 1;  //!< value = slope · stored + intercept, applied after reading
  double intercept = 0;
  std::vector<std::string> warnings{};

  bool scaled() const { return slope != 1 || intercept != 0; }
  std::uint64_t bytesPerFrame() const {
    return static_cast<std::uint64_t>(grid.voxelCount()) * static_cast<std::uint64_t>(components) *
           bytesOf(component);
  }
};

class VolumeSource {
 public:
  virtual ~VolumeSource() = default;
  //! Fills `to` with header().bytesPerFrame() bytes, native byte order. Throws InputError.
  virtual void readFrame(int frame, void* to) = 0;
  const VolumeHeader& header() const { return header_; }
  VolumeHeader& header() { return header_; }

 protected:
  VolumeHeader header_;
};

using SourcePointer = std::unique_ptr<VolumeSource>;

// The formats. Each throws InputError with one sentence that begins with the path.
SourcePointer openNifti(const std::string& path);
SourcePointer openMetaImage(const std::string& path);
SourcePointer openNrrd(const std::string& path);
SourcePointer openTiff(const std::string& path);
//! A folder or a file. With several series and none chosen, `several` is set and the header holds only them.
SourcePointer openDicom(const std::string& path, const VolumeSelection& selection, bool* several);

//! Finds the format by content and opens; `several` as for openDicom.
SourcePointer openVolume(const std::string& path, const VolumeSelection& selection, bool* several);

// --- checks before memory is allocated ---

//! Sizes, spacing, direction (made exactly orthonormal) and the memory needed. Throws InputError.
void checkHeader(VolumeHeader& header, const std::string& path);
//! Throws InputError if `file` is too small to hold `bytes` from `offset` on. Compressed: deflate packs at
//! most 1032 to 1, so that a larger claim is wrong whatever the data are.
void checkDataSize(const std::string& path, const std::string& file, std::uint64_t offset,
                   std::uint64_t bytes, bool compressed);
//! Reverses the bytes of `count` values of `size` bytes.
void swapBytes(void* values, std::size_t count, std::size_t size);
//! True for a header field of the second or a later frame of a tracked sequence ("Seq_Frame0001_…"), as Plus
//! and 3D Slicer write them. (Volumes reconstructed by them may carry the fields of one frame, 0.)
bool isLaterFrame(const std::string& field);
//! "path: cause."
[[noreturn]] void refuseInput(const std::string& path, const std::string& cause);

//! Libraries below write to std::cerr, std::cout and their own channels; errors reach us as exceptions. Quiet
//! while one of these lives. Not for several threads at once.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  struct Saved;
  std::unique_ptr<Saved> saved_;
};

}  // namespace handlebody
