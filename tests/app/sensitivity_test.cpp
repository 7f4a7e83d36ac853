// How much a result depends on clicks, smoothing and noise, on the command line.

#include <filesystem>

#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;
using Catch::Matchers::Contains;

TEST_CASE("segment --sensitivity tells volume and spread, and leaves the result as it is",
          "[cli][sensitivity]") {
  const TempFolder folder;
  const PhantomFile ball = makePhantomFile(folder);
  const auto segment = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> all{"segment",  ball.path,
                                 "--seed",   ball.seed,
                                 "-o",       folder / (name + ".stl"),
                                 "--report", folder / (name + ".json")};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = runCli(all);
    INFO(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    return outcome;
  };
  segment("plain", {"--quiet"});
  const Outcome told = segment(
      "told", {"--sensitivity", "3", "--sensitivity-surface", folder / "spread.vtp", "--threads", "2"});
  CHECK(readBytes(folder / "plain.stl") == readBytes(folder / "told.stl"));
  CHECK_THAT(told.out,
             Contains("sensitivity: ") && Contains("in 3 of 3 perturbed runs, 3 with the same topology"));
  CHECK_THAT(told.err, Contains("sensitivity: run 3 of 3"));
  CHECK_THAT(readBytes(folder / "spread.vtp"), Contains("spread_mm"));

  const auto plain = nlohmann::json::parse(readBytes(folder / "plain.json"));
  const auto report = nlohmann::json::parse(readBytes(folder / "told.json"));
  CHECK_FALSE(plain.contains("sensitivity"));
  const auto& s = report.at("sensitivity");
  CHECK(s.at("runs").size() == 3);
  CHECK(s.at("grown") == 3);
  CHECK(s.at("same_topology") == 3);
  const double volume = report.at("mesh").at("volume_mm3");
  CHECK(s.at("volume_mm3").at("mean").get<double>() == Approx(volume).epsilon(0.03));
  CHECK(s.at("volume_mm3").at("standard_deviation").get<double>() > 0);
  CHECK(s.at("spread_mm").at("largest").get<double>() > s.at("spread_mm").at("mean").get<double>());
  CHECK(report.at("seconds").at("sensitivity").get<double>() > 0);
}

TEST_CASE("volumes of a large object are told without an exponent", "[cli][sensitivity]") {
  const TempFolder folder;
  const PhantomFile ball = makePhantomFile(folder);
  const Outcome told = runCli({"segment", ball.path, "--spacing", "30,30,30", "--seed-ijk", "16,16,16,3",
                               "-o", folder / "a.stl", "--sensitivity", "2"});
  INFO(told.out << told.err);
  REQUIRE(told.exitCode == 0);
  const auto line = told.out.find("sensitivity: ");
  REQUIRE(line != std::string::npos);
  CHECK_THAT(told.out.substr(line), !Contains("e+"));
}

TEST_CASE("of a growth that was stopped before it came to rest no sensitivity is told",
          "[cli][sensitivity]") {
  const TempFolder folder;
  const PhantomFile ball = makePhantomFile(folder);
  REQUIRE(runCli({"segment", ball.path, "--seed", ball.seed, "-o", folder / "a.stl", "--session",
                  folder / "s.json", "--quiet"})
              .exitCode == 0);
  auto session = nlohmann::json::parse(readBytes(folder / "s.json"));
  session["requested"]["stop_at"] = 3;
  writeBytes(folder / "s.json", session.dump());
  const Outcome told =
      runCli({"replay", folder / "s.json", "-o", folder / "a.stl", "--report", folder / "r.json",
              "--sensitivity", "2", "--sensitivity-surface", folder / "spread.vtp"});
  INFO(told.err);
  CHECK(told.exitCode == 0);
  CHECK_THAT(told.err, Contains("warning: The sensitivity is not told") && !Contains("sensitivity: run"));
  CHECK_THAT(told.out, !Contains("sensitivity"));
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  CHECK(report.at("stopped") == "stop-at");
  CHECK_FALSE(report.contains("sensitivity"));
  CHECK_THAT(report.at("warnings").dump(), Contains("The sensitivity is not told"));
  CHECK_FALSE(std::filesystem::exists(folder / "spread.vtp"));
}

TEST_CASE("the sensitivity of a surface without a click is told, also in a replay, and none of a given one",
          "[cli][sensitivity]") {
  const TempFolder folder;
  const PhantomFile ball = makePhantomFile(folder);
  const auto segment = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"segment", ball.path, "-o", folder / "out.stl", "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const auto requireTold = [&](const std::vector<std::string>& arguments) {
    const Outcome told = runCli(arguments);
    INFO(told.err);
    REQUIRE(told.exitCode == 0);
    const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
    CHECK(report.at("sensitivity").at("grown") == 2);
  };
  REQUIRE(
      runCli({"segment", ball.path, "--seed", ball.seed, "-o", folder / "start.stl", "--quiet"}).exitCode ==
      0);
  requireTold(segment({"--start", folder / "start.stl", "--sensitivity", "2", "--report", folder / "r.json",
                       "--session", folder / "s.json"}));
  requireTold({"replay", folder / "s.json", "-o", folder / "out.stl", "--quiet", "--sensitivity", "2",
               "--report", folder / "r.json"});
  std::filesystem::remove(folder / "out.stl");
  requireRefusal(folder, segment({"--given", folder / "start.stl", "--sensitivity", "2"}), 2,
                 "--sensitivity");
}

TEST_CASE("a sensitivity that cannot be told is refused before any work", "[cli][sensitivity]") {
  const TempFolder folder;
  const PhantomFile ball = makePhantomFile(folder);
  const auto refused = [&](std::vector<std::string> more, const std::string& named) {
    std::vector<std::string> all{"segment", ball.path, "--seed", ball.seed, "-o", folder / "out.stl"};
    all.insert(all.end(), more.begin(), more.end());
    requireRefusal(folder, all, 2, named);
  };
  refused({"--sensitivity", "1"}, "--sensitivity");
  refused({"--sensitivity", "1001"}, "--sensitivity");
  refused({"--sensitivity", "many"}, "--sensitivity");
  refused({"--sensitivity-surface", folder / "s.vtp"}, "--sensitivity-surface");
  refused({"--sensitivity", "2", "--sensitivity-surface", folder / "s.stl"}, "--sensitivity-surface");
  refused({"--sensitivity", "2", "--sensitivity-surface", folder / "none/s.vtp"}, "--sensitivity-surface");
  refused({"--sensitivity", "2", "--pin", "0,0,0,5@3"}, "--sensitivity");
  refused({"--sensitivity", "2", "--sensitivity-surface", folder / "out.stl"}, "--sensitivity-surface");
}
