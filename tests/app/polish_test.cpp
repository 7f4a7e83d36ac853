// --polish, through the program.

#include <algorithm>

#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

double leastAngle(const std::string& mesh) {
  return runForJson({"check", mesh, "--json"}).at("quality").at("angles_degrees").at("least");
}

const std::vector<std::string> kCut{"--cut-plane", "0.3,0.2,1.7,1,2,9,positive"};

std::vector<std::string> joined(std::vector<std::string> all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

//! A ball, in mm, on disk.
std::string ballFile(const TempFolder& folder) {
  writeMesh(icosphere(Vec3(0, 0, 0), 10, 1.2), folder / "ball.ply");
  return folder / "ball.ply";
}

}  // namespace

TEST_CASE("thin triangles of an edit are bettered, and report and check agree", "[cli][polish]") {
  const TempFolder folder;
  const std::string ball = ballFile(folder);
  runCli(joined({"edit", ball, "-o", folder / "off.ply", "--polish", "off"}, kCut));
  REQUIRE(leastAngle(folder / "off.ply") < 15);
  const auto told = runForJson(joined({"edit", ball, "-o", folder / "on.stl", "--json"}, kCut)).at("polish");
  CHECK(told.at("before").at("least_angle_degrees").get<double>() ==
        Approx(leastAngle(folder / "off.ply")).epsilon(1e-6));
  CHECK(told.at("after").at("least_angle_degrees").get<double>() ==
        Approx(leastAngle(folder / "on.stl")).epsilon(1e-6));
  CHECK(told.at("after").at("thin_faces") < told.at("before").at("thin_faces"));
  CHECK(told.at("farthest_mm") <= told.at("limit_mm"));
  CHECK(told.at("changed_faces") > 0);
}

TEST_CASE("edit leaves what it did not make, unless all is to be polished", "[cli][polish]") {
  const TempFolder folder;
  const std::string ball = ballFile(folder), bad = folder / "bad.ply";
  runCli(joined({"edit", ball, "-o", bad, "--polish", "off"}, kCut));
  const auto some =
      runForJson({"edit", bad, "-o", folder / "some.ply", "--smooth-here", "0,0,9,2", "--json"});
  CHECK(some.at("polish").at("changed_faces") == 0);
  const auto all = runForJson({"edit", bad, "-o", folder / "all.ply", "--polish", "all", "--json"});
  CHECK(all.at("polish").at("changed_faces") > 0);
  CHECK(leastAngle(folder / "all.ply") > leastAngle(bad));
}

TEST_CASE("a session is replayed as it was polished, and one of before is not", "[cli][polish]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  const std::string centre = phantom.seed.substr(0, phantom.seed.rfind(','));
  const auto segment = [&](const std::string& name, const std::vector<std::string>& more) {
    const Outcome done =
        runCli(joined({"segment", phantom.path, "--seed", phantom.seed, "--edge-length", "2.5", "--edit",
                       "12:cut:" + centre + ",1,2,9,positive", "--max-iterations", "12", "-o",
                       folder / (name + ".stl"), "--report", folder / (name + ".json"), "--quiet"},
                      more));
    INFO(done.err);
    REQUIRE((done.exitCode == 0 || done.exitCode == 5));
  };
  segment("on", {});
  segment("off", {"--polish", "off"});
  const auto report = nlohmann::json::parse(readBytes(folder / "on.json"));
  REQUIRE(report.at("polish").at("changed_faces") > 0);
  CHECK(report.at("polish").at("after").at("least_angle_degrees").get<double>() ==
        Approx(leastAngle(folder / "on.stl")).epsilon(1e-6));
  CHECK_FALSE(nlohmann::json::parse(readBytes(folder / "off.json")).contains("polish"));
  CHECK(readBytes(folder / "on.stl") != readBytes(folder / "off.stl"));
  for (const char* name : {"on", "off"}) {
    runCli({"replay", folder / (std::string(name) + ".json"), "-o", folder / "again.stl", "--quiet"});
    CHECK(readBytes(folder / "again.stl") == readBytes(folder / (std::string(name) + ".stl")));
  }
  runCli({"replay", folder / "on.json", "--polish", "off", "-o", folder / "again.stl", "--quiet"});
  CHECK(readBytes(folder / "again.stl") == readBytes(folder / "off.stl"));
}

TEST_CASE("thin triangles of a mesh that is given stay as they are, and are told", "[cli][polish]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  runCli(joined({"edit", ballFile(folder), "-o", folder / "bad.ply", "--polish", "off"}, kCut));
  runCli({"edit", folder / "bad.ply", "-o", folder / "good.ply", "--polish", "all"});
  const auto given = [&](const std::string& mesh) {
    const Outcome done = runCli({"segment", phantom.path, "--given", folder / mesh, "-o", folder / "m.ply",
                                 "--report", folder / "r.json", "--quiet"});
    INFO(done.err);
    REQUIRE(done.exitCode == 0);
    CHECK(leastAngle(folder / "m.ply") == Approx(leastAngle(folder / mesh)).epsilon(1e-6));
    const auto findings = nlohmann::json::parse(readBytes(folder / "r.json")).at("findings");
    return std::count_if(findings.begin(), findings.end(),
                         [](const auto& f) { return f.at("kind") == "given-with-thin"; });
  };
  CHECK(given("bad.ply") == 1);
  CHECK(given("good.ply") == 0);
}

TEST_CASE("options of the export that make no sense are refused", "[cli][polish]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  requireRefusal(
      folder, {"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "m.stl", "--polish", "maybe"},
      2, "--polish");
  requireRefusal(folder, {"mesh", phantom.path, "-o", folder / "m.stl", "--mesher-seconds", "0"}, 2,
                 "--mesher-seconds");
  requireRefusal(folder, {"edit", ballFile(folder), "-o", folder / "m.stl", "--polish", "on"}, 2, "--polish");
}

TEST_CASE("what grows in phantoms is written without thin triangles and sharp edges", "[cli][polish]") {
  for (const std::string name : {"torus", "genus3", "cube", "rings", "trefoil", "tree", "gyroid"}) {
    INFO(name);
    const TempFolder folder;
    const PhantomFile phantom = makePhantomFile(folder, "v.nii.gz", {"--noise", "0.15"}, name);
    const Outcome run = runCli({"segment", phantom.path, "--seed", phantom.seed, "-o", folder / "m.stl"});
    REQUIRE(run.exitCode == 0);
    const auto json = runForJson({"check", folder / "m.stl", "--json"});
    CHECK(json.at("genus") == phantom.json.at("genus"));
    CHECK(json.at("quality").at("angles_degrees").at("least") >= 15);
    CHECK(json.at("quality").at("dihedral_angles_degrees").at("least") >= 20);
  }
}
