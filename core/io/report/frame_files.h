#pragma once
// The surfaces of all frames to files: numbered meshes, a 4D label map.

#include <map>
#include <string>
#include <vector>

#include "core/io/meshes/exported_object.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/over_time_report.h"
#include "core/volume/volume.h"

namespace handlebody {

//! True for .vtp (any case): its files are listed for ParaView.
bool hasCollection(const std::string& path);

//! The files of meshes of these frames: numberedPath of each; of .vtp also the list of them for ParaView
//! (collectionPath).
std::vector<std::string> frameMeshPaths(const std::string& path, const std::vector<int>& frames);

//! frameMeshPaths of the frames that have a surface. None of them gets its name before all are written; then
//! the files of the other frames, which are of an earlier run, are removed. Throws as writeMesh and
//! writeCollection, and Cancelled (cancellation.h).
void writeFrameMeshes(const OverTimeReport& over, CoordinateSpace space, const std::string& path);

//! A 4D label map of the frames of the range on `grid`; frames without a surface are empty. Precondition:
//! isSequencePath(path). Throws as writeSequence, and Cancelled.
void writeFrameLabels(const OverTimeReport& over, const ObjectLabel& label, const Grid& grid,
                      const std::string& path);

//! labelMapWarnings of each frame that has any.
std::map<int, std::vector<Finding>> frameLabelWarnings(const OverTimeReport& over, const Grid& grid,
                                                       const std::vector<std::string>& paths);

}  // namespace handlebody
