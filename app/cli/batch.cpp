#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <list>
#include <memory>
#include <thread>
#include <utility>

#include "app/cli/case_folder.h"
#include "app/cli/command.h"
#include "app/cli/csv.h"
#include "app/cli/outputs.h"
#include "app/cli/slurm.h"
#include "app/cli/summary.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/report/json.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"
#include "core/threads.h"
#include "core/version.h"

namespace handlebody::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMaxJobs = 256;
constexpr double kHour = 3600;
constexpr auto kPause = std::chrono::milliseconds(10);
constexpr const char* kEndedFromOutside =
    "its process was ended before it was done (a limit of time or memory, its machine, or a cancellation).";

struct BatchOptions {
  std::string study, folder;
  int jobs = 0;  //!< 0: not given
  StudyDefaults defaults{{kHour, 0}, "stl", ""};
  bool quiet = false;
  int onlyRow = 0;  //!< 0: all of them
  bool onlySummary = false;
  bool slurm = false;
  std::vector<std::string> slurmOptions;
};

//! A case at work.
struct Job {
  std::size_t index;
  std::unique_ptr<CaseProcess> process;
};

class Batch {
 public:
  Batch(const BatchOptions& options, FolderUse use)
      : options_(options),
        jobsAtATime_(std::max(options.jobs, 1)),
        text_(readFile(options.study)),
        cases_(casesOf(options, text_)),
        folder_(options.folder, use) {
    folder_.requireOwn(cases_);
    summary_.study = std::filesystem::path(options.study).filename().string();
    summary_.version = HANDLEBODY_VERSION;
    for (const StudyCase& c : cases_) {
      summary_.rows.push_back(rowOf(c));
      reasons_.push_back(c.fault);
    }
  }

  int run() {
    const DeferSignals stopCleanly;
    sayRefused();
    findDone();
    if (DeferSignals::isPending()) return kIncomplete;  // not all that is done has been found
    forgetFailures();
    while (startJobs(), !jobs_.empty() && !DeferSignals::isPending()) {
      writeMeanwhile(collect());
      std::this_thread::sleep_for(kPause);
    }
    stopJobs();
    return sumUp();
  }

  //! One case alone; other processes may be at work on others. Leaves the summary as it is.
  int runRow(int number) {
    const DeferSignals stopCleanly;
    if (number > static_cast<int>(cases_.size()))
      throw OptionError("--only-row", "'" + std::to_string(number) + "' is not there: " + options_.study +
                                          " has " + std::to_string(cases_.size()) + " rows.");
    const std::size_t i = static_cast<std::size_t>(number) - 1;
    SummaryRow& row = summary_.rows[i];
    if (row.status == CaseStatus::refused) {
      say(i);
      return kIncomplete;
    }
    const auto hold = folder_.hold(cases_[i]);
    if (!hold->isMine()) throw UsageError("case '" + row.name + "': another process is at work on it.");
    if (folder_.isDone(cases_[i]) && showResult(i)) {
      folder_.forgetFailure(cases_[i]);
      return kDone;
    }
    startJob(i);
    while (!jobs_.empty() && !DeferSignals::isPending()) {
      collect();
      std::this_thread::sleep_for(kPause);
    }
    if (!jobs_.empty()) {
      jobs_.clear();
      fail(i, "it was stopped from outside before it was done.");
      say(i);
    }
    return row.status == CaseStatus::done ? kDone : kIncomplete;
  }

  //! What has become of the cases that were run one by one. Interrupted, it leaves the summary as it is.
  int tell() {
    const DeferSignals stopCleanly;
    findDone();
    if (DeferSignals::isPending()) return kIncomplete;  // not all that is done has been found
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (summary_.rows[i].status == CaseStatus::notRun) tellUnfinished(i);
    return sumUp();
  }

  //! Numbers of the rows, from 1, that are neither done nor refused; the summary tells the others.
  //! Interrupted, it leaves the summary as it is, and the signal ends the program.
  std::vector<int> rowsToDo() {
    const DeferSignals stopCleanly;
    sayRefused();
    findDone();
    if (DeferSignals::isPending()) return {};
    forgetFailures();
    writeSummary();
    std::vector<int> numbers;
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (summary_.rows[i].status == CaseStatus::notRun) numbers.push_back(static_cast<int>(i) + 1);
    return numbers;
  }

  const std::string& text() const { return text_; }
  const std::string& folder() const { return folder_.path(); }

  int sumUp() {
    writeSummary();
    if (!options_.quiet) printCounts();
    return summary_.count(CaseStatus::done) == static_cast<int>(cases_.size()) ? kDone : kIncomplete;
  }

 private:
  //! Before anything is made in the folder.
  static std::vector<StudyCase> casesOf(const BatchOptions& options, const std::string& text) {
    std::vector<StudyCase> cases = readStudy(text, options.study, options.defaults);
    BatchFolder::requireApart(options.folder, options.study, cases);
    return cases;
  }

  static SummaryRow rowOf(const StudyCase& c) {
    SummaryRow row;
    row.line = c.line;
    row.name = c.name;
    row.volume = c.volume;
    row.message = c.fault.empty() ? "It has not been run yet." : c.toldFault;
    row.status = c.fault.empty() ? CaseStatus::notRun : CaseStatus::refused;
    return row;
  }

  void sayRefused() const {
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (summary_.rows[i].status == CaseStatus::refused) say(i);
  }

  //! Hashes the volumes of what was done before, on as many threads as there will be jobs.
  void findDone() {
    std::vector<char> done(cases_.size(), 0);  // not bool: written by several threads
    forEachOnThreads(cases_.size(), jobsAtATime_, [&](std::size_t i) {
      if (DeferSignals::isPending()) return;
      done[i] = cases_[i].fault.empty() && folder_.isDone(cases_[i]) ? 1 : 0;
    });
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (done[i] != 0) kept_ += showResult(i) ? 1 : 0;
  }

  //! What is done may have failed later with other options. Precondition: nobody else is at work.
  void forgetFailures() const {
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (summary_.rows[i].status == CaseStatus::done) folder_.forgetFailure(cases_[i]);
  }

  //! False if there is none that can be read.
  bool showResult(std::size_t i) try {
    SummaryRow& row = summary_.rows[i];
    const std::string folder = BatchFolder::folderOf(cases_[i]);
    row.measures = readMeasures(folder_.absolute(folder));
    row.thumbnail = readFile(folder_.absolute(folder) + "/thumbnail.png");
    row.folder = folder;
    row.files = BatchFolder::resultsOf(cases_[i], folder_.absolute(folder));
    row.files.insert(row.files.end(), {"report.json", "session.json"});
    if (!cases_[i].isAnonymous) row.files.emplace_back("log.txt");
    row.message.clear();
    row.log.clear();
    row.status = CaseStatus::done;
    return true;
  } catch (const InputError&) {
    return false;
  }

  void startJobs() {
    while (next_ < cases_.size() && static_cast<int>(jobs_.size()) < jobsAtATime_ &&
           !DeferSignals::isPending()) {
      const std::size_t i = next_++;
      if (summary_.rows[i].status == CaseStatus::notRun) startJob(i);
    }
  }

  void startJob(std::size_t i) try {
    jobs_.push_back({i, start(cases_[i])});
  } catch (const std::exception& error) {
    fail(i, error.what());
    say(i);
  }

  std::unique_ptr<CaseProcess> start(const StudyCase& c) const {
    const std::string folder = folder_.begin(c);
    std::vector<std::string> arguments{"segment", c.volumePath, "--quiet"};
    arguments.insert(arguments.end(), c.options.begin(), c.options.end());
    // Jobs beside each other share the machine.
    const auto namesThreads = [](const std::string& o) { return o.starts_with("--threads"); };
    if (std::none_of(c.options.begin(), c.options.end(), namesThreads))
      arguments.push_back("--threads=" + std::to_string(std::max(1, threadCount(0) / jobsAtATime_)));
    for (const StudyInput& input : c.inputs) arguments.push_back(argumentOf(input));
    for (const std::string& file : c.outputs) arguments.push_back("--output=" + folder + "/" + file);
    for (const char* kind : {"report", "session"})
      arguments.push_back("--" + std::string(kind) + "=" + folder + "/" + kind + ".json");
    if (c.isOverTime())
      for (const char* file : {"curve.csv", "curve.svg"})
        arguments.push_back("--curve=" + folder + "/" + file);
    arguments.push_back("--picture=" + folder + "/picture.png");
    return std::make_unique<CaseProcess>(arguments, folder + "/log.txt", c.limits);
  }

  //! True if one has ended.
  bool collect() {
    bool isNew = false;
    for (auto job = jobs_.begin(); job != jobs_.end();) {
      if (!job->process->hasEnded()) {
        ++job;
        continue;
      }
      settle(job->index, job->process->end());
      job = jobs_.erase(job);
      isNew = true;
    }
    return isNew;
  }

  void settle(std::size_t i, const CaseEnd& end) {
    // Of a case over time in which frames failed there are results, and the summary says which.
    const bool isIncomplete = end.exitCode == kIncomplete && cases_[i].isOverTime();
    if (isIncomplete || end.exitCode == kDone || end.exitCode == kMaxIterations || end.exitCode == kLeak)
      finish(i, end);
    else
      fail(i, failureSentence(end, cases_[i].limits, folder_.logOfWork(cases_[i])),
           anonymousFailureSentence(end, cases_[i].limits));
    say(i);
  }

  //! A full disk, say, is the failure of the case: others may have room.
  void finish(std::size_t i, const CaseEnd& end) try {
    folder_.finish(cases_[i], end);
    if (!showResult(i)) fail(i, "its report cannot be read.");
  } catch (const std::exception& error) {
    fail(i, error.what());
  }

  //! `anonymous`: what is written in its place of an anonymous case; empty: the reason names no source.
  void fail(std::size_t i, const std::string& why, const std::string& anonymous = {}) {
    const bool isHidden = cases_[i].isAnonymous && !anonymous.empty();
    folder_.fail(cases_[i], isHidden ? anonymous : why);
    tellFailure(i, isHidden ? anonymous : why);
    reasons_[i] = why;
  }

  void tellFailure(std::size_t i, const std::string& why) {
    SummaryRow& row = summary_.rows[i];
    row.status = CaseStatus::failed;
    row.message = reasons_[i] = why;
    if (folder_.hasResults(cases_[i]))
      row.message += " (Its folder holds the result of an earlier run, of other inputs or options.)";
    const bool hasLog = !cases_[i].isAnonymous && folder_.hasLogOfFailure(cases_[i]);
    row.log = hasLog ? BatchFolder::logOf(cases_[i]) : "";
  }

  void tellUnfinished(std::size_t i) {
    const StudyCase& c = cases_[i];
    if (folder_.isBegun(c)) {
      if (folder_.hold(c)->isMine()) {
        tellFailure(i, kEndedFromOutside);
        summary_.rows[i].log.clear();
      } else {
        summary_.rows[i].message = "It is being worked on.";
      }
    } else if (const std::string why = folder_.failureOf(c); !why.empty()) {
      tellFailure(i, why);
    }
  }

  void stopJobs() {
    for (Job& job : jobs_) {
      job.process.reset();
      folder_.abandon(cases_[job.index]);
    }
    jobs_.clear();
  }

  void say(std::size_t i) const {
    const SummaryRow& row = summary_.rows[i];
    const bool isGood = row.status == CaseStatus::done;
    if (isGood && options_.quiet) return;
    const std::string& why = cases_[i].isAnonymous ? reasons_[i] : row.message;
    std::fprintf(stderr, "%s: %s%s%s\n", row.name.c_str(), statusName(row.status), isGood ? "" : ": ",
                 isGood ? "" : why.c_str());
  }

  //! While cases are at work: what cannot be written now, on a full disk, say, is no reason to end them. It
  //! is written again in the end.
  void writeMeanwhile(bool isNew) try {
    if (isNew) writeTables();
    if (Clock::now() - written_ > std::chrono::seconds(10)) writeSummary();
  } catch (const OutputError& error) {
    written_ = Clock::now();  // not at every turn
    if (!std::exchange(isWriteFaultTold_, true))
      std::fprintf(stderr, "%s The cases go on; it is tried again.\n", error.what());
  }

  //! After every case.
  void writeTables() {
    writeTextAtomically(folder_.absolute("summary.csv"), summaryCsv(summary_));
    writeTextAtomically(folder_.absolute("summary.json"), summaryJson(summary_));
  }

  //! With the page, which holds all pictures: for large studies too much to write it after every case.
  void writeSummary() {
    writeTables();
    writeTextAtomically(folder_.absolute("index.html"), summaryPage(summary_));
    written_ = Clock::now();
  }

  void printCounts() const {
    std::printf("%d done (%d of them before), %d failed, %d refused, %d not run: %s\n",
                summary_.count(CaseStatus::done), kept_, summary_.count(CaseStatus::failed),
                summary_.count(CaseStatus::refused), summary_.count(CaseStatus::notRun),
                folder_.absolute("index.html").c_str());
    std::fflush(stdout);  // a signal that came ends the program without that
  }

  const BatchOptions& options_;
  int jobsAtATime_;
  std::string text_;  // of the study, as its rows were read
  std::vector<StudyCase> cases_;
  BatchFolder folder_;
  Summary summary_;
  std::vector<std::string> reasons_;  // why there is no result, as whoever runs the batch is told
  std::list<Job> jobs_;
  std::size_t next_ = 0;
  int kept_ = 0;
  Clock::time_point written_ = Clock::now();
  bool isWriteFaultTold_ = false;
};

//! The settings of a whole batch, for each of its tasks.
std::vector<std::string> settingsOf(const BatchOptions& o) {
  return {"--time-limit=" + Json(o.defaults.limits.seconds).dump(),
          "--memory-limit=" + std::to_string(o.defaults.limits.bytes >> 20U),
          "--format=" + o.defaults.format};
}

//! Whoever interrupts it wants the numbers even of a quiet one.
void tellSubmitted(const BatchOptions& o, const SlurmStudy& study, const SlurmJobs& jobs) {
  if (o.quiet && !DeferSignals::isPending()) return;
  std::string numbers;
  for (const std::string& array : jobs.arrays) numbers += (numbers.empty() ? "" : ", ") + array;
  std::printf("%zu cases submitted as job %s, their summary as job %s: %s/index.html\n", study.rows.size(),
              numbers.c_str(), jobs.summary.c_str(), study.folder.c_str());
  std::fflush(stdout);  // a signal that came ends the program without that
}

int submit(const BatchOptions& o) {
  SlurmStudy study;
  study.study = o.study;
  study.base = folderOfPaths(o.study, o.defaults);
  study.settings = settingsOf(o);
  study.options = o.slurmOptions;
  study.jobs = o.jobs;
  {
    Batch batch(o, FolderUse::alone);
    study.text = batch.text();
    study.folder = batch.folder();
    study.rows = batch.rowsToDo();
    if (study.rows.empty()) return batch.sumUp();
  }  // the folder is free: tasks may begin at once
  const DeferSignals sayFirst;
  try {
    tellSubmitted(o, study, submitToSlurm(study));
    return kDone;
  } catch (const UsageError& error) {
    if (!DeferSignals::isPending()) throw;
    std::fprintf(stderr, "handlebody-cli: %s\n", error.what());  // nobody else will: the signal ends us here
    return kUsage;
  }
}

int perform(const BatchOptions& o) {
  if (o.slurm) return submit(o);
  if (o.onlyRow > 0) return Batch(o, FolderUse::shared).runRow(o.onlyRow);
  if (o.onlySummary) return Batch(o, FolderUse::shared).tell();
  return Batch(o, FolderUse::alone).run();
}

//! For one process of several.
void addPartOptions(CLI::App& command, BatchOptions& o) {
  command
      .add_option("--relative-to", o.defaults.folder,
                  "Where relative paths of the table begin (default: its folder)")
      ->type_name("FOLDER");
  const auto setRow = [&o](const std::string& text) {
    o.onlyRow = parseInteger("--only-row", text, 1, std::numeric_limits<int>::max());
  };
  CLI::Option* row = command
                         .add_option_function<std::string>(
                             "--only-row", setRow,
                             "That case alone, from 1; other processes may do others in the same folder")
                         ->type_name("N");
  CLI::Option* summary =
      command.add_flag("--only-summary", o.onlySummary, "Run nothing, tell what became of the cases")
          ->excludes(row);
  command
      .add_flag("--slurm", o.slurm,
                "Submit the cases to Slurm as an array of jobs, and their summary after them; all that "
                "follows goes to sbatch")
      ->excludes(row)
      ->excludes(summary);
  command.add_option("--slurm-option", o.slurmOptions)->group("");  // see withSlurmOptions
}

}  // namespace

void addBatch(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(app, "batch", "Run `segment` on every row of a table");
  auto o = std::make_shared<BatchOptions>();
  command->add_option("STUDY.csv", o->study, "One row a case. Columns: " + studyColumns())->required();
  command->add_option("-o,--output", o->folder, "The folder of the results; what is done there is kept")
      ->type_name("DIR")
      ->required();
  const auto add = [&](const std::string& name, const std::string& type, const std::string& help, auto set) {
    command
        ->add_option_function<std::string>(
            name, [name, set](const std::string& text) { set(name, text); }, help)
        ->type_name(type);
  };
  add("--jobs", "N", "Cases at a time (default 1)",
      [o](auto& name, auto& text) { o->jobs = parseInteger(name, text, 1, kMaxJobs); });
  add("--time-limit", "SECONDS", "For each case (default 3600; 0: none)",
      [o](auto& name, auto& text) { o->defaults.limits.seconds = parseTimeLimit(name, text); });
  add("--memory-limit", "MB", "Address space of each case (default 0: none)",
      [o](auto& name, auto& text) { o->defaults.limits.bytes = parseMemoryLimit(name, text); });
  add("-f,--format", "ENDING", "Of the mesh of a row without output (default stl)", [o](auto&, auto& text) {
    o->defaults.format = text.substr(text.find_first_not_of('.') == 1 ? 1 : 0);
    checkMeshExtension({"--format", "mesh." + o->defaults.format});
  });
  command->add_flag("--quiet", o->quiet, "Say nothing of the cases that are done");
  addPartOptions(*command, *o);
  command->callback([&action, o] { action = [o] { return perform(*o); }; });
}

}  // namespace handlebody::cli
