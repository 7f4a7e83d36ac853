// Walls and what else a command line forbids the surface.

#include <algorithm>
#include <filesystem>

#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;

namespace {

//! "x,y,z" of the phantom's seed, moved along x by so many mm.
std::string besideSeed(const PhantomFile& phantom, double mm) {
  const auto centre = phantom.json.at("seed").at("centre").get<std::vector<double>>();
  return std::to_string(centre[0] + mm) + "," + std::to_string(centre[1]) + "," + std::to_string(centre[2]);
}

void requireRefusal(const TempFolder& folder, const PhantomFile& phantom,
                    const std::vector<std::string>& options, int exitCode, const std::string& named) {
  std::vector<std::string> arguments{"segment",    phantom.path, "--seed",
                                     phantom.seed, "-o",         folder / "refused.stl"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = runCli(arguments);
  INFO(outcome.err);
  CHECK(outcome.exitCode == exitCode);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK_THAT(outcome.err, Contains(named));
  CHECK_FALSE(std::filesystem::exists(folder / "refused.stl"));
}

}  // namespace

TEST_CASE("walls keep the surface out, stand in session and report, and replay knows them again",
          "[cli][constraints]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string wall = besideSeed(phantom, -20) + ",4";
  REQUIRE(runCli({"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "free.stl"}).exitCode == 0);
  REQUIRE(runCli({"segment", phantom.path, "--seed", phantom.seed, "--wall", wall, "-o", folder / "a.stl",
                  "-o", folder / "a.mha", "--session", folder / "s.json", "--report", folder / "r.json"})
              .exitCode == 0);
  CHECK(readBytes(folder / "a.stl") != readBytes(folder / "free.stl"));
  for (const char* from : {"s.json", "r.json"}) {
    INFO(from);
    const auto json = nlohmann::json::parse(readBytes(folder / from));
    CHECK(json.at("requested").at("constraints").at("walls").at(0).at("radius") == 4);
    REQUIRE(runCli({"replay", folder / from, "-o", folder / "b.stl"}).exitCode == 0);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
  }
}

TEST_CASE("a label map is a wall, and its session refuses another one", "[cli][constraints]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string other = besideSeed(phantom, -18) + ",2";
  // A ball in the phantom as label map: what grows from a small seed in a few iterations.
  REQUIRE(runCli({"segment", phantom.path, "--seed", other, "--max-iterations", "2", "-o", folder / "w.mha"})
              .exitCode == 5);
  REQUIRE(runCli({"segment", phantom.path, "--seed", phantom.seed, "--walls", folder / "w.mha", "-o",
                  folder / "a.stl", "--session", folder / "s.json"})
              .exitCode == 0);
  REQUIRE(runCli({"replay", folder / "s.json", "-o", folder / "b.stl"}).exitCode == 0);
  CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
  REQUIRE(runCli({"segment", phantom.path, "--seed", other, "--max-iterations", "3", "-o", folder / "w.mha"})
              .exitCode == 5);
  const Outcome changed = runCli({"replay", folder / "s.json", "-o", folder / "c.stl"});
  CHECK(changed.exitCode == 3);
  CHECK_THAT(changed.err, Contains("w.mha") && Contains("SHA-256"));
}

TEST_CASE("walls without sense are refused with one sentence", "[cli][constraints]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  requireRefusal(folder, phantom, {"--wall", besideSeed(phantom, 1) + ",3"}, 4, "lies over the seed");
  requireRefusal(folder, phantom, {"--wall", besideSeed(phantom, 1e4) + ",3"}, 2, "outside of the volume");
  requireRefusal(folder, phantom, {"--wall", "1,2,3"}, 2, "--wall");
  requireRefusal(folder, phantom, {"--wall", "1,2,3,0"}, 2, "--wall");
  requireRefusal(folder, phantom, {"--wall", "1,2,nan,4"}, 2, "--wall");
  requireRefusal(folder, phantom, {"--walls", folder / "none.mha"}, 3, "none.mha");
  REQUIRE(runCli({"phantom", "sphere", "-o", folder / "fine.mha", "--spacing", "2,2,2"}).exitCode == 0);
  requireRefusal(folder, phantom, {"--walls", folder / "fine.mha"}, 3, "voxels");
  const PhantomFile turned = makePhantomFile(folder, "turned.mha", {"--rotate", "0,0,5"});
  requireRefusal(folder, phantom, {"--walls", turned.path}, 3, "direction");
}
