#pragma once
// What is written of a surface over time: numbered meshes, a 4D label map, the curve.

#include <string>
#include <vector>

#include "app/cli/run.h"

namespace handlebody::cli {

//! Throws UsageError, which names the option, for a file that can hold no surface over time.
void checkFrameFile(const std::string& option, const std::string& path);

//! Throws UsageError for files of -o and --curve that cannot hold frames, or as checkOutputs, for each file
//! of each frame.
void checkFrameFiles(const RunOutputs& outputs, const std::vector<std::string>& curves,
                     const OverTimeRequest::Range& range, const std::vector<std::string>& inputs);

//! Says on standard error what a label map of -o leaves out of frames.
void warnOfLabelMap(const OverTimeReport& over, const Grid& grid, const RunOutputs& outputs);

//! Writes the files of -o and the curves. Frames without a surface have no mesh file, and no voxel in the
//! label map. Precondition: report.overTime. Throws OutputError.
void writeFrameFiles(const RunReport& report, const RunOutputs& outputs,
                     const std::vector<std::string>& curves);

}  // namespace handlebody::cli
