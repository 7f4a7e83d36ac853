#pragma once
// The files a run writes: checked before the work, written whole after it.

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "core/io/report/report.h"

namespace handlebody::cli {

//! A file that an option asks for.
struct OutputFile {
  std::string option;  //!< for messages
  std::string path;
};

//! Throws UsageError that names the option if a file could not be written: its folder is missing or closed to
//! us, it is a folder itself, two options name it, or it is one of the inputs or of the files that they are
//! in (belongsToVolume), which would be destroyed, or a new one in the folder of an input.
void checkWritable(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs);

//! Throws UsageError unless the extension is one of a mesh or a label map.
void checkResultExtension(const OutputFile& file);
void checkMeshExtension(const OutputFile& file);
//! Of a mesh or of what is made of one without a volume: a mesh, .3mf, .gltf, tetrahedra.
void checkSurfaceExtension(const OutputFile& file);
void checkVolumeExtension(const OutputFile& file);
//! Throws UsageError unless it is .png.
void checkPictureExtension(const OutputFile& file);

//! Throws UsageError if RAS was chosen, there is no `session` to keep it, and all results are of formats
//! whose space is fixed: it would be of no effect.
void checkSpace(std::optional<CoordinateSpace> space, const std::vector<std::string>& results,
                const std::string& session = {});

//! Holds interrupt, termination and hang-up back while it lives, so that no file is left half-written; a
//! signal that came takes effect when it goes.
class DeferSignals {
 public:
  DeferSignals();
  ~DeferSignals();
  DeferSignals(const DeferSignals&) = delete;
  DeferSignals& operator=(const DeferSignals&) = delete;
  //! One came.
  static bool isPending();
  //! The same, for a CancelScope: work that takes long need not be waited for.
  static const std::atomic<bool>& stopToken();

 private:
  std::array<void (*)(int), 3> previous_{};
};

}  // namespace handlebody::cli
