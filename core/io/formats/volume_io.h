#pragma once
// Volumes from and to files. No type of a library appears here.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/decoder_settings.h"
#include "core/io/formats/dicom_origin.h"
#include "core/told_error.h"
#include "core/volume/volume.h"

namespace handlebody {

//! What to do with slices at uneven distances.
enum class UnevenSlices {
  resample,  //!< onto an even grid, linearly between neighbouring slices; a warning says so
  refuse     //!< InputError
};

//! Which volume of a file or folder to read, and how.
struct VolumeSelection {
  std::optional<std::string> series{};  //!< SeriesInfo::uid, for a folder with several series
  std::optional<int> frame{};           //!< time point of a 4D file, or layer of a segmentation, zero-based
  std::optional<Vec3> spacing{};        //!< mm, instead of the file's; for files that have none
  UnevenSlices uneven = UnevenSlices::resample;
  DecoderSettings decoder{};  //!< of DICOM and TIFF; no part of what a session keeps
};

//! One image series or file, as found. The stacks of a series that are no one volume together (other size,
//! orientation, pixel spacing, pitch or acquisition) are listed each for itself.
struct SeriesInfo {
  std::string uid;          //!< SeriesInstanceUID, with #1, #2 … for its stacks; empty for other formats
  std::string description;  //!< modality and description where known
  int files = 1;
  std::string modality{};       //!< "CT", "MR", "US" …
  std::array<int, 3> size{};    //!< voxels; 0 where the series is no volume
  int slices = 0;               //!< images in the series, all time points
  Vec3 spacing = Vec3::Zero();  //!< mm; 0 where the series is no volume
  int frames = 1;               //!< time points
  Finding note{};               //!< a sentence: why it cannot be opened as a volume; none if it can
};

//! Where the numbers of a geometry come from: the tag or header field, "assumed" or "given".
struct GeometrySources {
  std::string size{};
  std::array<std::string, 3> spacing{};  //!< one per axis
  std::string origin{};
  std::string direction{};
};

//! What is in a file or folder, without its voxels where possible.
struct VolumeInfo {
  std::string path;
  std::string format;  //!< "NIfTI", "NRRD", "MetaImage", "DICOM", "TIFF" …
  std::vector<SeriesInfo> series;
  Grid grid;
  VoxelType type = VoxelType::uint8;
  int frames = 1;  //!< time points
  int layers = 1;  //!< of a segmentation whose segments overlap: VolumeSelection::frame is one of them
  bool calibrated = true;  //!< false: a spacing is assumed, and lengths and volumes in mm mean nothing
  GeometrySources sources{};
  std::vector<Finding> warnings;               //!< sentences
  std::shared_ptr<const DicomOrigin> dicom{};  //!< of a volume that was read from DICOM images
};

//! Thrown where one volume is asked for and a folder (or series) holds several.
class SeriesChoiceNeeded : public Told<InputError> {
 public:
  SeriesChoiceNeeded(const Finding& finding, std::vector<SeriesInfo> found)
      : Told(finding), series(std::move(found)) {}
  std::vector<SeriesInfo> series;  //!< to choose from
};

//! Is told how far a long reading is: 0 … 1, never falling, from the thread that reads. May be empty.
using ReadProgress = std::function<void(double)>;

//! A volume with what is known about it.
struct LoadedVolume {
  Volume volume;
  VolumeInfo info;
};

//! All throw InputError (one sentence, which begins with the path) for anything that is missing, damaged or
//! not supported, and UsageError for a frame or series that is not there. The type is the file's own; 64-bit
//! integers become float64, scaled integers float32 or float64, colour (RGB, RGBA of 8 or 16 bits) luminance.
//!
//! DICOM is decoded in a child process (DecoderSettings), whose crash, hang or excessive memory use is an
//! InputError.
//!
//! inspectVolume reads no voxels. A folder with several series of which none is chosen is listed: frames is 0
//! and the grid empty, where readVolume and loadVolume throw SeriesChoiceNeeded. A series of two pitches one
//! behind the other is one volume, resampled, where its UID is chosen or it is the only one; its stacks can
//! be chosen, too.
VolumeInfo inspectVolume(const std::string& path, const VolumeSelection& selection = {});
//! Besides, refuses float volumes with voxels that are infinite (their number and the first index), or all
//! NaN. Where some are NaN, or beyond kLargestVoxel (not_a_number.h), they get the number just below the
//! least of the others, and a warning says so: that is how FieldOfView knows them. Without a selection the
//! first time point. Not for several threads at once: output of the libraries below to std::cerr and
//! std::cout is held back meanwhile.
Volume readVolume(const std::string& path, const VolumeSelection& selection = {});
//! Both in one reading. Throws Cancelled (cancellation.h) within some 50 ms after the stop token is set.
LoadedVolume loadVolume(const std::string& path, const VolumeSelection& selection = {},
                        const ReadProgress& progress = {});
//! The grid of a volume that no file holds, with the checks that a file's header gets: sizes, spacing,
//! direction (made exactly orthonormal), memory. Throws InputError that begins with `name`.
Grid checkedGrid(const Grid& grid, VoxelType type, const std::string& name);
//! A volume whose voxels no file holds: `fill` writes grid.voxelCount() values of `type`, x fastest, into
//! memory that is not cleared. Throws as checkedGrid, and InputError for voxels that are infinite; NaN as
//! above.
LoadedVolume fillVolume(const Grid& grid, VoxelType type, const std::string& name,
                        const std::function<void(void*)>& fill);
//! What the program of DecoderSettings does; returns its exit code. Talks on file descriptor 3, fills the
//! memory behind 4.
int runDicomDecoder();

//! Writes by extension (.nii.gz .nii .nrrd .mha), compressed except .nii, whole or not at all; what was
//! written is read back and compared. The volume has two voxels or more along each axis and only finite
//! values. Throws OutputError; UsageError for an unknown extension.
void writeVolume(const Volume& volume, const std::string& path);

//! By what a file or folder is known again; SHA-256 in lower-case hex.
struct PathHash {
  std::string whole;   //!< of all that is read: a detached header and then the files with its voxels
  std::string header;  //!< of a detached header alone, as sessions of before that have it; empty: it is none

  bool is(const std::string& sha256) const {
    return sha256 == whole || (!header.empty() && sha256 == header);
  }
};

//! Of a file, with the voxels of a detached header, or of the files of a folder in name order. Throws
//! InputError.
PathHash hashOfPath(const std::string& path);
inline std::string sha256OfPath(const std::string& path) { return hashOfPath(path).whole; }

}  // namespace handlebody
