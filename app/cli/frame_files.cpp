#include "app/cli/frame_files.h"

#include <filesystem>

#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/label_map.h"
#include "core/io/mesh_io.h"
#include "core/io/sequence_writer.h"

namespace handlebody::cli {

namespace {

bool isVtp(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending == ".vtp";
}

void checkFrameFile(const std::string& path) {
  if (isMeshPath(path) || isSequencePath(path)) return;
  throw UsageError("-o " + path +
                   ": with --frames a mesh is .stl, .vtp, .ply or .obj, a label map .nii.gz, .nii or .nrrd.");
}

void writeMeshes(const OverTimeReport& over, CoordinateSpace space, const std::string& path) {
  std::vector<int> written;
  for (const FrameResult& r : over.frames) {
    if (r.mesh.triangles.empty()) continue;
    writeMesh(r.mesh, numberedPath(path, r.frame), space);
    written.push_back(r.frame);
  }
  if (isVtp(path)) writeCollection(path, written, over.times);
}

void writeLabels(const RunReport& report, const std::string& path) {
  const OverTimeReport& over = *report.overTime;
  const ObjectLabel& label = report.session.label;
  SequenceLayout layout;
  layout.grid = report.volume.grid;
  layout.type = label.value > 255 ? VoxelType::uint16 : VoxelType::uint8;
  layout.frames = static_cast<int>(over.frames.size());
  std::vector<double> times;
  for (const VolumePoint& p : over.curve.points)
    if (p.time) times.push_back(*p.time);
  layout.times = checkedTimes(layout.frames, std::move(times), over.times.source);
  writeSequence(layout, path, [&](int i) {
    const FrameResult& r = over.frames[static_cast<std::size_t>(i)];
    void* zeros = nullptr;
    if (r.mesh.triangles.empty()) return makeVolume(layout.grid, layout.type, &zeros);
    return labelMap({{label, r.mesh}}, layout.grid);
  });
}

}  // namespace

void checkFrameFiles(const RunOutputs& outputs, const std::vector<std::string>& curves,
                     const OverTimeRequest::Range& range, const std::vector<std::string>& inputs) {
  if (!outputs.labelDescription.empty() || !outputs.content.creator.empty() ||
      !outputs.content.description.empty())
    throw UsageError("--label-description, --creator and --description do not go with --frames.");
  RunOutputs every = outputs;
  every.files.clear();
  std::vector<OutputFile> others;
  for (const ResultFile& file : outputs.files) {
    checkFrameFile(file.path);
    if (!isMeshPath(file.path)) {
      every.files.push_back(file);
      continue;
    }
    for (int frame = range.first; frame <= range.last; ++frame)
      every.files.push_back({numberedPath(file.path, frame), file.object});
    if (isVtp(file.path)) others.push_back({"-o", collectionPath(file.path)});
  }
  for (const std::string& curve : curves) {
    if (!curve.ends_with(".csv") && !curve.ends_with(".svg"))
      throw UsageError("--curve " + curve + ": a table is .csv, a plot .svg.");
    others.push_back({"--curve", curve});
  }
  checkOutputs(every, inputs);
  checkWritable(others, inputs);
}

void writeFrameFiles(const RunReport& report, const RunOutputs& outputs,
                     const std::vector<std::string>& curves) {
  const OverTimeReport& over = *report.overTime;
  for (const ResultFile& file : outputs.files)
    if (isMeshPath(file.path))
      writeMeshes(over, report.session.space, file.path);
    else
      writeLabels(report, file.path);
  const OverTimeReport told = outputs.content.anonymous ? anonymous(over) : over;
  for (const std::string& curve : curves)
    writeTextAtomically(curve, curve.ends_with(".csv") ? curveCsv(told) : curveSvg(told));
}

}  // namespace handlebody::cli
