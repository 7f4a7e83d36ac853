#include "core/io/report/frame_files.h"

#include <filesystem>
#include <system_error>

#include "core/cancellation.h"
#include "core/io/atomic_file.h"
#include "core/io/formats/label_map.h"
#include "core/io/formats/sequence_writer.h"
#include "core/io/report/result.h"

namespace handlebody {

bool hasCollection(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending == ".vtp";
}

std::vector<std::string> frameMeshPaths(const std::string& path, const std::vector<int>& frames) {
  std::vector<std::string> paths;
  for (const int frame : frames) paths.push_back(numberedPath(path, frame));
  if (hasCollection(path)) paths.push_back(collectionPath(path));
  return paths;
}

namespace {

//! What an earlier run left there would pass for a surface of this one.
void removeMesh(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_directory(path, failed)) std::filesystem::remove(path, failed);
  if (failed && failed != std::errc::no_such_file_or_directory)
    refuseOutput(path, systemFinding(failed.value()));
}

}  // namespace

void writeFrameMeshes(const OverTimeReport& over, CoordinateSpace space, const std::string& path) {
  FileSet files;
  std::vector<int> written;
  for (const FrameResult& r : over.frames) {
    giveUpIfCancelled();
    if (r.mesh.triangles.empty()) continue;
    writeMesh(r.mesh, numberedPath(path, r.frame), space, {}, &files);
    written.push_back(r.frame);
  }
  if (hasCollection(path)) writeCollection(path, written, over.times, &files);
  giveUpIfCancelled();
  files.commit();
  for (const FrameResult& r : over.frames)
    if (r.mesh.triangles.empty()) removeMesh(numberedPath(path, r.frame));
}

void writeFrameLabels(const OverTimeReport& over, const ObjectLabel& label, const Grid& grid,
                      const std::string& path) {
  SequenceLayout layout;
  layout.grid = grid;
  layout.type = label.value > 255 ? VoxelType::uint16 : VoxelType::uint8;
  layout.frames = static_cast<int>(over.frames.size());
  std::vector<double> times;
  for (const VolumePoint& p : over.curve.points)
    if (p.time) times.push_back(*p.time);
  layout.times = checkedTimes(layout.frames, std::move(times), over.times.source);
  writeSequence(layout, path, [&](int i) {
    giveUpIfCancelled();
    const FrameResult& r = over.frames[i];
    void* zeros = nullptr;
    if (r.mesh.triangles.empty()) return makeVolume(layout.grid, layout.type, &zeros);
    return labelMap({{label, r.mesh}}, layout.grid);
  });
}

std::map<int, std::vector<Finding>> frameLabelWarnings(const OverTimeReport& over, const Grid& grid,
                                                       const std::vector<std::string>& paths) {
  std::map<int, std::vector<Finding>> all;
  for (const FrameResult& r : over.frames) {
    if (r.mesh.triangles.empty()) continue;  // that there is none is told of the frame
    if (std::vector<Finding> of = labelMapWarnings(r.mesh, grid, paths); !of.empty())
      all[r.frame] = std::move(of);
  }
  return all;
}

}  // namespace handlebody
