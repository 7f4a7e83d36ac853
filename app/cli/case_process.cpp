#include "app/cli/case_process.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/errors.h"
#include "core/io/address_space.h"

namespace handlebody::cli {

namespace {

constexpr int kNotStarted = 127;
constexpr const char* kTooLong = "its options are longer than the system takes.\n";
constexpr const char* kNoProgram = "the program cannot be started.\n";

//! Only the soft limit: the child's own decoder must be able to set its.
void limitMemory(std::uint64_t bytes) {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  if (limit.rlim_max == RLIM_INFINITY || bytes < limit.rlim_max) limit.rlim_cur = bytes;
  ::setrlimit(RLIMIT_AS, &limit);
}

//! Should the machine run out of memory, the kernel takes a case and not the batch.
void offerToKernel() {
  const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const ssize_t written = ::write(file, "1000", 4);
  ::close(file);
}

//! What the child does between fork and exec: system calls alone. posix_spawn could not tie its life to ours.
[[noreturn]] void becomeCase(char* const* argv, int log, int failures, std::uint64_t bytes, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kNotStarted);  // it was killed before that
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (::dup2(nothing, 0) < 0 || ::dup2(nothing, 1) < 0 || ::dup2(log, 2) < 0) ::_exit(kNotStarted);
  ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  if (::dup2(failures, kFailurePipe) < 0) ::_exit(kNotStarted);
  ::fcntl(kFailurePipe, F_SETFD, 0);  // where it was that already, dup2 has done nothing
  const rlimit noCore{0, 0};
  ::setrlimit(RLIMIT_CORE, &noCore);
  if (bytes > 0) limitMemory(bytes);
  offerToKernel();
  ::execv("/proc/self/exe", argv);
  const char* why = errno == E2BIG ? kTooLong : kNoProgram;
  [[maybe_unused]] const ssize_t told = ::write(2, why, std::strlen(why));
  ::_exit(kNotStarted);
}

std::string lastLine(const std::string& log) {
  std::ifstream file(log);
  std::string line, last;
  while (std::getline(file, line))
    if (!line.empty()) last = line;
  return last;
}

//! Open as long as this lives.
struct Descriptor {
  explicit Descriptor(int n) : number(n) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number;
};

[[noreturn]] void refuseToStart() {
  throw std::runtime_error(std::string("a process cannot be started: ") + std::strerror(errno));
}

std::string megabytes(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MB"; }

//! What ended it; empty if it ended by itself.
std::string stopSentence(const CaseEnd& end, const CaseLimits& limits) {
  if (end.isTimedOut) {
    std::ostringstream text;
    text << "it was stopped at its time limit of " << std::setprecision(4) << limits.seconds << " s.";
    return text.str();
  }
  if (end.signal == SIGKILL) return "it was killed from outside, or by the system for want of memory.";
  if (end.signal != 0) return std::string("it broke down (signal: ") + strsignal(end.signal) + ").";
  return {};
}

}  // namespace

CaseProcess::CaseProcess(const std::vector<std::string>& arguments, const std::string& log,
                         const CaseLimits& limits)
    : limits_(limits) {
  std::vector<std::string> words{"handlebody-cli", kAsCase};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const Descriptor file(::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.number < 0) throw OutputError(log + ": cannot be written: " + std::strerror(errno) + ".");
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) refuseToStart();
  Descriptor read(ends[0]);
  const Descriptor write(ends[1]);
  const std::uint64_t bytes = canLimitAddressSpace(addressSpace(::getpid())) ? limits.bytes : 0;
  const pid_t parent = ::getpid();
  child_ = ::fork();
  if (child_ == 0) becomeCase(argv.data(), file.number, write.number, bytes, parent);
  if (child_ < 0) refuseToStart();
  ::setpgid(child_, child_);  // whoever comes first
  failurePipe_ = std::exchange(read.number, -1);
}

CaseProcess::~CaseProcess() {
  ::close(failurePipe_);
  if (child_ < 0) return;
  kill();
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void CaseProcess::kill() const { ::kill(-child_, SIGKILL); }

bool CaseProcess::hasEnded() {
  if (child_ < 0) return true;
  siginfo_t ended{};
  if (::waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
      ended.si_pid == child_) {
    note();
    return true;
  }
  const std::chrono::duration<double> lived = std::chrono::steady_clock::now() - begin_;
  if (limits_.seconds > 0 && lived.count() > limits_.seconds && !end_.isTimedOut) {
    end_.isTimedOut = true;
    kill();
  }
  return false;
}

void CaseProcess::note() {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  kill();  // what it may have left behind; its number is its own until it is waited for
  int status = 0;
  rusage used{};
  while (::wait4(child_, &status, 0, &used) < 0 && errno == EINTR) {
  }
  child_ = -1;
  end_.failure = toldFailure(failurePipe_);
  if (WIFEXITED(status)) end_.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end_.signal = WTERMSIG(status);
  end_.isTimedOut = end_.isTimedOut && end_.signal == SIGKILL;
  end_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  end_.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  end_.peakMegabytes = static_cast<double>(used.ru_maxrss) / 1024;
}

std::string failureSentence(const CaseEnd& end, const CaseLimits& limits, const std::string& log) {
  if (std::string stopped = stopSentence(end, limits); !stopped.empty()) return stopped;
  const std::string error = end.failure.message.empty() ? lastLine(log) : end.failure.message;
  if (error.empty())
    return "it ended with exit code " + std::to_string(end.exitCode) + " and without a word.";
  // The loader ends with that code when the program's libraries have no room.
  const bool isOutOfMemory = end.failure.isOutOfMemory || end.exitCode == kNotStarted;
  return error +
         (isOutOfMemory && limits.bytes > 0 ? " (Its memory limit is " + megabytes(limits.bytes) + ".)" : "");
}

std::string anonymousFailureSentence(const CaseEnd& end, const CaseLimits& limits) {
  if (std::string stopped = stopSentence(end, limits); !stopped.empty()) return stopped;
  return "it ended with exit code " + std::to_string(end.exitCode) +
         "; why is told on standard error alone, as the case is anonymous.";
}

}  // namespace handlebody::cli
