#pragma once
// 4D volumes to files, frame by frame: never more than one of them is in memory.

#include <functional>
#include <string>
#include <vector>

#include "core/io/formats/time_axis.h"
#include "core/io/meshes/mesh_io.h"
#include "core/volume/volume.h"

namespace handlebody {

//! True for .nii .nii.gz .nrrd (any case), but not for .seg.nrrd.
bool isSequencePath(const std::string& path);

struct SequenceLayout {
  Grid grid;
  VoxelType type = VoxelType::uint8;
  int frames = 1;
  TimeAxis times{};  //!< NIfTI holds even steps alone; others, and unknown ones, are left out of it
};

//! Writes by extension, compressed except .nii: NIfTI-1 with four dimensions, or a NRRD sequence as 3D Slicer
//! has it (the list of frames is the last axis). `frame` is called once for each, in order, and gives a
//! volume of that grid and type. Whole or not at all; what was written is read back and compared. Throws
//! OutputError; UsageError for another extension; what `frame` throws.
void writeSequence(const SequenceLayout& layout, const std::string& path,
                   const std::function<Volume(int frame)>& frame);

//! "mesh.vtp" of frame 7 is "mesh_0007.vtp".
std::string numberedPath(const std::string& path, int frame);
//! "mesh.vtp" belongs to "mesh.pvd".
std::string collectionPath(const std::string& path);

//! ParaView's list of files, each with its time (ms; where none is known, the number of the frame). `files`:
//! numbers of frames whose file is numberedPath(path). With `set` the list gets its name by
//! FileSet::commit (atomic_file.h). Throws OutputError.
void writeCollection(const std::string& path, const std::vector<int>& files, const TimeAxis& times,
                     FileSet* set = nullptr);

}  // namespace handlebody
