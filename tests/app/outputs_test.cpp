#include "app/cli/outputs.h"

#include <csignal>

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
  CHECK_THROWS_AS(checkWritable({{"-o", folder.path()}}, {}), UsageError);
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
