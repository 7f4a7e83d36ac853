#pragma once
// The memory of a program and its children together, what they share counted once.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

extern char** environ;

namespace handlebody::test {

//! kB of one process, shared pages by share.
inline long proportionalMemory(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/smaps_rollup");
  for (std::string word; file >> word;)
    if (long kB = 0; word == "Pss:" && file >> kB) return kB;
  return 0;
}

inline std::vector<long> childrenOf(long process) {
  const std::string id = std::to_string(process);
  std::ifstream file("/proc/" + id + "/task/" + id + "/children");
  std::vector<long> children;
  for (long child = 0; file >> child;) children.push_back(child);
  return children;
}

struct MemoryRun {
  long peak = 0;  //!< kB
  int code = -1;  //!< exit code
};

//! Runs it to its end, silently; looks every two milliseconds.
inline MemoryRun memoryOf(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (int standard : {1, 2}) posix_spawn_file_actions_addopen(&files, standard, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawn(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) return {};
  MemoryRun run;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    long sum = proportionalMemory(child);
    for (const long process : childrenOf(child)) sum += proportionalMemory(process);
    run.peak = std::max(run.peak, sum);
    usleep(2000);
  }
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}

}  // namespace handlebody::test
