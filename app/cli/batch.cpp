#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <list>
#include <memory>
#include <thread>

#include "app/cli/case_folder.h"
#include "app/cli/command.h"
#include "app/cli/csv.h"
#include "app/cli/outputs.h"
#include "app/cli/summary.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/parse.h"
#include "core/threads.h"

namespace handlebody::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostJobs = 256;
constexpr double kHour = 3600;

struct BatchOptions {
  std::string study, folder;
  int jobs = 1;
  CaseLimits limits{kHour, 0};
  bool quiet = false;
};

//! A case at work.
struct Job {
  std::size_t index;
  std::unique_ptr<CaseProcess> process;
};

class Batch {
 public:
  explicit Batch(const BatchOptions& options)
      : options_(options), cases_(readStudy(options.study, options.limits)), folder_(options.folder) {
    summary_.study = std::filesystem::path(options.study).filename().string();
    summary_.version = HANDLEBODY_VERSION;
    for (const StudyCase& c : cases_) summary_.rows.push_back(rowOf(c));
  }

  int run() {
    const DeferSignals stopCleanly;
    for (const SummaryRow& row : summary_.rows)
      if (row.status == CaseStatus::refused) say(row);
    findDone();
    if (DeferSignals::isPending()) return kIncomplete;  // not all that is done has been found
    while (startJobs(), !jobs_.empty() && !DeferSignals::isPending()) {
      collect();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      if (Clock::now() - written_ > std::chrono::seconds(10)) writeSummary();
    }
    stopJobs();
    writeSummary();
    if (!options_.quiet) printCounts();
    return summary_.count(CaseStatus::done) == static_cast<int>(cases_.size()) ? kDone : kIncomplete;
  }

 private:
  static SummaryRow rowOf(const StudyCase& c) {
    SummaryRow row;
    row.line = c.line;
    row.name = c.name;
    row.volume = c.volume;
    row.message = c.fault.empty() ? "It has not been run yet." : c.fault;
    row.status = c.fault.empty() ? CaseStatus::notRun : CaseStatus::refused;
    return row;
  }

  //! Hashes the volumes of what was done before, on as many threads as there will be jobs.
  void findDone() {
    std::vector<char> done(cases_.size(), 0);  // not bool: written by several threads
    forEachOnThreads(cases_.size(), options_.jobs, [&](std::size_t i) {
      if (DeferSignals::isPending()) return;
      done[i] = cases_[i].fault.empty() && folder_.isDone(cases_[i]) ? 1 : 0;
    });
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (done[i] != 0) kept_ += showResult(i) ? 1 : 0;
  }

  //! False if there is none that can be read.
  bool showResult(std::size_t i) try {
    SummaryRow& row = summary_.rows[i];
    const std::string folder = BatchFolder::folderOf(cases_[i]);
    row.measures = readMeasures(folder_.absolute(folder));
    row.thumbnail = readFile(folder_.absolute(folder) + "/thumbnail.png");
    row.folder = folder;
    row.files = cases_[i].outputs;
    row.files.insert(row.files.end(), {"report.json", "session.json", "log.txt"});
    row.message.clear();
    row.log.clear();
    row.status = CaseStatus::done;
    return true;
  } catch (const InputError&) {
    return false;
  }

  void startJobs() {
    while (next_ < cases_.size() && static_cast<int>(jobs_.size()) < options_.jobs &&
           !DeferSignals::isPending()) {
      const std::size_t i = next_++;
      if (summary_.rows[i].status == CaseStatus::notRun) startJob(i);
    }
  }

  void startJob(std::size_t i) try {
    jobs_.push_back({i, start(cases_[i])});
  } catch (const std::exception& error) {
    fail(i, error.what());
    say(summary_.rows[i]);
  }

  std::unique_ptr<CaseProcess> start(const StudyCase& c) const {
    const std::string folder = folder_.begin(c);
    std::vector<std::string> arguments{"segment", c.volumePath, "--quiet"};
    arguments.insert(arguments.end(), c.options.begin(), c.options.end());
    if (!c.wallsPath.empty()) arguments.push_back("--walls=" + c.wallsPath);
    for (const std::string& file : c.outputs) arguments.push_back("--output=" + folder + "/" + file);
    for (const char* file : {"report.json", "session.json"})
      arguments.push_back("--" + std::string(file, 0, std::string(file).find('.')) + "=" + folder + "/" +
                          file);
    arguments.push_back("--picture=" + folder + "/picture.png");
    return std::make_unique<CaseProcess>(arguments, folder + "/log.txt", c.limits);
  }

  void collect() {
    for (auto job = jobs_.begin(); job != jobs_.end();) {
      if (!job->process->hasEnded()) {
        ++job;
        continue;
      }
      settle(job->index, job->process->end());
      job = jobs_.erase(job);
    }
  }

  void settle(std::size_t i, const CaseEnd& end) {
    if (end.exitCode == kDone || end.exitCode == kMaxIterations || end.exitCode == kLeak)
      finish(i, end);
    else
      fail(i, failureSentence(end, cases_[i].limits, folder_.logOfWork(cases_[i])));
    say(summary_.rows[i]);
  }

  //! A full disk, say, is the failure of the case: others may have room.
  void finish(std::size_t i, const CaseEnd& end) try {
    folder_.finish(cases_[i], end);
    if (!showResult(i)) fail(i, "its report cannot be read.");
  } catch (const std::exception& error) {
    fail(i, error.what());
  }

  void fail(std::size_t i, const std::string& why) {
    SummaryRow& row = summary_.rows[i];
    folder_.fail(cases_[i]);
    row.status = CaseStatus::failed;
    row.message = why;
    if (folder_.hasResults(cases_[i]))
      row.message += " (Its folder holds the result of an earlier run, of other inputs or options.)";
    row.log = BatchFolder::logOf(cases_[i]);
  }

  void stopJobs() {
    for (Job& job : jobs_) {
      job.process.reset();
      folder_.abandon(cases_[job.index]);
    }
    jobs_.clear();
  }

  void say(const SummaryRow& row) const {
    const bool isGood = row.status == CaseStatus::done;
    if (isGood && options_.quiet) return;
    std::fprintf(stderr, "%s: %s%s%s\n", row.name.c_str(), statusName(row.status), isGood ? "" : ": ",
                 isGood ? "" : row.message.c_str());
  }

  void writeSummary() {
    writeTextAtomically(folder_.absolute("summary.csv"), summaryCsv(summary_));
    writeTextAtomically(folder_.absolute("summary.json"), summaryJson(summary_));
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
  std::vector<StudyCase> cases_;
  BatchFolder folder_;
  Summary summary_;
  std::list<Job> jobs_;
  std::size_t next_ = 0;
  int kept_ = 0;
  Clock::time_point written_ = Clock::now();
};

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
      [o](auto& name, auto& text) { o->jobs = parseInteger(name, text, 1, kMostJobs); });
  add("--time-limit", "SECONDS", "For each case (default 3600; 0: none)",
      [o](auto& name, auto& text) { o->limits.seconds = parseTimeLimit(name, text); });
  add("--memory-limit", "MB", "Address space of each case (default 0: none)",
      [o](auto& name, auto& text) { o->limits.bytes = parseMemoryLimit(name, text); });
  command->add_flag("--quiet", o->quiet, "Say nothing of the cases that are done");
  command->callback([&action, o] { action = [o] { return Batch(*o).run(); }; });
}

}  // namespace handlebody::cli
