#pragma once
// Internal: what the header of one DICOM file says, single or multi-frame. Through GDCM, so only in the child
// process that decodes; no type of GDCM appears here.

#include <optional>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_class.h"
#include "core/io/dicom/dicom_structure.h"
#include "core/io/formats/dicom_origin.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Where one frame lies, how its values are scaled, and its place among time points.
struct DicomPlace {
  std::optional<Vec3> position{};      //!< mm, LPS: centre of the first pixel
  std::optional<Vec3> rowDirection{};  //!< direction in which the column index grows
  std::optional<Vec3> columnDirection{};
  std::optional<Vec3> pixelSpacing{};  //!< mm: x between columns, y between rows
  double slope = 1, intercept = 0;
  double time = 0;                       //!< temporal position, or what orders images of one place
  std::optional<double> milliseconds{};  //!< in the cycle or the series, where the header says it
  std::string stack{};                   //!< StackID, of a frame
  int segment = 0;                       //!< ReferencedSegmentNumber, of a frame of a segmentation

  bool complete() const { return position && rowDirection && columnDirection && pixelSpacing; }
};

//! The volumes of a Philips Cartesian echo (dicom_echo.h).
struct CartesianEcho {
  int slices = 0;   //!< of each volume; 0: it is no such file
  int volumes = 0;  //!< that the header declares
};

struct DicomFile {
  std::string file, seriesUid, instanceUid, classUid, modality, description, transferSyntax, photometric;
  int rows = 0, columns = 0, frames = 1, samples = 1;
  int bitsAllocated = 16, bitsStored = 16, highBit = 15;
  bool isSigned = false, planar = false;
  int instanceNumber = 0, acquisitionNumber = 0;
  std::optional<double> sliceDistance{};   //!< mm, where the header states it for all frames
  std::optional<double> sliceThickness{};  //!< the same
  bool cine = false;                       //!< frames follow one another in time, not in space
  bool ownFrameOfReference = false;        //!< positions are in the frame of the ultrasound volume
  std::vector<DicomPlace> places{};        //!< one per frame
  bool placed = false;                     //!< the header says where every frame lies
  bool slopeWasZero = false;               //!< of a frame; it is 1 there
  std::string spacingSource{}, positionSource{}, orientationSource{}, distanceSource{}, timeSource{};
  CartesianEcho echo{};
  DicomStructure structure{};

  bool isImage() const { return rows > 0 && columns > 0; }
  bool isSegmentation() const { return classUid == kSegmentationClass; }
  std::uint64_t pixelsPerFrame() const {
    return static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(columns);
  }
};

//! Reads the header of `file` up to its pixels. Nothing if GDCM finds no DICOM in it. `path` is what the user
//! named, for the sentences of the errors.
std::optional<DicomFile> readDicomFile(const std::string& file, const std::string& path);

//! What `file`, the first of a series, says about patient and study. Its images are left to the caller.
DicomOrigin readDicomOrigin(const std::string& file);

}  // namespace handlebody
