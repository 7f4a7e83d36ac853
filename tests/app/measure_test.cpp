// measure, through the program.

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "app/cli/csv.h"
#include "core/indices.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody::test;
using handlebody::Vec3;
using handlebody::cli::parseCsv;

namespace {

constexpr double kPi = std::numbers::pi;

std::string writeBall(const TempFolder& folder, const std::string& name, const Vec3& centre, double radius) {
  handlebody::writeMesh(handlebody::icosphere(centre, radius, radius / 8), folder / name);
  return folder / name;
}

//! A ball of 14 mm with a hole of 8 mm ("shell"), a ball of 5 mm in that ("core"), and one of 4 mm beside
//! them
//! ("beside"): `segment` with these as they are, in that order.
std::vector<std::string> threeObjects(const TempFolder& folder) {
  using handlebody::TriangleSoup;
  const Vec3 centre(20, 20, 20);
  handlebody::writeVolume(
      handlebody::testing::volumeByDistance(handlebody::testing::cubicGrid(48), 100, 0,
                                            [&](const Vec3& p) { return (p - centre).norm() - 14; }),
      folder / "v.nrrd");
  TriangleSoup shell = handlebody::icosphere(centre, 14, 1.2);
  const TriangleSoup hole = handlebody::icosphere(centre, 8, 1.2);
  const int first = static_cast<int>(shell.points.size());
  shell.points.insert(shell.points.end(), hole.points.begin(), hole.points.end());
  for (const handlebody::Triangle& t : hole.triangles)
    shell.triangles.push_back({t[0] + first, t[2] + first, t[1] + first});
  handlebody::writeMesh(shell, folder / "shell.ply");
  std::vector<std::string> arguments{"segment", folder / "v.nrrd"};
  for (const auto& [name, path] : {std::pair<std::string, std::string>("shell", folder / "shell.ply"),
                                   {"core", writeBall(folder, "core.ply", centre, 5)},
                                   {"beside", writeBall(folder, "beside.ply", Vec3(40, 20, 20), 4)}})
    arguments.insert(arguments.end(), {"--object-name", name, "--given", path});
  return arguments;
}

void segmentThree(const TempFolder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = threeObjects(folder);
  arguments.insert(arguments.end(), {"-o", folder / "o.seg.nrrd", "--quiet"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = runCli(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
}

//! The lines below the names, by name of column.
std::vector<std::map<std::string, std::string>> table(const std::string& path) {
  const auto lines = parseCsv(readBytes(path), path);
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    REQUIRE(lines[i].cells.size() == lines[0].cells.size());
    auto& row = rows.emplace_back();
    for (std::size_t c = 0; c < lines[i].cells.size(); ++c)
      row[lines[0].cells[c].text] = lines[i].cells[c].text;
  }
  return rows;
}

//! 100 everywhere, but for a corner of -1000, and NaN up to 3 mm around the middle voxel; returns how many
//! are NaN. 32³ voxels of 1 mm.
int writeWithoutMiddle(const std::string& path) {
  std::vector<float> voxels(32 * 32 * 32, 100.0F);
  voxels[0] = -1000;
  int none = 0;
  for (int i = 0; i < 32 * 32 * 32; ++i) {
    if ((Vec3(i % 32, i / 32 % 32, i / 1024) - Vec3(16, 16, 16)).norm() > 3) continue;
    voxels[idx(i)] = std::numeric_limits<float>::quiet_NaN();
    ++none;
  }
  writeBytes(path,
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
             "DimSize = 32 32 32\nElementSpacing = 1 1 1\nElementType = MET_FLOAT\n"
             "ElementDataFile = LOCAL\n" +
                 std::string(reinterpret_cast<const char*>(voxels.data()), voxels.size() * sizeof(float)));
  return none;
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

TEST_CASE("voxels that are NaN in their file do not count in the intensities, and a warning says how many",
          "[cli][measure]") {
  const TempFolder folder;
  const int none = writeWithoutMiddle(folder / "v.mha");
  const std::string ball = writeBall(folder, "ball.ply", Vec3(16, 16, 16), 8);
  const auto json = measured(folder, {ball, "--volume", folder / "v.mha"});
  const auto& in = json.at("objects").at(0).at("measures").at("intensity");
  CHECK(in.at("voxels") > 1000);
  for (const char* figure : {"mean", "minimum", "maximum"}) CHECK(in.at(figure) == 100);
  CHECK(in.at("standard_deviation") == 0);
  CHECK_THAT(json.at("warnings").dump(),
             Contains(std::to_string(none) + " voxels inside have no finite value and do not count."));
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

TEST_CASE("the report of several objects has the distances that measure tells", "[cli][measure]") {
  const TempFolder folder;
  segmentThree(folder, {"--report", folder / "r.json", "--session", folder / "s.json"});
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  const auto& distances = report.at("distances");
  CHECK(distances == measured(folder, {folder / "s.json"}).at("distances"));
  const auto between = [&](const std::string& from, const std::string& to) {
    for (const auto& d : distances)
      if (d.at("from") == from && d.at("to") == to) return d.at("distance_mm").get<double>();
    FAIL("nothing between " << from << " and " << to);
    return 0.0;
  };
  REQUIRE(distances.size() == 3);
  CHECK(between("shell", "core") == Approx(8 - 5).epsilon(0.03));
  CHECK(between("shell", "beside") == Approx(20 - 14 - 4).epsilon(0.03));
  CHECK(between("core", "beside") == Approx(20 - 5 - 4).epsilon(0.03));
  // Of meshes the same.
  const auto meshes = measured(folder, {folder / "core.ply", "--to", folder / "beside.ply"});
  CHECK(meshes.at("distances")[0].at("distance_mm").get<double>() == Approx(between("core", "beside")));
  for (const auto& d : distances) CHECK(d.at("contact") == "apart");
}

TEST_CASE("the distances of an anonymous report have the names that its objects have", "[cli][measure]") {
  const TempFolder folder;
  segmentThree(folder, {"--session", folder / "s.json"});
  REQUIRE(runCli({"replay", folder / "s.json", "-o", folder / "o.seg.nrrd", "--report", folder / "r.json",
                  "--anonymous", "--quiet"})
              .exitCode == 0);
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  std::set<std::string> names, told;
  for (const auto& object : report.at("objects")) names.insert(object.at("name").get<std::string>());
  for (const auto& d : report.at("distances"))
    for (const char* end : {"from", "to"}) told.insert(d.at(end).get<std::string>());
  CHECK(told == names);
  CHECK(names.count("core") == 0);  // called after its file
}

TEST_CASE("the wall between two objects of a session is that between their meshes", "[cli][measure]") {
  const TempFolder folder;
  segmentThree(folder, {"--session", folder / "s.json"});
  const auto json =
      measured(folder, {folder / "s.json", "--wall-thickness", "shell", "core", "--csv", folder / "m.csv"});
  const auto& wall = json.at("wall_thickness");
  CHECK(wall.at("surfaces")[0].at("from") == "shell");
  CHECK(wall.at("surfaces")[1].at("from") == "core");
  CHECK(wall.at("surfaces")[1].at("mean_mm").get<double>() == Approx(8 - 5).epsilon(0.03));
  CHECK(wall.at("surfaces")[0].at("largest_mm").get<double>() == Approx(14 - 5).epsilon(0.03));
  const auto meshes =
      measured(folder, {folder / "shell.ply", "--to", folder / "core.ply", "--wall-thickness"});
  for (const std::size_t i : {0, 1})
    for (const char* key : {"mean_mm", "least_mm", "percentile_95_mm", "largest_mm"})
      CHECK(wall.at("surfaces")[i].at(key).get<double>() ==
            Approx(meshes.at("wall_thickness").at("surfaces")[i].at(key).get<double>()));
  const auto rows = table(folder / "m.csv");
  REQUIRE(rows.size() == 3);
  for (const std::size_t i : {0, 1}) {
    CHECK(rows[i].at("wall_first") == "shell");
    CHECK(std::stod(rows[i].at("wall_from_second_mean_mm")) ==
          Approx(wall.at("surfaces")[1].at("mean_mm").get<double>()));
  }
  CHECK(rows[2].at("wall_from_second_mean_mm").empty());  // it is not of "beside"
  // The option before the session, and the surfaces the other way round.
  const auto turned = measured(folder, {"--wall-thickness", "core", "shell", folder / "s.json"});
  CHECK(turned.at("wall_thickness").at("surfaces")[0].at("from") == "core");
  CHECK(turned.at("wall_thickness").at("surfaces")[0].at("mean_mm").get<double>() ==
        Approx(wall.at("surfaces")[1].at("mean_mm").get<double>()));
  // By the names that the session has, also where what is told has others.
  const auto hidden =
      measured(folder, {folder / "s.json", "--wall-thickness", "shell", "core", "--anonymous"});
  CHECK(hidden.at("wall_thickness").at("surfaces")[0].at("from") == hidden.at("objects")[0].at("name"));
  CHECK(hidden.at("wall_thickness").at("surfaces")[0].at("from") != "shell");
}

TEST_CASE("a wall between objects is refused before they grow where it is not clear which",
          "[cli][measure]") {
  const TempFolder folder;
  segmentThree(folder, {"--session", folder / "s.json"});
  const std::string session = folder / "s.json", core = folder / "core.ply";
  const auto refuse = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> arguments{"measure", session};
    arguments.insert(arguments.end(), more.begin(), more.end());
    requireRefusal(folder, arguments, 2, words);
    requireRefusal(folder, arguments, 2, "--wall-thickness");
  };
  refuse({"--wall-thickness"}, "'shell', 'core', 'beside'");
  refuse({"--wall-thickness", "--to", core}, "several objects");
  refuse({"--wall-thickness", "shell", "lung"}, "'lung'");
  refuse({"--wall-thickness", "shell"}, "OUTER and INNER");
  refuse({"--wall-thickness", "shell", "shell"}, "both 'shell'");
  refuse({"--wall-thickness", "shell", "core", "beside"}, "more than two");
  refuse({"--wall-thickness", "shell", "core", "--to", core}, "not both");
  requireRefusal(folder, {"measure", core, "--wall-thickness", "shell", "core"}, 2, "--to");
  requireRefusal(folder, {"measure", "--wall-thickness", "shell", session}, 2, "OUTER and INNER");
}

TEST_CASE("what stands behind --wall-thickness without names of objects is the mesh", "[cli][measure]") {
  const TempFolder folder;
  const std::string large = writeBall(folder, "large.ply", Vec3(0, 0, 0), 10),
                    small = writeBall(folder, "small.ply", Vec3(0, 0, 0), 7);
  const auto behind = measured(folder, {large, "--to", small, "--wall-thickness"});
  CHECK(measured(folder, {"--wall-thickness", large, "--to", small}) == behind);
  CHECK(measured(folder, {"--to", small, "--wall-thickness", large}) == behind);
  requireRefusal(folder, {"measure", "--wall-thickness"}, 2, "MESH is required");
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

TEST_CASE("what replay warns of a session is told where it is measured, too", "[cli][measure]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string path = folder / "s.json";
  const auto grow = [&](const std::vector<std::string>& objects) {
    std::vector<std::string> all{"segment",   phantom.path, "-o",     folder / "a.stl",
                                 "--session", path,         "--quiet"};
    all.insert(all.end(), objects.begin(), objects.end());
    const int code = runCli(all).exitCode;
    REQUIRE((code == 0 || code == 5));  // the second one is stopped early
    return nlohmann::json::parse(readBytes(path));
  };
  nlohmann::json two = grow({"--object-name", "a", "--seed", phantom.seed, "--object-name", "later",
                             "--seed-ijk", "3,3,3,2", "--range", "-inf,inf", "--max-iterations", "1"});
  two["version"] = "0.0.1";
  two["objects"][1]["requested"]["seeds"] = nlohmann::json::array();
  writeBytes(path, two.dump());
  const auto warnings = measured(folder, {path}).at("warnings").dump();
  CHECK_THAT(warnings, Contains("object 'later' has no seed and is left out") &&
                           Contains("was made by version 0.0.1") && Contains(path));
  const Outcome replayed = runCli({"replay", path, "-o", folder / "b.stl"});
  CHECK_THAT(replayed.err, Contains("object 'later' has no seed") && Contains("version 0.0.1"));
  CHECK_THAT(measured(folder, {path, "--anonymous"}).at("warnings").dump(), !Contains(path));
  nlohmann::json overTime = grow({"--seed", phantom.seed});
  overTime["over_time"] = {{"frames", "all"}, {"topology", "free"}, {"drift_check", "none"}};
  writeBytes(path, overTime.dump());
  CHECK_THAT(measured(folder, {path}).at("warnings").dump(), Contains("are of frame 0 alone"));
}

TEST_CASE("rulers and angles of a session are in text and JSON and the table", "[cli][measure]") {
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
  const auto json = measured(folder, {folder / "s.json", "--csv", folder / "m.csv"});
  CHECK(json.at("measurements").at(0).at("length_mm") == 5);
  CHECK(json.at("measurements").at(1).at("angle_degrees") == 90);
  const auto rows = table(folder / "m.csv");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].at("kind") == "object");
  CHECK(rows[0].at("length_mm").empty());
  CHECK(std::stod(rows[0].at("volume_mm3")) ==
        Approx(json.at("objects").at(0).at("measures").at("volume_mm3").get<double>()));
  CHECK(rows[1].at("object") == "ruler 1");
  CHECK(rows[1].at("kind") == "ruler");
  CHECK(std::stod(rows[1].at("length_mm")) == 5);
  CHECK(rows[1].at("angle_degrees").empty());
  CHECK(std::stod(rows[1].at("point_2_y_mm")) == 4);
  CHECK(rows[1].at("point_3_x_mm").empty());
  CHECK(rows[1].at("volume_mm3").empty());
  CHECK(rows[2].at("object") == "angle 2");
  CHECK(rows[2].at("kind") == "angle");
  CHECK(std::stod(rows[2].at("angle_degrees")) == 90);
  CHECK(rows[2].at("length_mm").empty());
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
