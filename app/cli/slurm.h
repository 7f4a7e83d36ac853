#pragma once
// A study as jobs of Slurm: an array with a task per case, and a summary job after it. Nothing of this
// program schedules across machines; each task is `batch --only-row`.

#include <string>
#include <vector>

namespace handlebody::cli {

struct SlurmStudy {
  std::string study;                  //!< path of the CSV file
  std::string text;                   //!< what was in it when the rows were numbered
  std::string folder;                 //!< of the results, absolute
  std::string base;                   //!< where relative paths of the study begin, absolute
  std::vector<std::string> settings;  //!< of `batch`, for every task
  std::vector<std::string> options;   //!< of sbatch, as the user gave them
  std::vector<int> rows;              //!< to be done, from 1, ascending
  int jobs = 0;                       //!< tasks at a time; 0: as many as the cluster runs
};

//! What sbatch called them.
struct SlurmJobs {
  std::vector<std::string> arrays;
  std::string summary;
};

//! A command line as CLI11 can parse it: what stands behind --slurm is sbatch's, each word as --slurm-option.
std::vector<std::string> withSlurmOptions(const std::vector<std::string>& arguments);

//! Writes the scripts and a copy of the study to a new folder in DIR/slurm and gives them to sbatch.
//! Precondition: there are rows. Throws UsageError if an option would undo that, there is no sbatch or it
//! refuses or a signal has come that is held back (DeferSignals): says what has been submitted before that.
//! Throws OutputError.
SlurmJobs submitToSlurm(const SlurmStudy& study);

}  // namespace handlebody::cli
