#include "tests/bench/peers/child.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <exception>
#include <stdexcept>

#include "app/cli/heap.h"

namespace handlebody::bench {

namespace {

[[noreturn]] void beChild(int pipe, const void* result, std::size_t size, const std::function<void()>& work) {
  // The heap that the command line has, for the peers as well.
  cli::keepFreedMemory();
  cli::reserveHeap();
  try {
    work();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_peers: %s\n", e.what());
    _exit(1);
  }
  _exit(write(pipe, result, size) == static_cast<ssize_t>(size) ? 0 : 1);
}

double processorSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double peakResident() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

Measure::Measure() : startSeconds_(processorSeconds()), startMegabytes_(peakResident()) {}
double Measure::seconds() const { return processorSeconds() - startSeconds_; }
double Measure::wallSeconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}
double Measure::peakMegabytes() const { return peakResident() - startMegabytes_; }

void runInChild(void* result, std::size_t size, const std::function<void()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) beChild(ends[1], result, size, work);
  close(ends[1]);
  const bool received = read(ends[0], result, size) == static_cast<ssize_t>(size);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!received || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("a measured run failed");
}

}  // namespace handlebody::bench
