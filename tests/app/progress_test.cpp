// What is said on a terminal while work goes on.

#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const std::string kErase = "\r\033[K";

//! A ball as a volume, a label map and a mesh.
struct Ball {
  TempFolder folder;
  std::string labels = folder / "truth.mha", mesh = folder / "ball.stl";
  PhantomFile volume = makePhantomFile(folder, "sphere.mha", {"--truth", labels});
  Ball() { REQUIRE(runCli({"mesh", labels, "-o", mesh}).exitCode == 0); }
};

}  // namespace

TEST_CASE("at a terminal they say what they are at, and take it away; elsewhere nothing", "[cli][progress]") {
  const Ball ball;
  const std::vector<std::vector<std::string>> commands{
      {"mesh", ball.labels, "-o", ball.folder / "m.stl"},
      {"compare", ball.mesh, ball.labels, "-o", ball.folder / "d.vtp"},
      {"measure", ball.mesh, "--volume", ball.volume.path, "--csv", ball.folder / "m.csv"},
      {"check", ball.mesh},
      {"edit", ball.mesh, "--keep-largest", "-o", ball.folder / "e.stl"}};
  for (const auto& command : commands) {
    INFO(command[0]);
    const Outcome elsewhere = runCli(command), seen = runCliAtTerminal(command);
    CHECK(elsewhere.exitCode == 0);
    CHECK(elsewhere.err.empty());
    CHECK(seen.exitCode == 0);
    CHECK(seen.out == elsewhere.out);
    CHECK_THAT(seen.err, StartsWith(kErase + "reading") && EndsWith(kErase));
  }
}

TEST_CASE("with --quiet nothing is said of the work at a terminal either", "[cli][progress]") {
  const Ball ball;
  const Outcome mesh = runCliAtTerminal({"mesh", ball.labels, "-o", ball.folder / "m.stl", "--quiet"});
  CHECK(mesh.exitCode == 0);
  CHECK(mesh.out.empty());
  CHECK(mesh.err.empty());
  for (const std::vector<std::string>& command :
       {std::vector{std::string("compare"), ball.mesh, ball.labels}, {"measure", ball.mesh}}) {
    INFO(command[0]);
    std::vector<std::string> quiet = command;
    quiet.emplace_back("--quiet");
    const Outcome outcome = runCliAtTerminal(quiet);
    CHECK(outcome.err.empty());
    CHECK(outcome.out == runCli(command).out);
  }
}

TEST_CASE("a session that is grown again to be measured tells its iterations", "[cli][progress]") {
  const Ball ball;
  REQUIRE(runCli({"segment", ball.volume.path, "--seed", ball.volume.seed, "-o", ball.folder / "s.stl",
                  "--session", ball.folder / "s.json", "--quiet"})
              .exitCode == 0);
  const Outcome outcome = runCliAtTerminal({"measure", ball.folder / "s.json"});
  CHECK(outcome.exitCode == 0);
  CHECK_THAT(outcome.err, Contains("iteration ") && EndsWith(kErase));
}
