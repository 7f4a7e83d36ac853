// Options that can have no effect, and paths that are none, are refused by name before the work.
#include <cmath>

#include "core/collision/certify.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using namespace handlebody::testing;
using namespace handlebody::test;
using Catch::Matchers::Contains;

namespace {

const Vec3 kAmid(20, 20, 20);

//! A dark ball of 10 mm in 41³ voxels of 1 mm, with a mesh in it and a torus of 9 and 3 mm.
struct Given {
  Given() {
    const Volume voxels = volumeByIndex(cubicGrid(41), [](int i, int j, int k) {
      const double in = std::clamp(10.5 - (Vec3(i, j, k) - kAmid).norm(), 0.0, 1.0);
      return 200 - 180 * in + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
    });
    writeVolume(voxels, volume);
    writeMesh(icosphere(kAmid, 6, 1.5), ball);
    TriangleSoup ring = zoo::torus(40, 20, 9, 3);
    for (Vec3& p : ring.points) p += kAmid;
    writeMesh(ring, torus);
  }
  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"segment", volume, "-o", folder / "m.stl"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  void refuse(const std::vector<std::string>& more, const std::string& named) const {
    requireRefusal(folder, arguments(more), 2, named);
  }
  Outcome run(const std::vector<std::string>& more) const {
    Outcome outcome = runCli(arguments(more));
    INFO(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    return outcome;
  }

  TempFolder folder;
  std::string volume = folder / "v.nrrd", ball = folder / "ball.stl", torus = folder / "torus.stl";
};

}  // namespace

TEST_CASE("a candidate that a range leaves without effect is refused, one that there is not is told",
          "[cli][effect]") {
  const Given scene;
  scene.refuse({"--seed", "20,20,20", "--range", "-inf,100", "--candidate", "2"},
               "--candidate has no effect with --range");
  scene.refuse({"--range", "-inf,100", "--object-name", "a", "--seed", "20,20,20", "--object-name", "b",
                "--seed", "21,20,20", "--candidate", "2"},
               "--candidate has no effect with --range");
  const Outcome fewer =
      scene.run({"--seed", "20,20,20", "--candidate", "5", "--session", scene.folder / "s.json"});
  CHECK_THAT(fewer.err, Contains("fewer objects than 5") && Contains("--candidate"));
  const Outcome again = runCli({"replay", scene.folder / "s.json", "-o", scene.folder / "again.stl"});
  CHECK(again.exitCode == 0);
  CHECK_THAT(again.err, Contains("fewer objects than 5"));
  CHECK_THAT(scene.run({"--seed", "20,20,20"}).err, !Contains("fewer objects"));
}

TEST_CASE("an empty path is refused by its name", "[cli][effect]") {
  const test::TempFolder folder;
  requireRefusal(folder, {"segment", "", "--seed", "1,2,3", "-o", folder / "a.stl"}, 2,
                 "VOLUME: it is empty");
  requireRefusal(folder, {"info", ""}, 2, "VOLUME: it is empty");
  requireRefusal(folder, {"replay", "", "-o", folder / "a.stl"}, 2, "SESSION: it is empty");
}

TEST_CASE("a given object beside one that grows does not keep that from its sensitivity", "[cli][effect]") {
  const Given scene;
  const std::string report = scene.folder / "r.json";
  const Outcome both = scene.run({"--sensitivity", "2", "--report", report, "--object-name", "a", "--given",
                                  scene.ball, "--object-name", "b", "--seed", "28,20,20,1"});
  INFO(both.err);
  REQUIRE(both.exitCode == 0);
  const auto json = nlohmann::json::parse(readBytes(report));
  CHECK_FALSE(json.at("objects").at(0).contains("sensitivity"));
  CHECK(json.at("objects").at(1).contains("sensitivity"));
}

TEST_CASE("options of a growth are refused for an object that is given", "[cli][effect]") {
  const Given scene;
  for (const auto& option : std::vector<std::vector<std::string>>{{"--range", "0,10"},
                                                                  {"--smoothing", "2"},
                                                                  {"--direction", "both"},
                                                                  {"--max-iterations", "9"},
                                                                  {"--edge-length", "2"},
                                                                  {"--candidate", "2"},
                                                                  {"--allow", "1,2,3"},
                                                                  {"--on-leak", "stop"},
                                                                  {"--list-candidates"}}) {
    std::vector<std::string> more = option;
    more.insert(more.end(), {"--given", scene.ball});
    scene.refuse(more, option[0] + " has no effect on an object that --given says");
  }
  scene.refuse({"--given", scene.ball, "--start-genus", "0"}, "--start-genus has no effect");
  scene.refuse({"--start", scene.ball, "--start-smooth", "1"}, "--start-smooth has no effect");
}

TEST_CASE("what a label map leaves out of a surface is told", "[cli][effect]") {
  const Given scene;
  const auto written = [&](const TriangleSoup& mesh, const std::string& name) {
    writeMesh(mesh, scene.folder / "part.stl");
    const Outcome outcome = runCli({"segment", scene.volume, "--given", scene.folder / "part.stl", "-o",
                                    scene.folder / name, "--report", scene.folder / "r.json", "--quiet"});
    CHECK(outcome.exitCode == 0);
    const auto warnings = nlohmann::json::parse(readBytes(scene.folder / "r.json")).at("warnings").dump();
    return std::pair(outcome.err, warnings);
  };
  const char* const kNone = "No voxel with a value has its centre inside";
  const char* const kPart = "A part of the surface lies outside of the volume";
  const TriangleSoup between = icosphere(Vec3(20.5, 20.5, 20.5), 0.3, 0.1);
  for (const char* name : {"m.nii", "m.seg.nrrd"}) {
    const auto [said, reported] = written(between, name);
    CHECK_THAT(said, Contains(kNone));
    CHECK_THAT(reported, Contains(kNone));
  }
  CHECK_THAT(written(icosphere(Vec3(33, 20, 20), 10, 2), "m.mha").first, Contains(kPart) && !Contains(kNone));
  CHECK_THAT(written(icosphere(Vec3(20, 20, 20), 8, 2), "m.mha").first, !Contains(kPart) && !Contains(kNone));
  CHECK_THAT(written(between, "m.ply").first, !Contains(kNone));
}

TEST_CASE("what a given object cannot keep is refused", "[cli][effect]") {
  const Given scene;
  scene.refuse({"--given", scene.ball, "--wall", "20,20,20,2"}, "lies over the surface that --given says");
  scene.refuse({"--given", scene.ball, "--wall", "26,20,20,2"}, "lies over the surface that --given says");
  scene.refuse({"--given", scene.ball, "--wall-disc", "20,20,20,1,0,0,30"}, "lies over the surface");
  writeVolume(volumeByIndex(cubicGrid(41), [](int i, int, int) { return i == 24 ? 1.0 : 0.0; }),
              scene.folder / "walls.nrrd");
  scene.refuse({"--given", scene.ball, "--walls", scene.folder / "walls.nrrd"}, "lies over the surface");
  scene.refuse({"--given", scene.torus, "--genus", "0"},
               "--genus: " + scene.torus + " has 1 handles or tunnels");
  scene.run({"--given", scene.ball, "--wall", "35,20,20,2", "--genus", "0", "--components", "1"});
  scene.run({"--given", scene.torus, "--genus", "1"});
}

TEST_CASE("what stands before the first name may be meant for objects that are not given", "[cli][effect]") {
  const Given scene;
  const std::vector<std::string> objects{
      "--object-name", "a", "--given", scene.ball, "--object-name", "b", "--seed", "20,20,28,1", "--quiet"};
  std::vector<std::string> common{"--wall", "20,20,20,2", "--smoothing", "0.5", "--genus", "3"};
  common.insert(common.end(), objects.begin(), objects.end());
  scene.run(common);
  scene.refuse({"--object-name", "a", "--given", scene.ball, "--wall", "20,20,20,2", "--object-name", "b",
                "--seed", "20,20,28,1"},
               "object 'a': The wall at");
  scene.refuse({"--smoothing", "1", "--object-name", "a", "--given", scene.ball, "--object-name", "b",
                "--given", scene.torus},
               "object 'a': --smoothing has no effect");
}

TEST_CASE("a click on the wrong side of a given object is told, and its session is replayed",
          "[cli][effect]") {
  const Given scene;
  const Outcome wrong = scene.run({"--given", scene.ball, "--background", "20,20,20", "--seed", "32,20,20"});
  CHECK_THAT(wrong.err, Contains("the seed at 32.0,20.0,20.0") &&
                            Contains("the click outside of the object at 20.0,20.0,20.0"));
  scene.run({"--given", scene.ball, "--session", scene.folder / "s.json"});
  auto json = nlohmann::json::parse(readBytes(scene.folder / "s.json"));
  json["requested"]["smoothing"] = 2;
  json["requested"]["constraints"]["walls"] = {{{"centre", {20, 20, 20}}, {"radius", 2}}};
  writeBytes(scene.folder / "old.json", json.dump());
  const Outcome old = runCli({"replay", scene.folder / "old.json", "-o", scene.folder / "old.stl"});
  INFO(old.err);
  CHECK(old.exitCode == 0);
}

TEST_CASE("a given object does not grow on the way to an edit", "[cli][effect]") {
  const Given scene;
  scene.run({"--given", scene.ball, "--edit", "6:smooth:26,20,20,3", "-o", scene.folder / "late.ply"});
  scene.run({"--given", scene.ball, "--edit", "1:smooth:26,20,20,3", "-o", scene.folder / "at_once.ply"});
  CHECK(readBytes(scene.folder / "late.ply") == readBytes(scene.folder / "at_once.ply"));
}

TEST_CASE("options without effect are refused by name", "[cli][effect]") {
  const Given scene;
  const std::string map = scene.folder / "map.nii.gz", out = scene.folder / "m.stl";
  writeVolume(volumeByIndex(cubicGrid(21),
                            [](int i, int j, int k) {
                              return (Vec3(i, j, k) - Vec3(10, 10, 10)).norm() < 7 ? 1.0 : 0.0;
                            }),
              map);
  const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& named) {
    requireRefusal(scene.folder, arguments, 2, named);
  };
  refuse({"mesh", map, "-o", out, "--smooth", "0", "--edge-length", "2"}, "--edge-length has no effect");
  refuse({"mesh", map, "-o", scene.folder / "m.nii.gz", "--space", "RAS"}, "--space RAS has no effect");
  refuse({"mesh", map, "-o", out, "--creator", "Roe^Ann"}, "--creator has no effect");
  refuse({"mesh", map, "-o", out, "--description", "print"}, "--description has no effect");
  refuse({"mesh", map, "-o", out, "--mesher-seconds", "9"}, "--mesher-seconds has no effect");
  refuse({"measure", scene.ball, "--uneven", "refuse"}, "--uneven");
  refuse({"edit", scene.ball, "--space", "RAS"}, "--space has no effect without -o");
  refuse({"edit", scene.ball, "--polish", "off"}, "--polish has no effect without -o");
  scene.refuse({"--seed", "20,20,20", "--creator", "Roe^Ann"}, "--creator has no effect");
  requireRefusal(scene.folder, {"segment", scene.volume, "--seed", "20,20,20", "-o", map, "--space", "RAS"},
                 2, "--space RAS has no effect");
}

TEST_CASE("a path that is empty, or an option that was taken for one, is refused by name", "[cli][effect]") {
  const Given scene;
  for (const char* option :
       {"--report", "--session", "--trace", "--picture", "--label-description", "--sensitivity-surface"}) {
    scene.refuse({"--seed", "20,20,20", option, ""}, std::string(option) + ": the path is empty");
    scene.refuse({"--seed", "20,20,20", option, "--quiet"}, std::string(option) + ": '--quiet' is no path");
  }
  for (const char* option : {"--csv", "--json", "--to"})
    requireRefusal(scene.folder, {"measure", scene.ball, option, ""}, 2,
                   std::string(option) + ": the path is empty");
  requireRefusal(scene.folder, {"compare", scene.ball, scene.torus, "--csv", ""}, 2,
                 "--csv: the path is empty");
  writeBytes(scene.folder / "st.csv", "volume,seed\nv.nrrd,\"20,20,20\"\n");
  requireRefusal(scene.folder, {"batch", scene.folder / "st.csv", "-o", ""}, 2, "-o: the path is empty");
  scene.refuse({"--object-name", "a", "--seed", "20,20,20", "--object-name", "b", "--seed", "21,20,20",
                "--report", "-o"},
               "--report: '-o' is no path");
}
