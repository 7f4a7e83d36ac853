// Volumes whose file gives no spacing, and what else the command line says about geometry.

#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;

namespace {

//! The phantom's file without its spacing (2.5 mm).
PhantomFile uncalibratedPhantom(const TempFolder& folder) {
  PhantomFile file = makePhantomFile(folder);
  std::string bytes = readBytes(file.path);
  const auto line = bytes.find("ElementSpacing");
  REQUIRE(line != std::string::npos);
  bytes.erase(line, bytes.find('\n', line) + 1 - line);
  writeBytes(file.path, bytes);
  return file;
}

}  // namespace

TEST_CASE("a volume without spacing is said to be uncalibrated: info, standard error and report", "[cli]") {
  const TempFolder folder;
  const PhantomFile phantom = uncalibratedPhantom(folder);
  const auto info = runForJson({"info", phantom.path, "--json"});
  CHECK(info.at("calibrated") == false);
  CHECK(info.at("sources").at("spacing").at(2) == "assumed");
  CHECK(info.at("sources").at("size") == "DimSize");
  CHECK_THAT(runCli({"info", phantom.path}).out, Contains("uncalibrated"));
  const Outcome run = runCli({"segment", phantom.path, "--seed-ijk", "15.5,15.5,15.5,4", "-o",
                              folder / "m.stl", "--report", folder / "r.json"});
  CHECK_THAT(run.err, Contains("uncalibrated"));
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  CHECK(report.at("input").at("calibrated") == false);
}

TEST_CASE("given spacing (--spacing) calibrates, stands in report and session, and replay uses it", "[cli]") {
  const TempFolder folder;
  const PhantomFile phantom = uncalibratedPhantom(folder);
  const Outcome run =
      runCli({"segment", phantom.path, "--spacing", "2.5,2.5,2.5", "--seed-ijk", "15.5,15.5,15.5,4", "-o",
              folder / "m.stl", "--report", folder / "r.json", "--session", folder / "s.json"});
  INFO(run.err);
  REQUIRE(run.exitCode == 0);
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  CHECK(report.at("input").at("calibrated") == true);
  CHECK(report.at("input").at("given_spacing") == nlohmann::json{2.5, 2.5, 2.5});
  CHECK(report.at("input").at("sources").at("spacing").at(0) == "given by the user");
  CHECK(report.at("mesh").at("volume_mm3").get<double>() ==
        Approx(4.0 / 3 * 3.14159265 * 30 * 30 * 30).epsilon(0.03));
  for (const char* session : {"s.json", "r.json"}) {
    REQUIRE(runCli({"replay", folder / session, "-o", folder / "again.stl"}).exitCode == 0);
    CHECK((readBytes(folder / "again.stl") == readBytes(folder / "m.stl")));
  }
}

TEST_CASE("the options --spacing and --uneven are checked, and the decoder is no command for users",
          "[cli]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  CHECK(runCli({"info", phantom.path, "--spacing", "1,0,1"}).exitCode == 2);
  CHECK(runCli({"info", phantom.path, "--spacing", "1,1"}).exitCode == 2);
  CHECK(runCli({"info", phantom.path, "--uneven", "perhaps"}).exitCode == 2);
  CHECK(runCli({"info", phantom.path, "--uneven", "refuse"}).exitCode == 0);
  CHECK_THAT(runCli({"--help"}).out, !Contains("decode-dicom"));
  CHECK(runCli({"decode-dicom"}).exitCode == 1);
}
