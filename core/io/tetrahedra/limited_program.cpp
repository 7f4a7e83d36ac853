#include "core/io/tetrahedra/limited_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "core/cancellation.h"

extern char** environ;

namespace handlebody {

namespace {

constexpr int kNotStarted = 127;
constexpr auto kShortestNap = std::chrono::milliseconds(1), kLongestNap = std::chrono::milliseconds(50);

std::vector<std::string> plainEnvironment() {
  std::vector<std::string> all{"LC_ALL=C"};
  for (char** e = environ; *e; ++e)
    if (std::strncmp(*e, "LC_", 3) != 0) all.emplace_back(*e);
  return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& t : texts) pointers.push_back(t.data());
  pointers.push_back(nullptr);
  return pointers;
}

//! What the child does between fork and exec: system calls alone. posix_spawn could not tie its life to ours.
[[noreturn]] void become(char* const* argv, char* const* envp, int log, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kNotStarted);  // it was killed before that
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (::dup2(nothing, 0) < 0 || ::dup2(log, 1) < 0 || ::dup2(log, 2) < 0) ::_exit(kNotStarted);
  ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  const rlimit noCore{0, 0};
  ::setrlimit(RLIMIT_CORE, &noCore);
  ::execve(argv[0], argv, envp);
  ::_exit(kNotStarted);
}

//! A child and its group; killed, and waited for, when this goes.
class Group {
 public:
  explicit Group(pid_t child) : child_(child) { ::setpgid(child, child); }  // whoever comes first
  ~Group() {
    if (child_ >= 0) end();
  }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  //! Its number is its own until end() has been called, so that no other group can be meant.
  bool hasEnded() const {
    siginfo_t ended{};
    return ::waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == child_;
  }
  //! The status of waitpid.
  int end() {
    ::kill(-child_, SIGKILL);
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return status;
  }

 private:
  pid_t child_;
};

pid_t start(std::vector<std::string>& command, const std::string& log) {
  std::vector<std::string> environment = plainEnvironment();
  const std::vector<char*> argv = pointersTo(command), envp = pointersTo(environment);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0) return -1;
  const pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) become(argv.data(), envp.data(), file, parent);
  ::close(file);
  return child;
}

}  // namespace

ProgramEnd runLimited(std::vector<std::string> command, const std::string& log, double seconds) {
  giveUpIfCancelled();
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = start(command, log);
  if (child < 0) return {};
  Group group(child);
  ProgramEnd end;
  for (auto nap = kShortestNap; !group.hasEnded(); nap = std::min(2 * nap, kLongestNap)) {
    giveUpIfCancelled();
    const std::chrono::duration<double> lived = std::chrono::steady_clock::now() - begin;
    end.isTooLong = lived.count() > seconds;
    if (end.isTooLong) break;
    std::this_thread::sleep_for(nap);
  }
  const int status = group.end();
  if (WIFEXITED(status)) end.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.isStarted = end.exitCode != kNotStarted;
  return end;
}

}  // namespace handlebody
