#pragma once
// From a loaded volume to files: what `segment` and `replay` share. Who calls has a PhaseLine.

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "app/cli/evolve.h"
#include "app/cli/object_options.h"
#include "app/cli/outputs.h"
#include "app/cli/sensitivity.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/report.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

//! A file of -o.
struct ResultFile {
  std::string path;
  int object = -1;  //!< index of the one that it holds; -1: all of them
};
std::vector<std::string> pathsOf(const std::vector<ResultFile>& files);

//! What a run writes and says.
struct RunOutputs {
  std::vector<std::string> results;  //!< -o, as given: FILE or NAME=FILE
  std::vector<ResultFile> files;     //!< the same by object (assignResults)
  std::string report, session, trace, picture, labelDescription;
  ObjectOptions object;
  DicomContent content;
  OnLeak onLeak = OnLeak::goOn;
  OnHeld onHeld = OnHeld::hold;
  std::optional<double> mesherSeconds;
  std::optional<bool> polish;  //!< none: as the session says
  bool quiet = false;
  bool listsCandidates = false;  //!< also where a boundary is beyond doubt
  SensitivityOptions sensitivity;
};

//! Adds -o, --report, --session, --trace, --picture, --label-description, --sensitivity, --quiet and what
//! DICOM files say.
void addRunOutputs(CLI::App& command, RunOutputs& outputs);
//! Adds --space; LPS unless given.
void addSpace(CLI::App& command, std::optional<CoordinateSpace>& space);

//! Sorts -o by object. NAME=FILE holds the object of that name alone. Throws UsageError for a name that no
//! object has; with a single object such a text is a path.
void assignResults(RunOutputs& outputs, const std::vector<ObjectLabel>& objects);

//! Before any work, after assignResults: throws UsageError if an output, or one of the further `files`, has
//! no known extension or cannot be written.
void checkOutputs(const RunOutputs& outputs, const std::vector<std::string>& inputs,
                  std::vector<OutputFile> files = {});

//! Before the growth: throws OutputError, UsageError if a DICOM file of -o cannot hold the names of its
//! objects.
void checkNames(const std::vector<ObjectLabel>& objects, const VolumeInfo& info, const RunOutputs& outputs);

//! The object is a surface that stays as it is: nothing grows.
bool isGiven(const Session& session);

//! Seconds since it was made or last asked.
class Stopwatch {
 public:
  double lap();

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

//! A session whose volume is in memory.
struct LoadedSession {
  Session session;
  Volume volume;
  VolumeInfo info;
  double loadSeconds = 0;
};

//! Reads the volume of a session; its warnings are said on standard error. Throws InputError: if
//! the session holds a hash that is not the file's, or voxels that are not the series', too; where it holds
//! no hash, it gets it. `isAnonymous`: it gets its voxels, too, if its series was chosen (keepVoxels).
LoadedSession load(Session session, bool isAnonymous = false);

//! Grows the surface, certifies it and writes everything; returns the exit code. Throws SeedError,
//! UsageError, OutputError; std::runtime_error if the mesh fails its certificate (nothing is written then).
int run(LoadedSession loaded, const RunOutputs& outputs);

//! An object that has been grown and passed its certificate.
struct GrownObject {
  RunReport report;          //!< without the seconds of the export, and of all
  TriangleSoup mesh;         //!< as it is written, but for a polish that has yet to come
  PolishOptions polish;      //!< for that
  CertifiedMesh unpolished;  //!< as it grew
};

//! Which of the objects of a run it is.
enum class Among { none, others };

//! Grows one object; says its warnings on standard error, behind `name` if that is not empty. Throws as run.
//! Among others it is not polished yet: what they grow up to, as walls, is the surface that grew.
GrownObject grow(LoadedSession loaded, const RunOutputs& outputs, Among among = Among::none,
                 const std::string& name = {});

//! Betters the mesh of one that was grown among others, which are obstacles, and tells of it as `grow` does.
void polishAmong(GrownObject& object, const std::vector<const TriangleSoup*>& others, const Volume& volume,
                 const RunOutputs& outputs);

//! The object's label as its files have it: see sourceInFiles.
ObjectLabel labelInFiles(const RunReport& report, const RunOutputs& outputs);

//! Writes every file of -o, and the description of the labels. Throws OutputError, UsageError.
void writeObjects(const std::vector<ExportedObject>& objects, const RunReport& report,
                  const RunOutputs& outputs);
//! Writes --sensitivity-surface, if there is anything to tell of. Throws as writeMeshWithValues.
void writeSpread(const TriangleSoup& mesh, const RunReport& report, const RunOutputs& outputs);
//! Writes session, trace and report. Throws OutputError.
void writeSideFiles(RunReport report, const RunOutputs& outputs);
//! Writes the results and then what tells of them, session and report: these also where a result cannot be
//! written, so that a long growth is not lost. Throws what went wrong first; after Cancelled nothing more is
//! written.
void writeAll(const std::function<void()>& results, const std::function<void()>& sideFiles);
//! Of what the reports tell; kLeak goes before kMaxIterations.
int exitCodeOf(const std::vector<RunReport>& reports);

//! One line on standard output, behind `name` if that is not empty.
void printSummary(const RunReport& report, const std::string& name = {});

}  // namespace handlebody::cli
