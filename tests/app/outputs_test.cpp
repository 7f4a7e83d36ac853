#include "app/cli/outputs.h"

#include <csignal>
#include <filesystem>

#include "core/errors.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::cli;
using handlebody::test::TempFolder;

namespace {

volatile std::sig_atomic_t calls = 0;
void count(int) { calls = calls + 1; }

}  // namespace

TEST_CASE("a signal that comes while files are written takes effect after them", "[cli]") {
  const auto before = std::signal(SIGTERM, count);
  calls = 0;
  {
    const DeferSignals whole;
    std::raise(SIGTERM);
    CHECK(calls == 0);
  }
  CHECK(calls == 1);
  std::raise(SIGTERM);
  CHECK(calls == 2);
  std::signal(SIGTERM, before);
}

TEST_CASE("a signal that is ignored stays ignored", "[cli]") {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  {
    const DeferSignals whole;
    std::raise(SIGHUP);
  }
  CHECK(std::signal(SIGHUP, before) == SIG_IGN);
}

TEST_CASE("checking whether files can be written leaves nothing behind", "[cli]") {
  const TempFolder folder;
  checkWritable({{"-o", folder / "a.stl"}, {"--report", folder / "r.json"}}, {folder / "v.mha"});
  CHECK(folder.names().empty());
  CHECK_THROWS_AS(checkWritable({{"-o", folder / "a.stl"}, {"--report", folder / "./a.stl"}}, {}),
                  UsageError);
  CHECK_THROWS_AS(checkWritable({{"-o", folder / "v.mha"}}, {folder / "v.mha"}), UsageError);
  std::filesystem::create_symlink(folder / "missing/b.stl", folder / "b.stl");
  CHECK_THROWS_WITH(checkWritable({{"-o", folder / "b.stl"}}, {}), Contains("missing does not exist"));
  CHECK_THROWS_AS(checkWritable({{"-o", folder.path()}}, {}), UsageError);
}

TEST_CASE("nothing that a volume is read from is written, nor anything beside it in its folder", "[cli]") {
  const TempFolder folder;
  const std::string data = folder / "voxels.raw";
  test::writeBytes(data, "voxels");
  test::writeBytes(folder / "v.mhd", "ObjectType = Image\nNDims = 3\nElementDataFile = voxels.raw\n");
  test::writeBytes(folder / "v.nhdr", "NRRD0004\ntype: uchar\ndimension: 3\ndata file: voxels.raw\n\n");
  test::writeBytes(folder / "pair.hdr", "");
  const auto isRefused = [&](const std::string& path, const std::string& input) {
    try {
      checkWritable({{"--report", path}}, {input});
    } catch (const UsageError& error) {
      return std::string(error.what()).find(path) != std::string::npos;
    }
    return false;
  };
  CHECK(isRefused(data, folder / "v.mhd"));
  CHECK(isRefused(data, folder / "v.nhdr"));
  CHECK(isRefused(folder / "./voxels.raw", folder / "v.nhdr"));
  CHECK(isRefused(folder / "pair.img", folder / "pair.hdr"));
  CHECK_FALSE(isRefused(folder / "other.raw", folder / "v.mhd"));
  CHECK(isRefused(data, folder.path()));
  CHECK(isRefused(folder / "new.nrrd", folder.path()));
  std::filesystem::create_directory(folder / "results");
  CHECK_FALSE(isRefused(folder / "results/new.nrrd", folder.path()));
  CHECK(test::readBytes(data) == "voxels");
}

TEST_CASE("a file that two options of a run over time name is refused", "[cli][time]") {
  const TempFolder folder;
  const auto phantom = test::runForJson(
      {"phantom", "beating", "--frames", "2", "--spacing", "4,4,4", "-o", folder / "beat.nii.gz"});
  const auto& seed = phantom.at("seed").at("centre");
  const std::string place = seed[0].dump() + "," + seed[1].dump() + "," + seed[2].dump();
  for (const std::vector<std::string>& twice :
       {std::vector<std::string>{"-o", folder / "h.vtp", "--report", folder / "h.pvd"},
        std::vector<std::string>{"-o", folder / "h.vtp", "--report", folder / "c.csv", "--curve",
                                 folder / "c.csv"}}) {
    std::vector<std::string> words{"segment", folder / "beat.nii.gz", "--seed", place, "--frames", "all"};
    words.insert(words.end(), twice.begin(), twice.end());
    const auto outcome = test::runCli(words);
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains("named twice"));
  }
  CHECK(folder.names() == std::vector<std::string>{"beat.nii.gz"});
}

TEST_CASE("an interrupt ends the program and leaves no file behind", "[cli]") {
  const TempFolder folder;
  const auto phantom = test::runForJson({"phantom", "cube", "-o", folder / "cube.mha"});
  const auto& seed = phantom.at("seed").at("centre");
  // Everything is in range: filling the volume takes seconds, so that the interrupt comes amid the work.
  const auto outcome = test::runCli({"segment", folder / "cube.mha", "--range", "-inf,1000", "--seed",
                                     seed[0].dump() + "," + seed[1].dump() + "," + seed[2].dump() + ",5",
                                     "-o", folder / "m.stl", "--report", folder / "r.json"},
                                    300);
  CHECK(outcome.exitCode == -SIGINT);
  CHECK(folder.names() == std::vector<std::string>{"cube.mha"});
}
