#pragma once
// Objects as voxels: label maps, 3D Slicer's segmentations and ITK-SNAP's label descriptions.

#include <string>
#include <vector>

#include "core/io/meshes/exported_object.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Keys of the tags of a segment. Those of the algorithm are of 3D Slicer's reader and writer of DICOM
//! Segmentations, its extension QuantitativeReporting.
namespace slicer {
inline constexpr const char* kTerminologyTag = "TerminologyEntry";
inline constexpr const char* kAlgorithmTypeTag = "DICOM.SegmentAlgorithmType";
inline constexpr const char* kAlgorithmNameTag = "DICOM.SegmentAlgorithmName";
}  // namespace slicer

//! True for .seg.nrrd (any case).
bool isSlicerSegmentationPath(const std::string& path);

//! Label values of the objects on `grid`, 0 outside of all: uint8, or uint16 where a value needs it. Where
//! two objects hold the same voxel, which closed meshes that do not intersect may only do if one encloses the
//! other, the later one has it.
Volume labelMap(const std::vector<ExportedObject>& objects, const Grid& grid);

//! Writes a label map whose values are those of the objects as 3D Slicer's segmentation (.seg.nrrd, one
//! layer), with names, colours, extents and terms. Keys: vtkMRMLSegmentationStorageNode. Whole or not at all,
//! read back and compared. Throws OutputError.
void writeSlicerSegmentation(const Volume& labels, const std::vector<ExportedObject>& objects,
                             const std::string& path);

//! ITK-SNAP's label description file: index, colour, visibility and name of every label, and the clear label.
std::string labelDescription(const std::vector<ExportedObject>& objects);
//! True for .label (any case), ITK-SNAP's own ending for such a file.
bool isLabelDescriptionPath(const std::string& path);

}  // namespace handlebody
