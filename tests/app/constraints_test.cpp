// Walls and what else a command line forbids the surface.

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>

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

  // Anonymous, neither session nor report names the files.
  REQUIRE(
      runCli({"segment", phantom.path, "--seed", phantom.seed, "--walls", folder / "w.mha", "-o",
              folder / "a.stl", "--session", folder / "n.json", "--report", folder / "r.json", "--anonymous"})
          .exitCode == 0);
  for (const char* file : {"n.json", "r.json"}) {
    CHECK(readBytes(folder / file).find("w.mha") == std::string::npos);
    const Outcome unnamed =
        runCli({"replay", folder / file, "--volume", phantom.path, "-o", folder / "d.stl"});
    CHECK(unnamed.exitCode == 3);
    CHECK_THAT(unnamed.err, Contains("--walls"));
    REQUIRE(runCli({"replay", folder / file, "--volume", phantom.path, "--walls", folder / "w.mha", "-o",
                    folder / "b.stl"})
                .exitCode == 0);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
  }

  REQUIRE(runCli({"segment", phantom.path, "--seed", other, "--max-iterations", "3", "-o", folder / "w.mha"})
              .exitCode == 5);
  const Outcome changed = runCli({"replay", folder / "s.json", "-o", folder / "c.stl"});
  CHECK(changed.exitCode == 3);
  CHECK_THAT(changed.err, Contains("w.mha") && Contains("SHA-256"));
}

TEST_CASE("vetoes and limits of the topology stand in session and report, and replay knows them again",
          "[cli][constraints]") {
  const TempFolder folder;
  const PhantomFile torus = makePhantomFile(folder, "torus.mha", {}, "torus");
  const auto segment = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"segment",  torus.path,       "--seed",    torus.seed,
                                       "-o",       folder / "a.stl", "--session", folder / "s.json",
                                       "--report", folder / "r.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    REQUIRE(runCli(arguments).exitCode == 0);
    REQUIRE(runCli({"replay", folder / "s.json", "-o", folder / "b.stl"}).exitCode == 0);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
    return nlohmann::json::parse(readBytes(folder / "r.json"));
  };
  const auto genus = [](const nlohmann::json& report) {
    const auto each = report.at("mesh").at("genus").get<std::vector<int>>();
    return std::accumulate(each.begin(), each.end(), 0);
  };
  const auto free = segment({});
  CHECK(genus(free) == 1);
  CHECK_FALSE(free.contains("held"));
  const auto& events = free.at("events");
  const auto handle = std::find_if(events.begin(), events.end(),
                                   [](const auto& e) { return e.at("kind") == "handle inserted"; });
  REQUIRE(handle != events.end());
  const std::string iteration = handle->at("iteration").dump();
  const std::string location = handle->at("location").dump();
  const std::string place = location.substr(1, location.size() - 2);

  const auto vetoed = segment({"--veto", iteration + ":" + place});
  CHECK(genus(vetoed) == 0);
  CHECK(vetoed.at("held").at(0).at("why") == "veto");
  CHECK(vetoed.at("held").at(0).at("location") == handle->at("location"));
  const auto limited = segment({"--genus", "0", "--components", "3"});
  CHECK(genus(limited) == 0);
  CHECK(limited.at("mesh").at("components") == 3);
  CHECK(limited.at("held").size() == 3);  // the handle, and two of the four cavities
  const auto allowed = segment({"--genus", "0", "--allow", place});
  CHECK(genus(allowed) == 1);
  CHECK(allowed.at("requested").at("constraints").at("allowed").size() == 1);
  CHECK_FALSE(allowed.contains("held"));
}

TEST_CASE("on-held stop ends with exit code 6 and a question that an option answers", "[cli][constraints]") {
  const TempFolder folder;
  const PhantomFile torus = makePhantomFile(folder, "torus.mha", {}, "torus");
  const auto segment = [&](const std::vector<std::string>& options, int exitCode) {
    std::vector<std::string> arguments{
        "segment", torus.path,       "--seed",    torus.seed,        "--genus",  "0",
        "-o",      folder / "a.stl", "--session", folder / "s.json", "--report", folder / "r.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runCli(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exitCode == exitCode);
    REQUIRE(runCli({"replay", folder / "s.json", "-o", folder / "b.stl"}).exitCode == 0);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
    return std::pair(nlohmann::json::parse(readBytes(folder / "r.json")), outcome.err);
  };
  for (const char* choice : {"stop", "pause"}) {  // there is no terminal
    const auto [report, told] = segment({"--on-held", choice, "--sensitivity", "2"}, 6);
    CHECK(report.at("stopped") == "held");
    CHECK_FALSE(report.contains("sensitivity"));
    CHECK_THAT(told, Contains("warning: The sensitivity is not told"));
    const auto& question = report.at("questions").at(0);
    CHECK(question.at("iteration") == report.at("iterations"));
    CHECK(question.at("answer") == "none");
    CHECK(question.at("tunnel_mm").get<double>() > 60);
    CHECK(report.at("held").at(0).at("location") == question.at("location"));
    CHECK_THAT(told, Contains("fronts would meet at ") && Contains("--allow=") && Contains("--hold="));
  }
  const auto options =
      nlohmann::json::parse(readBytes(folder / "r.json")).at("questions").at(0).at("options");
  const auto held = segment({"--on-held", "stop", options.at("hold")}, 0).first;
  CHECK(held.at("mesh").at("genus").get<std::set<int>>() == std::set<int>{0});
  CHECK_FALSE(held.contains("questions"));
  const std::string heldMesh = readBytes(folder / "a.stl");
  CHECK(segment({}, 0).first.at("stopped") == "converged");
  CHECK(readBytes(folder / "a.stl") == heldMesh);  // as if nobody had asked
  const auto allowed = segment({"--on-held", "stop", options.at("allow")}, 0).first;
  // The order of the components is not fixed, and four of them are cavities.
  CHECK(allowed.at("mesh").at("genus").get<std::multiset<int>>() == std::multiset<int>{0, 0, 0, 0, 1});
}

TEST_CASE("vetoes and limits without sense are refused with one sentence", "[cli][constraints]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string there = besideSeed(phantom, 1);
  requireRefusal(folder, phantom, {"--veto", "2:" + there}, 2, "no change of topology happens there");
  requireRefusal(folder, phantom, {"--veto", "4000:" + there}, 2, "the growth ended at iteration");
  requireRefusal(folder, phantom, {"--veto", "0:" + there}, 2, "--veto");
  requireRefusal(folder, phantom, {"--veto", there}, 2, "--veto");
  requireRefusal(folder, phantom, {"--genus", "-1"}, 2, "--genus");
  requireRefusal(folder, phantom, {"--components", "0"}, 2, "--components");
  requireRefusal(folder, phantom, {"--allow", there}, 2, "no limit");
  requireRefusal(folder, phantom, {"--hold", there}, 2, "no limit");
  requireRefusal(folder, phantom, {"--on-held", "stop"}, 2, "--on-held");
  requireRefusal(folder, phantom, {"--genus", "0", "--on-held", "maybe"}, 2, "--on-held");
  requireRefusal(folder, phantom, {"--genus", "0", "--allow", "1e5,0,0"}, 2, "outside of the volume");
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

TEST_CASE("pins hold, stand in session and report, and replay knows them again", "[cli][constraints][pin]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string pin = besideSeed(phantom, 4) + ",3@3";
  const std::string seed = besideSeed(phantom, 0) + ",3";
  const Outcome outcome =
      runCli({"segment", phantom.path, "--seed", seed, "--pin", pin, "-o", folder / "a.stl", "--session",
              folder / "s.json", "--report", folder / "r.json"});
  INFO(outcome.err);
  REQUIRE((outcome.exitCode == 0 || outcome.exitCode == 1));
  CHECK_THAT(outcome.out, Contains("pinned by"));
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  REQUIRE(report.at("pinned").size() == 1);
  CHECK(report.at("pinned")[0].at("vertices") > 0);
  CHECK(report.at("pinned")[0].at("iteration") == 3);
  CHECK(report.at("pinned")[0].at("radius") == 3);
  for (const char* from : {"s.json", "r.json"}) {
    const auto json = nlohmann::json::parse(readBytes(folder / from));
    const auto& written = json.at("requested").at("constraints").at("pins").at(0);
    CHECK(written.at("radius") == 3);
    CHECK(written.at("iteration") == 3);
    REQUIRE(runCli({"replay", folder / from, "-o", folder / "b.stl"}).exitCode == outcome.exitCode);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
  }
}

TEST_CASE("pins without sense are refused with one sentence", "[cli][constraints][pin]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string here = besideSeed(phantom, 0);
  requireRefusal(folder, phantom, {"--pin", here + ",4"}, 2, "--pin");
  requireRefusal(folder, phantom, {"--pin", here + ",0@3"}, 2, "--pin");
  requireRefusal(folder, phantom, {"--pin", here + ",4@x"}, 2, "--pin");
  requireRefusal(folder, phantom, {"--pin", here + ",4@-1"}, 2, "--pin");
  requireRefusal(folder, phantom, {"--pin", here + ",0.01@3"}, 2, "holds nothing: no vertex");
  requireRefusal(folder, phantom, {"--pin", here + ",4@100000"}, 2, "holds nothing: the growth ended");
  requireRefusal(folder, phantom, {"--pin", "9999,0,0,4@3"}, 2, "outside of the volume");
}

TEST_CASE("local edits are steps of the growth, in session and report, and replay makes them again",
          "[cli][constraints][touch]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string here = besideSeed(phantom, 0), beside = besideSeed(phantom, 30);
  REQUIRE(runCli({"segment", phantom.path, "--seed", phantom.seed, "--edit",
                  "200:cut:" + here + ",0,0,1,positive", "--edit", "201:smooth:" + beside + ",12", "--edit",
                  "202:pull:" + beside + "," + here + ",9", "--max-iterations", "150", "-o", folder / "a.stl",
                  "--session", folder / "s.json", "--report", folder / "r.json"})
              .exitCode != 0);  // the growth ends before: nothing is made
  const Outcome outcome =
      runCli({"segment", phantom.path, "--seed", phantom.seed, "--edit", "6:cut:" + here + ",0,0,1,positive",
              "--max-iterations", "6", "-o", folder / "a.stl", "--session", folder / "s.json", "--report",
              folder / "r.json"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 5);
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  CHECK(report.at("events").back().at("kind") == "cut by a plane");
  for (const char* from : {"s.json", "r.json"}) {
    const auto json = nlohmann::json::parse(readBytes(folder / from));
    const auto& written = json.at("requested").at("constraints").at("edits").at(0);
    CHECK(written.at("kind") == "cut");
    CHECK(written.at("keep") == "positive");
    REQUIRE(runCli({"replay", folder / from, "-o", folder / "b.stl"}).exitCode == 5);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
  }
}

TEST_CASE("a pin whose iteration never comes is told where the run is ended before it",
          "[cli][constraints][pin]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string pin = besideSeed(phantom, 4) + ",3@3", seed = besideSeed(phantom, 0) + ",3";
  REQUIRE(runCli({"segment", phantom.path, "--seed", seed, "--pin", pin, "-o", folder / "a.stl", "--session",
                  folder / "s.json"})
              .exitCode == 0);
  auto session = nlohmann::json::parse(readBytes(folder / "s.json"));
  session["requested"]["stop_at"] = 2;
  writeBytes(folder / "t.json", session.dump());
  const Outcome ended =
      runCli({"replay", folder / "t.json", "-o", folder / "b.stl", "--report", folder / "r.json"});
  CHECK(ended.exitCode == 0);
  CHECK_THAT(ended.err, Contains("warning: the pin ") && Contains("@3 holds nothing"));
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  CHECK_THAT(report.at("warnings").dump(), Contains("holds nothing: the mesh is that of iteration 2"));
  CHECK(report.at("pinned").at(0).at("vertices") == 0);
}
