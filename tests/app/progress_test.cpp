// What is said on a terminal while work goes on.

#include "core/evolution/clicked_object.h"
#include "core/io/formats/volume_io.h"
#include "core/io/report/growth_report.h"
#include "core/phase.h"
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

//! A command, and phases that it goes through.
struct Work {
  std::vector<std::string> command, phases;
};

//! Each behind the one before it, at the beginning of the line.
void checkPhases(const Work& work, const std::string& err) {
  CHECK_THAT(err, StartsWith(kErase + "reading") && EndsWith(kErase));
  std::size_t at = 0;
  for (const std::string& phase : work.phases) {
    INFO(phase << " in " << err);
    at = err.find(kErase + phase, at);
    REQUIRE(at != std::string::npos);
  }
}

}  // namespace

TEST_CASE("at a terminal they say what they are at, and take it away; elsewhere nothing", "[cli][progress]") {
  const Ball ball;
  const std::vector<Work> all{
      {{"mesh", ball.labels, "-o", ball.folder / "m.stl"}, {"smoothing", "regulating", "writing"}},
      {{"mesh", ball.labels, "-o", ball.folder / "m.nrrd"}, {"smoothing", "writing", "label map"}},
      {{"compare", ball.mesh, ball.labels}, {"distances"}},
      {{"compare", ball.mesh, ball.labels, "-o", ball.folder / "d.vtp"}, {"distances", "writing"}},
      {{"measure", ball.mesh, "--volume", ball.volume.path, "--csv", ball.folder / "m.csv"}, {"measures"}},
      {{"check", ball.mesh}, {"certifying"}},
      {{"edit", ball.mesh, "--keep-largest", "-o", ball.folder / "e.stl"}, {"polishing", "writing"}},
      {{"info", ball.volume.path}, {}}};
  for (const Work& work : all) {
    INFO(work.command[0]);
    const Outcome elsewhere = runCli(work.command), seen = runCliAtTerminal(work.command);
    CHECK(elsewhere.exitCode == 0);
    CHECK(elsewhere.err.empty());
    CHECK(seen.exitCode == 0);
    CHECK(seen.out == elsewhere.out);
    checkPhases(work, seen.err);
  }
}

TEST_CASE("at a terminal a growth says what it is at before its first iteration, and after the last",
          "[cli][progress]") {
  const Ball ball;
  const std::string& seed = ball.volume.seed;
  const std::string click = seed.substr(0, seed.rfind(',')), session = ball.folder / "s.json";
  const std::vector<std::string> grows{"finding what the clicks mean", "first surface", "iteration ",
                                       "polishing", "writing"};
  std::vector<std::string> begins = grows, writes = grows, several = grows;
  begins.insert(begins.begin(), "smoothing");
  writes.emplace_back("label map");
  several.insert(several.end() - 1, "distance");  // between them
  const std::vector<Work> all{
      {{"segment", ball.volume.path, "--seed", click, "-o", ball.folder / "s.nrrd", "--session", session},
       writes},
      {{"replay", session, "-o", ball.folder / "r.stl"}, grows},
      {{"segment", ball.volume.path, "--seed", seed, "-o", ball.folder / "r.stl"}, grows},
      {{"segment", ball.volume.path, "--start", ball.labels, "-o", ball.folder / "b.stl"}, begins},
      {{"segment", ball.volume.path, "-o", ball.folder / "n.stl", "--report", ball.folder / "n.json",
        "--object-name", "ball", "--seed", click, "--object-name", "rest", "--seed-ijk", "3,3,3"},
       several}};
  for (const Work& work : all) {
    INFO(work.command[0] << ' ' << work.command[2] << ' ' << work.command[3]);
    const Outcome seen = runCliAtTerminal(work.command);
    CHECK(seen.exitCode == 0);
    checkPhases(work, seen.err);
    CHECK_THAT(runCli(work.command).err, !Contains("\r"));
    std::vector<std::string> quiet = work.command;
    quiet.emplace_back("--quiet");
    CHECK_THAT(runCliAtTerminal(quiet).err, !Contains(kErase));
  }
}

TEST_CASE("what else clear clicks may mean is looked for when it is asked for, as a phase",
          "[cli][progress]") {
  const TempFolder folder;
  const PhantomFile file = makePhantomFile(folder);
  const auto& at = file.json.at("seed").at("centre");
  const handlebody::Vec3 centre(at[0].get<double>(), at[1].get<double>(), at[2].get<double>());
  const handlebody::Seed seed{centre, file.json.at("seed").at("radius").get<double>()};
  const handlebody::ActiveContour contour(handlebody::readVolume(file.path, {}), {seed}, {});
  std::vector<std::string> told;
  const handlebody::PhaseScope scope([&](const char* phase) { told.emplace_back(phase); });
  handlebody::RunReport report;
  handlebody::tellCandidates(contour, false, report);
  CHECK(told.empty());
  CHECK(report.candidates.empty());
  handlebody::tellCandidates(contour, true, report);
  CHECK(told == std::vector<std::string>{handlebody::kFindingPhase, ""});
  CHECK_FALSE(report.candidates.empty());
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
