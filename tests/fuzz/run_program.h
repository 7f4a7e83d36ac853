#pragma once
// A program run to its end, silently, with a limit of processor time, so that other work on the machine does
// not decide.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

extern char** environ;

namespace handlebody::test {

struct ProgramEnd {
  int code = -1;    //!< exit code; minus the signal's number if one ended it, -9 if it took too long
  long memory = 0;  //!< peak, kB
};

//! Of all its threads; 0 where it has ended.
inline double processorSeconds(pid_t child) {
  clockid_t clock{};
  timespec t{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &t) != 0) return 0;
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

//! `seconds`: of the processor; it may wait three times as long. `errors`: a file for its standard error.
inline ProgramEnd runProgram(std::vector<std::string> words, double seconds,
                             const std::string& errors = "/dev/null") {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (int standard : {0, 1})
    posix_spawn_file_actions_addopen(&files, standard, "/dev/null", standard ? O_WRONLY : O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 2, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int failed = posix_spawn(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) return {};
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(4 * seconds);
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    if (std::chrono::steady_clock::now() > end || processorSeconds(child) > seconds) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), usage.ru_maxrss};
}

}  // namespace handlebody::test
