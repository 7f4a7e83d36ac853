#include "app/cli/outputs.h"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "app/picture/picture.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/formats/volume_files.h"
#include "core/io/meshes/gltf.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/meshes/three_mf.h"
#include "core/io/report/option_error.h"
#include "core/io/report/result.h"
#include "core/io/tetrahedra/tetrahedra.h"

namespace handlebody::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const OutputFile& file, const std::string& why) {
  throw OptionError(file.option, file.path + " cannot be written: " + why + ".", " ");
}

// Permission bits do not tell the truth for root, read-only mounts or /proc: only trying does.
void checkFolder(const OutputFile& file, const fs::path& folder) {
  if (!fs::exists(folder)) refuse(file, "the folder " + folder.string() + " does not exist");
  if (!fs::is_directory(folder)) refuse(file, folder.string() + " is not a folder");
  std::string probe = (folder / ".handlebody-XXXXXX").string();
  const int descriptor = ::mkstemp(probe.data());
  if (descriptor < 0)
    refuse(file, "its folder takes no new file (" + std::string(std::strerror(errno)) + ")");
  ::close(descriptor);
  ::unlink(probe.c_str());
}

fs::path identity(const std::string& path) { return fs::weakly_canonical(fs::absolute(behindLinks(path))); }

//! What is read of a volume must not be written.
void requireFree(const OutputFile& file, const std::string& input) {
  if (!belongsToVolume(file.path, input)) return;
  refuse(file, fs::is_directory(input)
                   ? "it would lie in the folder of the input, all of whose files belong to the volume"
                   : "it is the input");
}

}  // namespace

void checkWritable(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs) try {
  std::vector<fs::path> seen;
  for (const OutputFile& file : files) {
    if (file.path.empty()) throw UsageError(file.option + " needs a file name.");
    const fs::path path = identity(file.path);
    if (fs::is_directory(path)) refuse(file, "it is a folder");
    if (fs::exists(path) && !fs::is_regular_file(path)) refuse(file, "it is not a regular file");
    for (const std::string& input : inputs) requireFree(file, input);
    if (std::find(seen.begin(), seen.end(), path) != seen.end()) refuse(file, "it is named twice");
    checkFolder(file, path.parent_path());
    seen.push_back(path);
  }
} catch (const fs::filesystem_error& error) {
  throw UsageError(std::string("an output cannot be written: ") + error.what() + ".");
}

void checkMeshExtension(const OutputFile& file) {
  if (!isMeshPath(file.path))
    throw OptionError(file.option, file.path + ": unknown extension; a mesh is .stl, .vtp, .ply or .obj.",
                      " ");
}

void checkSurfaceExtension(const OutputFile& file) {
  const std::string& path = file.path;
  if (!isMeshPath(path) && !isThreeMfPath(path) && !isGltfPath(path) && !isTetrahedraPath(path))
    throw OptionError(file.option,
                      path +
                          ": unknown extension; a mesh is .stl, .vtp, .ply, .obj, .3mf or .gltf, "
                          "tetrahedra are .msh, .vtu or .inp.",
                      " ");
}

void checkVolumeExtension(const OutputFile& file) {
  if (!isLabelMapPath(file.path))
    throw OptionError(file.option,
                      file.path + ": unknown extension; a volume is .nii, .nii.gz, .nrrd or .mha.", " ");
}

void checkPictureExtension(const OutputFile& file) {
  if (!isPicturePath(file.path))
    throw OptionError(file.option, file.path + ": unknown extension; a picture is .png.", " ");
}

void checkResultExtension(const OutputFile& file) {
  if (!isResultPath(file.path))
    throw OptionError(file.option, file.path + ": unknown extension; " + resultEndings() + ".", " ");
}

void checkSpace(std::optional<CoordinateSpace> space, const std::vector<std::string>& results,
                const std::string& session) {
  if (space == CoordinateSpace::ras && session.empty() && areSpacesFixed(results))
    throw OptionError("--space",
                      "RAS has no effect: it is for meshes, of which .gltf (in metres, y up) and .stl.dcm "
                      "(LPS) have a space of their own.",
                      " ");
}

namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
// A handler is given nothing but the number of the signal.
volatile std::sig_atomic_t receivedSignal = 0;
std::atomic<bool> isReceived{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal's handler sets it
void remember(int signal) {
  receivedSignal = signal;
  isReceived = true;
}

}  // namespace

DeferSignals::DeferSignals() {
  receivedSignal = 0;
  isReceived = false;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    previous_[i] = std::signal(kSignals[i], remember);
    if (previous_[i] == SIG_IGN) std::signal(kSignals[i], SIG_IGN);  // nohup
  }
}

bool DeferSignals::isPending() { return receivedSignal != 0; }

const std::atomic<bool>& DeferSignals::stopToken() { return isReceived; }

DeferSignals::~DeferSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) std::signal(kSignals[i], previous_[i]);
  if (receivedSignal != 0) std::raise(receivedSignal);
}

}  // namespace handlebody::cli
