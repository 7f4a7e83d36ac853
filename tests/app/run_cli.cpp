#include "tests/app/run_cli.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/support/catch.h"

extern char** environ;

namespace handlebody::test {

namespace {

// Output goes to files: no pipe can fill up and block the program.
pid_t spawn(const std::vector<std::string>& arguments, const std::string& out, const std::string& err) {
  std::vector<std::string> words{HANDLEBODY_CLI};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, out.c_str(), kWrite, 0600);
  posix_spawn_file_actions_addopen(&files, 2, err.c_str(), kWrite, 0600);
  pid_t child = 0;
  const int failed = posix_spawn(&child, HANDLEBODY_CLI, &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  REQUIRE(failed == 0);
  return child;
}

int exitCodeOf(pid_t child) {
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

RunningCli::RunningCli(const std::vector<std::string>& arguments)
    : child_(spawn(arguments, folder_ / "out", folder_ / "err")) {}

RunningCli::~RunningCli() {
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

std::vector<int> RunningCli::children() const {
  const std::string process = std::to_string(child_);
  std::ifstream list("/proc/" + process + "/task/" + process + "/children");
  return {std::istream_iterator<int>(list), {}};
}

int RunningCli::waitForChild() const {
  for (int i = 0; i < 20000; ++i) {
    for (const int child : children()) {
      std::ifstream file("/proc/" + std::to_string(child) + "/cmdline");
      const std::string words(std::istreambuf_iterator<char>(file), {});
      if (words.find("--report=") != std::string::npos) return child;  // it has been turned into the case
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  FAIL("no case has begun");
  return -1;
}

Outcome RunningCli::wait() {
  Outcome outcome;
  outcome.exitCode = exitCodeOf(child_);
  child_ = -1;
  outcome.out = readBytes(folder_ / "out");
  outcome.err = readBytes(folder_ / "err");
  return outcome;
}

Outcome runCli(const std::vector<std::string>& arguments, int interruptAfter) {
  RunningCli run(arguments);
  if (interruptAfter > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(interruptAfter));
    kill(run.process(), SIGINT);
  }
  return run.wait();
}

Outcome runCliAtTerminal(const std::vector<std::string>& arguments) {
  const TempFolder folder;
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  REQUIRE(terminal >= 0);
  REQUIRE(grantpt(terminal) == 0);
  REQUIRE(unlockpt(terminal) == 0);
  const pid_t child = spawn(arguments, folder / "out", ptsname(terminal));
  Outcome outcome;
  std::array<char, 4096> read{};
  // Until nobody has it open any more, which is an error here. It holds little, so that it must be emptied.
  for (ssize_t n = 0; (n = ::read(terminal, read.data(), read.size())) > 0;)
    outcome.err.append(read.data(), static_cast<std::size_t>(n));
  ::close(terminal);
  outcome.exitCode = exitCodeOf(child);
  outcome.out = readBytes(folder / "out");
  return outcome;
}

nlohmann::json runForJson(const std::vector<std::string>& arguments) {
  const Outcome outcome = runCli(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  return nlohmann::json::parse(outcome.out);
}

PhantomFile makePhantomFile(const TempFolder& folder, const std::string& name,
                            const std::vector<std::string>& more, const std::string& phantom) {
  PhantomFile file;
  file.path = folder / name;
  std::vector<std::string> arguments{"phantom",   phantom,
                                     "-o",        file.path,
                                     "--size",    phantom == "sphere" ? "32,32,32" : "50,50,50",
                                     "--spacing", phantom == "sphere" ? "2.5,2.5,2.5" : "2,2,2"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  file.json = runForJson(arguments);
  for (const auto& x : file.json.at("seed").at("centre")) file.seed += x.dump() + ",";
  file.seed += file.json.at("seed").at("radius").dump();
  return file;
}

}  // namespace handlebody::test
