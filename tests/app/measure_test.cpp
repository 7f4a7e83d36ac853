// measure, through the program.

#include <cmath>
#include <numbers>

#include "app/cli/csv.h"
#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;
using handlebody::Vec3;
using handlebody::cli::parseCsv;

namespace {

constexpr double kPi = std::numbers::pi;

std::string writeBall(const TempFolder& folder, const std::string& name, const Vec3& centre, double radius) {
  handlebody::writeMesh(handlebody::icosphere(centre, radius, radius / 8), folder / name);
  return folder / name;
}

nlohmann::json measured(const TempFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "measure");
  arguments.insert(arguments.end(), {"--json", folder / "m.json"});
  const Outcome outcome = runCli(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  return nlohmann::json::parse(readBytes(folder / "m.json"));
}

}  // namespace

TEST_CASE("a mesh is measured with the intensities of a volume", "[cli][measure]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string surface = folder / "s.stl";
  runForJson({"phantom", "sphere", "-o", folder / "again.mha", "--surface", surface});
  const auto json = measured(folder, {surface, "--volume", phantom.path});
  const auto& m = json.at("objects").at(0).at("measures");
  const double d = m.at("largest_diameter_mm");
  CHECK(m.at("volume_mm3").get<double>() == Approx(kPi / 6 * d * d * d).epsilon(0.01));
  for (const double extent : m.at("principal_extents_mm")) CHECK(extent == Approx(d).epsilon(0.01));
  const auto& in = m.at("intensity");
  CHECK(in.at("voxels") > 100);
  CHECK(in.at("minimum") <= in.at("mean"));
  CHECK(in.at("mean") <= in.at("maximum"));
  CHECK(json.at("warnings").empty());
  CHECK(measured(folder, {surface}).at("objects").at(0).at("measures").at("intensity").is_null());
}

TEST_CASE("distances and walls are in text and JSON and a table", "[cli][measure]") {
  const TempFolder folder;
  const std::string large = writeBall(folder, "large.ply", Vec3(0, 0, 0), 10),
                    small = writeBall(folder, "small.ply", Vec3(0, 0, 0), 7);
  const Outcome outcome = runCli({"measure", large, "--to", small, "--wall-thickness", "--csv",
                                  folder / "m.csv", "--json", folder / "m.json"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  for (const char* text : {"volume (ml)", "area (cm2)", "largest diameter (mm)", "wall thickness (mm)",
                           "a part of one lies in the other"})
    CHECK_THAT(outcome.out, Contains(text));
  const auto json = nlohmann::json::parse(readBytes(folder / "m.json"));
  CHECK(json.at("distances").at(0).at("contact") == "inside");
  CHECK(json.at("distances").at(0).at("distance_mm").get<double>() == Approx(3).epsilon(0.02));
  for (const auto& surface : json.at("wall_thickness").at("surfaces"))
    CHECK(surface.at("mean_mm").get<double>() == Approx(3).epsilon(0.01));
  const auto rows = parseCsv(readBytes(folder / "m.csv"), "m.csv");
  REQUIRE(rows.size() == 2);
  REQUIRE(rows[0].cells.size() == rows[1].cells.size());
  CHECK(rows[0].cells[1].text == "volume_mm3");
  CHECK(std::stod(rows[1].cells[1].text) == Approx(4 * kPi / 3 * 1000).epsilon(0.01));
}

TEST_CASE("a centre line is in text and JSON and a table of its sections", "[cli][measure]") {
  const TempFolder folder;
  // A ball drawn out to 60 x 12 x 12 mm.
  handlebody::TriangleSoup body = handlebody::icosphere(Vec3(0, 0, 0), 6, 0.75);
  for (Vec3& p : body.points) p.x() *= 5;
  handlebody::writeMesh(body, folder / "long.ply");
  const Outcome outcome = runCli({"measure", folder / "long.ply", "--between", "-15,0,0", "15,0,0",
                                  "--sections", folder / "s.csv", "--json", folder / "m.json"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  CHECK_THAT(outcome.out, Contains("centre line (mm)"));
  const auto json = nlohmann::json::parse(readBytes(folder / "m.json"));
  const auto& sections = json.at("centre_line").at("sections");
  REQUIRE(sections.size() >= 5);
  CHECK(parseCsv(readBytes(folder / "s.csv"), "s.csv").size() == sections.size() + 1);
  const Outcome same =
      runCli({"measure", folder / "long.ply", "--between", "1,0,0", "1,0,0", "--json", folder / "n.json"});
  CHECK(same.exitCode == 2);
  CHECK_THAT(same.err, Contains("the same place"));
}

TEST_CASE("a session is measured object by object, and the report has the same figures", "[cli][measure]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  REQUIRE(runCli({"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "o.stl", "--report",
                  folder / "r.json", "--session", folder / "s.json", "--quiet"})
              .exitCode == 0);
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  const auto json = measured(folder, {folder / "s.json"});
  CHECK(json.at("objects").at(0).at("measures") == report.at("measures"));
  CHECK(report.at("measures").at("volume_mm3").get<double>() ==
        Approx(report.at("mesh").at("volume_mm3").get<double>()));
  CHECK(report.at("measures").at("intensity").at("voxels") > 100);
  const std::string voxels = readBytes(phantom.path);
  requireRefusal(folder, {"measure", folder / "s.json", "--csv", phantom.path}, 2, "--csv");
  CHECK(readBytes(phantom.path) == voxels);
}

TEST_CASE("with --anonymous neither files nor text tell the paths of what is measured", "[cli][measure]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder, "DOE_JANE.mha");
  std::string volume = readBytes(phantom.path);
  const auto spacing = volume.find("ElementSpacing");
  // Without it there is a warning, which names the file.
  volume.erase(spacing, volume.find('\n', spacing) + 1 - spacing);
  writeBytes(phantom.path, volume);
  const std::string large = writeBall(folder, "DOE_JANE.ply", Vec3(15, 15, 15), 10),
                    small = writeBall(folder, "DOE_JANE_old.ply", Vec3(15, 15, 15), 7);
  const auto told = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"measure",          large,      "--to",           small,
                                       "--wall-thickness", "--volume", phantom.path,     "--csv",
                                       folder / "m.csv",   "--json",   folder / "m.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runCli(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    return outcome.out + readBytes(folder / "m.csv") + readBytes(folder / "m.json");
  };
  CHECK_THAT(told({}), Contains(large) && Contains(small) && Contains(phantom.path + ": "));
  CHECK_THAT(told({"--anonymous"}),
             !Contains("DOE_JANE") && !Contains(folder.path()) && Contains("uncalibrated"));
  const auto json = nlohmann::json::parse(readBytes(folder / "m.json"));
  CHECK(json.at("path").is_null());
  CHECK(json.at("volume").is_null());
  CHECK(json.at("objects").at(0).at("name") == "MESH");
  CHECK(json.at("distances").at(0).at("to") == "MESH2");
  CHECK(json.at("wall_thickness").at("surfaces").at(1).at("from") == "MESH2");
}

// The window calls what it opens so.
TEST_CASE("an object of a session that is called after its file is not called so with --anonymous",
          "[cli][measure]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const auto centre = phantom.json.at("seed").at("centre").get<std::vector<double>>();
  const std::string given = writeBall(folder, "DOE_JANE.ply", Vec3(centre[0], centre[1], centre[2]), 10);
  REQUIRE(runCli({"segment", phantom.path, "--object-name", "DOE_JANE", "--given", given, "-o",
                  folder / "a.gltf", "--session", folder / "s.json", "--quiet"})
              .exitCode == 0);
  CHECK_THAT(readBytes(folder / "a.gltf"), Contains("DOE_JANE"));
  CHECK(measured(folder, {folder / "s.json"}).at("objects").at(0).at("name") == "DOE_JANE");
  CHECK(measured(folder, {folder / "s.json", "--anonymous"}).at("objects").at(0).at("name") == "Object 1");
  CHECK_THAT(readBytes(folder / "m.json"), !Contains("DOE_JANE"));
  REQUIRE(runCli({"replay", folder / "s.json", "-o", folder / "b.gltf", "--session", folder / "n.json",
                  "--report", folder / "r.json", "--anonymous", "--quiet"})
              .exitCode == 0);
  for (const char* name : {"b.gltf", "n.json", "r.json"})
    CHECK_THAT(readBytes(folder / name), Contains("Object 1") && !Contains("DOE_JANE"));
}

TEST_CASE("rulers and angles of a session are in text and JSON", "[cli][measure]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  REQUIRE(runCli({"segment", phantom.path, "--seed", phantom.seed, "--max-iterations", "1", "-o",
                  folder / "o.stl", "--session", folder / "s.json", "--quiet"})
              .exitCode == 5);
  auto session = nlohmann::json::parse(readBytes(folder / "s.json"));
  session["measurements"] = nlohmann::json::parse(
      R"([{"kind": "ruler", "points": [[0, 0, 0], [3, 4, 0]]},
          {"kind": "angle", "points": [[1, 0, 0], [0, 0, 0], [0, 2, 0]]}])");
  writeBytes(folder / "s.json", session.dump());
  const auto json = measured(folder, {folder / "s.json"});
  CHECK(json.at("measurements").at(0).at("length_mm") == 5);
  CHECK(json.at("measurements").at(1).at("angle_degrees") == 90);
  const std::string text = runCli({"measure", folder / "s.json"}).out;
  CHECK(text.find("ruler 1 (mm)                          5 from 0,0,0 to 3,4,0\n") != std::string::npos);
  CHECK(text.find("angle 2 (degrees)                     90 from 1,0,0 to 0,0,0 to 0,2,0\n") !=
        std::string::npos);
}

TEST_CASE("what cannot be measured is refused in one sentence", "[cli][measure]") {
  const TempFolder folder;
  const std::string ball = writeBall(folder, "ball.ply", Vec3(0, 0, 0), 10);
  writeBytes(folder / "open.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  writeBytes(folder / "bad.json", "{\"seeds\": 3}");
  requireRefusal(folder, {"measure", folder / "open.obj"}, 3, "open.obj");
  requireRefusal(folder, {"measure", folder / "none.stl"}, 3, "none.stl");
  requireRefusal(folder, {"measure", folder / "bad.json"}, 3, "bad.json");
  requireRefusal(folder, {"measure", ball, "--volume", folder / "none.nii"}, 3, "none.nii");
  requireRefusal(folder, {"measure", ball, "--to", folder / "open.obj"}, 3, "open.obj");
  requireRefusal(folder, {"measure", ball, "--between", "0,0,0", "30,0,0"}, 2, "--between");
  requireRefusal(folder, {"measure", ball, "--between", "0,0,0", "1,2"}, 2, "--between");
  requireRefusal(folder, {"measure", ball, "--between", "0,0,0"}, 2, "--between");
  requireRefusal(folder, {"measure", ball, "--wall-thickness"}, 2, "--wall-thickness");
  requireRefusal(folder, {"measure", ball, "--sections", folder / "s.csv"}, 2, "--between");
  requireRefusal(folder, {"measure", ball, "--csv", ball}, 2, "--csv");
  requireRefusal(folder, {"measure", ball, "--frame", "1"}, 2, "--volume");
}
