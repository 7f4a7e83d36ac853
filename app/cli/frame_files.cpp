#include "app/cli/frame_files.h"

#include <cstdio>
#include <utility>

#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/formats/sequence_writer.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/frame_files.h"
#include "core/io/report/option_error.h"

namespace handlebody::cli {

void checkFrameFile(const std::string& option, const std::string& path) {
  if (isMeshPath(path) || isSequencePath(path)) return;
  throw OptionError(
      option,
      path + ": with --frames a mesh is .stl, .vtp, .ply or .obj, a label map .nii.gz, .nii or .nrrd.", " ");
}

void checkFrameFiles(const RunOutputs& outputs, const std::vector<std::string>& curves,
                     const OverTimeRequest::Range& range, const std::vector<std::string>& inputs) {
  if (!outputs.labelDescription.empty() || !outputs.content.creator.empty() ||
      !outputs.content.description.empty())
    throw UsageError("--label-description, --creator and --description do not go with --frames.");
  RunOutputs every = outputs;
  every.files.clear();
  std::vector<OutputFile> others;
  for (const ResultFile& file : outputs.files) {
    checkFrameFile("-o", file.path);
    if (!isMeshPath(file.path)) {
      every.files.push_back(file);
      continue;
    }
    for (int frame = range.first; frame <= range.last; ++frame)
      every.files.push_back({numberedPath(file.path, frame), file.object});
    if (hasCollection(file.path)) others.push_back({"-o", collectionPath(file.path)});
  }
  for (const std::string& curve : curves) {
    if (!curve.ends_with(".csv") && !curve.ends_with(".svg"))
      throw UsageError("--curve " + curve + ": a table is .csv, a plot .svg.");
    others.push_back({"--curve", curve});
  }
  checkOutputs(every, inputs, std::move(others));
}

void warnOfLabelMap(const OverTimeReport& over, const Grid& grid, const RunOutputs& outputs) {
  for (const auto& [frame, warnings] : frameLabelWarnings(over, grid, pathsOf(outputs.files)))
    for (const std::string& warning : sentences(warnings))
      std::fprintf(stderr, "handlebody-cli: warning: frame %d: %s\n", frame, warning.c_str());
}

void writeFrameFiles(const RunReport& report, const RunOutputs& outputs,
                     const std::vector<std::string>& curves) {
  const OverTimeReport& over = *report.overTime;
  for (const ResultFile& file : outputs.files)
    if (isMeshPath(file.path))
      writeFrameMeshes(over, report.session.space, file.path);
    else
      writeFrameLabels(over, report.session.label, report.volume.grid, file.path);
  const OverTimeReport told = outputs.content.anonymous ? anonymous(over) : over;
  for (const std::string& curve : curves)
    writeTextAtomically(curve, curve.ends_with(".csv") ? curveCsv(told) : curveSvg(told));
}

}  // namespace handlebody::cli
