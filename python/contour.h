#pragma once
// A contour as Python has it: with what was told on its way, and snapshots of its surface. Knows nothing of
// Python, so that it works without the interpreter's lock.

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "core/io/report/growth_report.h"
#include "python/mesh.h"

namespace handlebody::python {

//! A volume that was read or made, with the hash of its file if it has one.
struct PythonVolume {
  LoadedVolume loaded;
  VolumeReference reference{};
};

class Contour {
 public:
  //! `asked` holds seeds (mm LPS) and parameters; label maps of walls are read, with the decoder of its
  //! volume's selection. Throws as ActiveContour and loadWalls.
  Contour(std::shared_ptr<const PythonVolume> volume, Session asked);
  //! Goes on exactly as the original would.
  Contour(const Contour& other);

  //! To be held while one of the functions below works; throws std::runtime_error if another thread holds it.
  std::unique_lock<std::mutex> hold() const;

  //! One iteration. Throws UsageError if the growth has ended, and as ActiveContour::step.
  StepReport step();
  //! Steps until the growth ends, or `most` of them, or until a step tells a leak if `untilLeak`. What was
  //! done before something was thrown stays. Throws UsageError for a veto, a pin or an edit that the growth
  //! did not come to.
  void run(std::optional<int> most, bool untilLeak);

  //! Goes on with other parameters and constraints, and with the seeds of `what` besides those that there
  //! are; its iteration is not looked at. It is recorded for the session. Throws UsageError if this iteration
  //! was changed already, and as ActiveContour::change; nothing has changed then.
  void change(ParameterChange what);

  //! Of the last step that was made; may be asked at any time, also while another thread steps.
  int iteration() const { return iteration_; }
  StopReason stopReason() const { return stopReason_; }

  //! The surface of this iteration, as the engine has it, without free slots.
  std::shared_ptr<const TriangleSoup> surface() const;
  //! The mesh of this iteration as the command line writes it. Throws as grownMesh.
  const PythonMesh& mesh() const;
  //! With warnings; with measures and tunnels if `isComplete`. Throws as mesh().
  RunReport report(bool isComplete) const;
  const RunReport& told() const { return told_; }
  const ActiveContour& active() const { return active_; }
  const PythonVolume& volume() const { return *volume_; }
  //! What `handlebody-cli replay` and the window take. Throws UsageError if the volume has no file, or `path`
  //! belongs to a file that the session reads.
  void writeSession(const std::string& path) const;

 private:
  void tellIteration();

  std::shared_ptr<const PythonVolume> volume_;
  RunReport told_;
  ActiveContour active_;
  std::atomic<int> iteration_{0};
  std::atomic<StopReason> stopReason_{StopReason::running};
  mutable std::mutex busy_;
  mutable std::shared_ptr<const TriangleSoup> surface_;  // of this iteration; null: not asked for yet
  mutable std::optional<PythonMesh> mesh_;               // the same
  mutable std::optional<PolishReport> polish_;           // of that mesh; none: not polished
};

}  // namespace handlebody::python
