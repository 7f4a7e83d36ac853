// Discs as walls and the leak alarm on the command line.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;

namespace {

using Arguments = std::vector<std::string>;

//! Two chambers, 2 mm apart, with a hole of 4 mm between them. In voxels of 2 mm there would be no wall.
PhantomFile chambers(const TempFolder& folder) {
  PhantomFile file{folder / "wall.mha", {}, {}};
  file.json = runForJson({"phantom", "wall", "--gap", "4", "--noise", "0", "-o", file.path});
  for (const auto& x : file.json.at("seed").at("centre")) file.seed += x.dump() + ",";
  file.seed += file.json.at("seed").at("radius").dump();
  return file;
}

Outcome segment(const PhantomFile& phantom, const Arguments& more) {
  Arguments all{"segment", phantom.path, "--seed", phantom.seed, "--range", "0,120"};
  all.insert(all.end(), more.begin(), more.end());
  return runCli(all);
}

nlohmann::json parsed(const std::string& path) { return nlohmann::json::parse(readBytes(path)); }

double volumeIn(const nlohmann::json& report) { return report.at("mesh").at("volume_mm3").get<double>(); }

//! A chamber of 30 mm with a pipe of 20 mm to a second one and a hole, further from the seed, to a third: the
//! front is in the pipe before it is in the hole, but comes out of it later.
void writePipeAndHole(const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
       << "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\n"
       << "ElementSpacing = 1 1 1\nDimSize = 90 72 40\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  const auto within = [](double a, double low, double high) { return a >= low && a <= high; };
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 72; ++y)
      for (int x = 0; x < 90; ++x) {
        const bool chambers =
            within(z, 5, 34) && ((within(y, 5, 34) && (within(x, 5, 34) || within(x, 55, 84))) ||
                                 (within(y, 37, 66) && within(x, 5, 34)));
        const bool pipe = within(x, 35, 54) && std::hypot(y - 19.5, z - 19.5) < (x < 38 ? 2.2 : 3.3);
        const bool hole = within(y, 35, 36) && std::hypot(x - 29.0, z - 19.5) < 2.6;
        file.put(chambers || pipe || hole ? 50 : static_cast<char>(200));
      }
}

constexpr double kBothChambers = 1.5 * 40 * 60 * 60;  // mm³; more than one of them holds

}  // namespace

TEST_CASE("a leak is told in a warning and the report, and the exit code is 0 as ever", "[cli][leaks]") {
  const TempFolder folder;
  const PhantomFile phantom = chambers(folder);
  const Outcome plain = segment(phantom, {"-o", folder / "a.stl", "--report", folder / "r.json"});
  CHECK(plain.exitCode == 0);
  CHECK_THAT(plain.err, Contains("warning: the surface leaked at iteration "));
  CHECK_THAT(plain.err, Contains("--wall-disc "));
  const auto report = parsed(folder / "r.json");
  CHECK(volumeIn(report) > kBothChambers);
  REQUIRE(report.at("leaks").size() == 1);
  const auto& leak = report.at("leaks").at(0);
  CHECK(leak.at("answer") == "go-on");
  CHECK(leak.at("width_mm").get<double>() < 6);
  CHECK(leak.at("width_behind_mm").get<double>() > 20);
  CHECK(leak.at("disc").at("radius").get<double>() > 2);

  // The option as it is told closes the passage.
  const std::string option = leak.at("option");
  const std::string value = option.substr(option.find(' ') + 1);
  const Outcome walled =
      segment(phantom, {"--wall-disc", value, "-o", folder / "b.stl", "--report", folder / "b.json"});
  CHECK(walled.exitCode == 0);
  CHECK(volumeIn(parsed(folder / "b.json")) < kBothChambers);
  CHECK_FALSE(parsed(folder / "b.json").contains("leaks"));
}

TEST_CASE("on-leak stop ends with exit code 6 and the mesh of before, which replay makes again",
          "[cli][leaks]") {
  const TempFolder folder;
  const PhantomFile phantom = chambers(folder);
  for (const char* choice : {"stop", "pause"}) {  // there is no terminal
    const Outcome stopped =
        segment(phantom, {"--on-leak", choice, "-o", folder / "a.stl", "--report", folder / "r.json",
                          "--session", folder / "s.json", "--sensitivity", "2"});
    CHECK(stopped.exitCode == 6);
    CHECK_THAT(stopped.err, Contains("warning: The sensitivity is not told"));
    const auto report = parsed(folder / "r.json");
    CHECK_FALSE(report.contains("sensitivity"));
    CHECK(report.at("stopped") == "leak");
    CHECK(report.at("leaks").at(0).at("answer") == "stop");
    CHECK(report.at("iterations").get<int>() < report.at("leaks").at(0).at("iteration").get<int>());
    CHECK(volumeIn(report) < kBothChambers);
    for (const char* from : {"s.json", "r.json"}) {
      REQUIRE(runCli({"replay", folder / from, "-o", folder / "b.stl"}).exitCode == 0);
      CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
    }
    // The same as a run that ends there by itself.
    const std::string iterations = std::to_string(report.at("iterations").get<int>());
    CHECK(segment(phantom, {"--max-iterations", iterations, "-o", folder / "c.stl"}).exitCode == 5);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "c.stl"));
  }
}

TEST_CASE("edits, vetoes and pins that would come after the leak are told where the run stops before it",
          "[cli][leaks]") {
  const TempFolder folder;
  const PhantomFile phantom = chambers(folder);
  const std::string place = phantom.seed.substr(0, phantom.seed.rfind(','));
  const Outcome stopped =
      segment(phantom, {"--on-leak", "stop", "--edit", "4000:smooth:" + phantom.seed, "--edit",
                        "5000:smooth:" + phantom.seed, "--veto", "4001:" + place, "--pin",
                        phantom.seed + "@4002", "-o", folder / "a.stl", "--report", folder / "r.json"});
  REQUIRE(stopped.exitCode == 6);
  const auto report = parsed(folder / "r.json");
  const auto& findings = report.at("findings");
  const auto told = [&](const std::string& kind) {
    return std::count_if(findings.begin(), findings.end(),
                         [&](const auto& f) { return f.at("kind") == kind; });
  };
  CHECK(told("edit-not-reached") == 2);
  CHECK(told("veto-not-reached") == 1);
  CHECK(told("pin-not-reached") == 1);
  const std::string now = report.at("iterations").dump();
  for (const std::string begin :
       {"the edit of iteration 4000 is not made", "the edit of iteration 5000 is not made",
        "the veto of iteration 4001 forbids nothing"})
    CHECK_THAT(stopped.err, Contains("warning: " + begin + ": the mesh is that of iteration " + now));
}

TEST_CASE("on-leak wall puts a disc across and goes on, and replay makes the same mesh", "[cli][leaks]") {
  const TempFolder folder;
  const PhantomFile phantom = chambers(folder);
  const Outcome walled = segment(phantom, {"--on-leak", "wall", "-o", folder / "a.stl", "--report",
                                           folder / "r.json", "--session", folder / "s.json"});
  CHECK(walled.exitCode == 0);
  CHECK_THAT(walled.err, Contains("a wall was put there"));
  const auto report = parsed(folder / "r.json");
  CHECK(report.at("stopped") == "converged");
  CHECK(report.at("leaks").at(0).at("answer") == "wall");
  CHECK(volumeIn(report) < kBothChambers);
  const auto& change = report.at("requested").at("changes").at(0);
  CHECK(change.at("constraints").at("wall_discs").at(0) == report.at("leaks").at(0).at("disc"));
  for (const char* from : {"s.json", "r.json"}) {
    REQUIRE(runCli({"replay", folder / from, "-o", folder / "b.stl"}).exitCode == 0);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
  }
}

TEST_CASE("a wall that leads back to before an earlier one keeps that", "[cli][leaks]") {
  const TempFolder folder;
  writePipeAndHole(folder / "rooms.mha");
  const Outcome walled =
      runCli({"segment", folder / "rooms.mha", "--seed", "19.5,19.5,19.5,4", "--range", "0,120", "--on-leak",
              "wall", "-o", folder / "a.stl", "--report", folder / "r.json", "--session", folder / "s.json"});
  CHECK(walled.exitCode == 0);
  const auto report = parsed(folder / "r.json");
  CHECK(report.at("stopped") == "converged");
  CHECK(volumeIn(report) < 1.1 * 30 * 30 * 30);
  REQUIRE(report.at("leaks").size() == 2);  // and not the first one again
  const auto& changes = report.at("requested").at("changes");
  CHECK(changes.back().at("constraints").at("wall_discs").size() == 2);
  REQUIRE(runCli({"replay", folder / "s.json", "-o", folder / "b.stl"}).exitCode == 0);
  CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
}

TEST_CASE("bad discs and choices are refused with one sentence", "[cli][leaks]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const auto refused = [&](const Arguments& options, int exitCode, const std::string& named) {
    Arguments all{"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "refused.stl"};
    all.insert(all.end(), options.begin(), options.end());
    requireRefusal(folder, all, exitCode, named);
  };
  refused({"--wall-disc", "1,2,3,4"}, 2, "--wall-disc");
  refused({"--wall-disc", "1,2,3,0,0,0,4"}, 2, "a normal of some length");
  refused({"--wall-disc", "1,2,3,0,0,1,0"}, 2, "radius above 0");
  refused({"--wall-disc", "1,2,3,0,0,1,-2"}, 2, "radius above 0");
  refused({"--wall-disc", "1,2,3,0,nan,1,2"}, 2, "--wall-disc");
  refused({"--wall-disc", "5000,2,3,0,0,1,4"}, 2, "outside of the volume");
  const auto c = phantom.json.at("seed").at("centre").get<std::vector<double>>();
  refused({"--wall-disc",
           std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + ",0,0,1,3"},
          4, "seed");
  refused({"--on-leak", "shout"}, 2, "--on-leak");
}
