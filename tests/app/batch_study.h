#pragma once
// A study of one phantom, for the tests of `batch`.

#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

namespace handlebody::test {

inline constexpr int kIncomplete = 7;

//! A folder with a phantom, in which studies are run.
struct Study {
  TempFolder folder;
  PhantomFile phantom = makePhantomFile(folder);
  std::string csv = folder / "study.csv", out = folder / "out";

  //! A row that works.
  std::string row(const std::string& name, const std::string& more = "") const {
    return name + ",sphere.mha,\"" + phantom.seed + "\"" + more + "\n";
  }
  std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"batch", csv, "-o", out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Outcome run(const std::vector<std::string>& more = {}) const { return runCli(arguments(more)); }
  nlohmann::json summary() const { return nlohmann::json::parse(readBytes(out + "/summary.json")); }
  nlohmann::json row(std::size_t i) const { return summary().at("cases").at(i); }
  std::string file(const std::string& name, const std::string& of = "mesh.stl") const {
    return out + "/cases/" + name + "/" + of;
  }
};

inline const std::string kHeader = "case,volume,seed";

//! Of the inode: another one says that the folder was made anew.
inline ino_t identity(const std::string& path) {
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  return status.st_ino;
}

//! Every folder of a case has all of its files, and its record tells their sizes; nothing else lies about.
inline void expectWholeResults(const Study& study, std::size_t most) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(study.out + "/cases")) {
    INFO(entry.path());
    REQUIRE(std::filesystem::exists(entry.path() / "case.json"));
    const auto record = nlohmann::json::parse(readBytes(entry.path() / "case.json"));
    CHECK(record.at("files").size() == 6);
    for (const auto& [name, size] : record.at("files").items())
      CHECK(std::filesystem::file_size(entry.path() / name) == size);
    ++count;
  }
  CHECK(count <= most);
}

//! The process has a handler of its own for it: `batch` has read its table, and ends when it is ready to.
inline bool catches(int process, int signal) {
  const std::string status = readBytes("/proc/" + std::to_string(process) + "/status"), key = "SigCgt:";
  const std::size_t at = status.find(key);
  if (at == std::string::npos) return false;
  return (std::stoull(status.substr(at + key.size()), nullptr, 16) >> (signal - 1) & 1U) != 0;
}

inline bool waitUntil(const std::function<bool()>& condition, int seconds = 30) {
  for (int i = 0; i < 500 * seconds && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  return condition();
}

}  // namespace handlebody::test
