#include "app/cli/slurm.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "app/cli/csv.h"
#include "app/cli/outputs.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/tetrahedra/mesher_process.h"

extern char** environ;

namespace handlebody::cli {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxTasks = 1000;  // of an array: Slurm's MaxArraySize is 1001 unless it was changed
constexpr std::size_t kMaxSaid = 300;

//! As one word of a shell.
std::string shellWord(const std::string& text) {
  std::string word = "'";
  for (char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

//! As part of a file name in which Slurm fills in numbers.
std::string withoutPatterns(const std::string& path) {
  std::string plain;
  for (char c : path) plain += c == '%' ? std::string("%%") : std::string(1, c);
  return plain;
}

//! "1-3,7".
std::string ranges(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (i == 0 ? "" : ",") + std::to_string(numbers[i]);
    if (last > i) text += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

void checkOptions(const std::vector<std::string>& options) {
  static const std::vector<std::string> ours{"--array",     "--wrap", "--parsable", "--wait",
                                             "--test-only", "--help", "--usage",    "--version"};
  for (const std::string& option : options) {
    const bool isShort = option.size() > 1 && option[0] == '-' && std::strchr("aWhV", option[1]) != nullptr;
    const std::string name = option.substr(0, option.find('='));
    if (isShort || option == "--" || std::find(ours.begin(), ours.end(), name) != ours.end())
      throw UsageError("--slurm: '" + option +
                       "' cannot be given here: arrays, waiting and what sbatch prints are up to the batch.");
  }
}

//! DIR/slurm/N, N the first that is free.
std::string newFolder(const std::string& folder) {
  const fs::path all = fs::path(folder) / "slurm";
  std::error_code failed;
  fs::create_directories(all, failed);
  for (int n = 1; !failed; ++n) {
    const fs::path one = all / std::to_string(n);
    if (fs::create_directory(one, failed)) return one.string();
    if (!failed && !fs::is_directory(one)) break;
  }
  throw OutputError(all.string() + ": no folder can be made in it: " +
                    (failed ? failed.message() : "a file is in the way") + ".");
}

std::string said(const std::string& file) {
  std::string text = readFile(file);
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  return shortened(text, kMaxSaid);
}

//! The number that sbatch gives a job. Throws UsageError.
std::string sbatch(const std::string& program, std::vector<std::string> words, const std::string& folder) {
  const std::string out = folder + "/sbatch.out", err = folder + "/sbatch.err";
  words.insert(words.begin(), program);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, out.c_str(), kWrite, 0666);
  posix_spawn_file_actions_addopen(&files, 2, err.c_str(), kWrite, 0666);
  pid_t child = 0;
  const int failed = ::posix_spawn(&child, program.c_str(), &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) throw UsageError("--slurm: " + program + " cannot be started: " + std::strerror(failed));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status))
    throw UsageError(std::string("--slurm: sbatch was ended by a signal (") + ::strsignal(WTERMSIG(status)) +
                     "); `squeue` tells whether it had submitted its job");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw UsageError("--slurm: sbatch refused the job, and said: " + said(err));
  const std::string answer = said(out);
  std::string number = answer.substr(0, answer.find(';'));  // NUMBER;CLUSTER
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
    throw UsageError("--slurm: sbatch gave no number of a job, and said: " + answer);
  return number;
}

class Submission {
 public:
  explicit Submission(const SlurmStudy& study) : study_(study) {
    checkOptions(study.options);
    const auto found = findProgram("sbatch");
    if (!found) throw UsageError("--slurm: there is no program sbatch in the folders of PATH.");
    sbatch_ = *found;
    folder_ = newFolder(study.folder);
    // The jobs run later: the study is as it was when its rows were read.
    copy_ = folder_ + "/" + fs::path(study.study).filename().string();
    writeTextAtomically(copy_, study.text);
  }

  SlurmJobs submit() {
    SlurmJobs jobs;
    try {
      for (std::size_t i = 0; i < study_.rows.size();) {
        i = submitArray(i, jobs);
        if (DeferSignals::isPending()) throw UsageError("--slurm: it was interrupted.");
      }
      jobs.summary = submitSummary(jobs);
    } catch (const UsageError& error) {
      if (jobs.arrays.empty()) throw;
      std::string text = error.what();
      for (const std::string& array : jobs.arrays)
        text += (&array == &jobs.arrays.front() ? " (Submitted before that: " : ", ") + array;
      throw UsageError(text +
                       "; `scancel` ends them, and `batch --only-summary` tells what became of them.)");
    }
    return jobs;
  }

 private:
  //! The rows from the i-th on that one array can hold; gives the first that it does not.
  std::size_t submitArray(std::size_t i, SlurmJobs& jobs) {
    const int before = (study_.rows[i] - 1) / kMaxTasks * kMaxTasks;
    std::vector<int> tasks;
    for (; i < study_.rows.size() && study_.rows[i] <= before + kMaxTasks; ++i)
      tasks.push_back(study_.rows[i] - before);
    const std::string script =
        writeScript("cases-" + std::to_string(jobs.arrays.size() + 1) + ".sh",
                    "--only-row=\"$((SLURM_ARRAY_TASK_ID + " + std::to_string(before) + "))\"");
    std::string array = "--array=" + ranges(tasks);
    if (study_.jobs > 0) array += "%" + std::to_string(study_.jobs);
    jobs.arrays.push_back(give("handlebody-batch", "case-%A_%a.txt", {array}, script));
    return i;
  }

  std::string submitSummary(const SlurmJobs& jobs) {
    std::string after = "--dependency=afterany";
    for (const std::string& array : jobs.arrays) after += ":" + array;
    return give("handlebody-summary", "summary.txt", {after}, writeScript("summary.sh", "--only-summary"));
  }

  //! What the user says stands against the defaults, and what must be so against that.
  std::string give(const std::string& name, const std::string& log, const std::vector<std::string>& needed,
                   const std::string& script) const {
    std::vector<std::string> words{"--job-name=" + name, "--output=" + withoutPatterns(folder_) + "/" + log};
    words.insert(words.end(), study_.options.begin(), study_.options.end());
    words.emplace_back("--parsable");
    words.insert(words.end(), needed.begin(), needed.end());
    words.push_back(script);
    return sbatch(sbatch_, words, folder_);
  }

  std::string writeScript(const std::string& name, const std::string& last) const {
    const std::string program = fs::read_symlink("/proc/self/exe").string();
    std::string text = "#!/bin/sh\nexec " + shellWord(program) + " batch " + shellWord(copy_) +
                       " --relative-to " + shellWord(study_.base) + " -o " + shellWord(study_.folder);
    for (const std::string& setting : study_.settings) text += " " + shellWord(setting);
    writeTextAtomically(folder_ + "/" + name, text + " " + last + "\n");
    return folder_ + "/" + name;
  }

  const SlurmStudy& study_;
  std::string sbatch_, folder_, copy_;
};

}  // namespace

std::vector<std::string> withSlurmOptions(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0] != "batch") return arguments;
  const auto slurm = std::find(arguments.begin(), arguments.end(), "--slurm");
  std::vector<std::string> all(arguments.begin(), slurm);
  if (slurm == arguments.end()) return all;
  all.push_back(*slurm);
  for (auto word = slurm + 1; word != arguments.end(); ++word) all.push_back("--slurm-option=" + *word);
  return all;
}

SlurmJobs submitToSlurm(const SlurmStudy& study) { return Submission(study).submit(); }

}  // namespace handlebody::cli
