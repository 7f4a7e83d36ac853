#include "tests/app/run_cli.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
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

Outcome runCli(const std::vector<std::string>& arguments, int interruptAfter) {
  const TempFolder folder;
  Outcome outcome;
  const pid_t child = spawn(arguments, folder / "out", folder / "err");
  if (interruptAfter > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(interruptAfter));
    kill(child, SIGINT);
  }
  outcome.exitCode = exitCodeOf(child);
  outcome.out = readBytes(folder / "out");
  outcome.err = readBytes(folder / "err");
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
