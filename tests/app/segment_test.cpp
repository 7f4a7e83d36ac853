// The whole way from a volume and a seed to files, through the program.

#include <cmath>
#include <filesystem>
#include <set>

#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

// A sphere of radius 30 mm in voxels of 2.5 mm, and segment's arguments for it.
struct SphereRun {
  TempFolder folder;
  PhantomFile phantom = makePhantomFile(folder);

  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"segment", phantom.path, "--seed", phantom.seed};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  // A seed of 4 mm, moved along x from the phantom's own.
  std::string seedAt(double dx) const {
    const auto& c = phantom.json.at("seed").at("centre");
    return nlohmann::json(c[0].get<double>() + dx).dump() + "," + c[1].dump() + "," + c[2].dump() + ",4";
  }
  void requireSuccess(const std::vector<std::string>& more) const {
    const Outcome outcome = runCli(arguments(more));
    INFO(outcome.err);
    REQUIRE(outcome.exitCode == 0);
  }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(readBytes(folder / name));
  }
};

nlohmann::json checkJson(const std::string& mesh) { return runForJson({"check", mesh, "--json"}); }

}  // namespace

TEST_CASE("segment writes a mesh that check passes, and a report of that mesh", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "m.stl", "--report", run.folder / "r.json"});
  CHECK(run.folder.names() == std::vector<std::string>{"m.stl", "r.json", "sphere.mha"});
  const auto report = run.json("r.json");
  const auto& mesh = report.at("mesh");
  CHECK(mesh.at("genus") == nlohmann::json::array({0}));
  CHECK(mesh.at("self_intersections") == 0);
  // The numbers are those of the file. Volume and area are sums in another order of vertices.
  const auto checked = checkJson(run.folder / "m.stl");
  for (const char* key :
       {"vertices", "faces", "components", "genus", "euler", "closed", "manifold", "oriented"})
    CHECK(checked.at(key) == mesh.at(key));
  CHECK(checked.at("volume_mm3").get<double>() == Approx(mesh.at("volume_mm3").get<double>()).epsilon(1e-9));
  CHECK(report.at("stopped") == "converged");
  CHECK(report.at("iterations") > 0);
  CHECK(report.at("input").at("sha256") == sha256OfPath(run.phantom.path));
  CHECK_THAT(report.at("notice").get<std::string>(), Contains("not a medical device"));
}

TEST_CASE("segment finds the sphere within half a voxel", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "m.ply"});
  const double volume = checkJson(run.folder / "m.ply").at("volume_mm3");
  const double radius = std::cbrt(volume * 3 / (4 * std::acos(-1.0)));
  CHECK(std::abs(radius - 30) < 0.5 * 2.5);
}

TEST_CASE("every kind of mesh file holds the same mesh", "[cli][segment]") {
  const SphereRun run;
  std::vector<std::string> outputs;
  for (const char* name : {"m.stl", "m.vtp", "m.ply", "m.obj"})
    outputs.insert(outputs.end(), {"-o", run.folder / name});
  run.requireSuccess(outputs);
  const auto stl = checkJson(run.folder / "m.stl");
  for (const char* name : {"m.vtp", "m.ply", "m.obj"}) {
    INFO(name);
    const auto other = checkJson(run.folder / name);
    CHECK(other.at("vertices") == stl.at("vertices"));
    CHECK(other.at("faces") == stl.at("faces"));
    CHECK(other.at("area_mm2").get<double>() == Approx(stl.at("area_mm2").get<double>()).epsilon(1e-9));
  }
}

TEST_CASE("the mesh is the same bit for bit with one and two threads and in two runs", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "a.vtp", "--threads", "1"});
  run.requireSuccess({"-o", run.folder / "b.vtp", "--threads", "1"});
  run.requireSuccess({"-o", run.folder / "c.vtp", "--threads", "2"});
  CHECK(readBytes(run.folder / "a.vtp") == readBytes(run.folder / "b.vtp"));
  CHECK(readBytes(run.folder / "a.vtp") == readBytes(run.folder / "c.vtp"));
}

TEST_CASE("an adaptive surface takes fewer iterations, is told by the report, and is replayed bit for bit",
          "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess(
      {"-o", run.folder / "u.vtp", "--report", run.folder / "u.json", "--session", run.folder / "us.json"});
  run.requireSuccess({"-o", run.folder / "a.vtp", "--resolution", "adaptive", "--report",
                      run.folder / "a.json", "--session", run.folder / "s.json"});
  CHECK(run.json("u.json").at("parameters").at("resolution") == "uniform");  // a small ball
  CHECK(run.json("us.json").at("requested").at("resolution") == "auto");
  CHECK(run.json("a.json").at("parameters").at("resolution") == "adaptive");
  CHECK(run.json("s.json").at("requested").at("resolution") == "adaptive");
  CHECK(run.json("a.json").at("iterations") < run.json("u.json").at("iterations"));
  REQUIRE(runCli({"replay", run.folder / "s.json", "-o", run.folder / "r.vtp"}).exitCode == 0);
  CHECK(readBytes(run.folder / "a.vtp") == readBytes(run.folder / "r.vtp"));
  const Outcome refused = runCli(run.arguments({"--resolution", "coarse", "-o", run.folder / "d.vtp"}));
  CHECK(refused.exitCode == 2);
  CHECK_THAT(refused.err, Contains("--resolution: 'coarse' is not auto, adaptive or uniform."));
}

TEST_CASE("the paper's hashing gives the same mesh, is told by the report and kept by the session",
          "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "a.vtp", "--report", run.folder / "a.json"});
  run.requireSuccess({"-o", run.folder / "b.vtp", "--broad-phase", "hashing", "--report",
                      run.folder / "b.json", "--session", run.folder / "s.json"});
  CHECK(readBytes(run.folder / "a.vtp") == readBytes(run.folder / "b.vtp"));
  CHECK(run.json("a.json").at("parameters").at("broad_phase") == "sorted");
  CHECK(run.json("b.json").at("parameters").at("broad_phase") == "hashing");
  REQUIRE(
      runCli({"replay", run.folder / "s.json", "-o", run.folder / "c.vtp", "--report", run.folder / "c.json"})
          .exitCode == 0);
  CHECK(run.json("c.json").at("parameters").at("broad_phase") == "hashing");
  const Outcome refused = runCli(run.arguments({"--broad-phase", "trees", "-o", run.folder / "d.vtp"}));
  CHECK(refused.exitCode == 2);
  CHECK_THAT(refused.err, Contains("--broad-phase: 'trees' is not hashing or sorted."));
}

TEST_CASE("replay makes the same mesh from a session and from a report", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"--object", "dark", "--curvature", "0.3", "-o", run.folder / "a.stl", "--space", "RAS",
                      "--session", run.folder / "s.json", "--report", run.folder / "r.json"});
  for (const char* from : {"s.json", "r.json"}) {
    const Outcome outcome = runCli({"replay", run.folder / from, "-o", run.folder / "b.stl"});
    INFO(outcome.err);
    REQUIRE(outcome.exitCode == 0);
    CHECK(outcome.err.empty());
    CHECK(readBytes(run.folder / "a.stl") == readBytes(run.folder / "b.stl"));
  }
}

TEST_CASE("replay refuses another volume and warns of another version", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "a.stl", "--session", run.folder / "s.json"});
  auto session = run.json("s.json");
  session["version"] = "0.0.0";
  writeBytes(run.folder / "old.json", session.dump());
  const Outcome old = runCli({"replay", run.folder / "old.json", "-o", run.folder / "b.stl"});
  CHECK(old.exitCode == 0);
  CHECK_THAT(old.err, Contains("warning") && Contains("0.0.0"));

  writeBytes(run.phantom.path, readBytes(run.phantom.path) + " ");
  const Outcome changed = runCli({"replay", run.folder / "s.json", "-o", run.folder / "c.stl"});
  CHECK(changed.exitCode == 3);
  CHECK_THAT(changed.err, Contains("sphere.mha"));
  CHECK_FALSE(std::filesystem::exists(run.folder / "c.stl"));
}

TEST_CASE("a replay without sense in its parameters blames the session", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "a.stl", "--session", run.folder / "s.json"});
  auto session = run.json("s.json");
  session["requested"]["balloon"] = -1;
  writeBytes(run.folder / "s.json", session.dump());
  const Outcome outcome = runCli({"replay", run.folder / "s.json", "-o", run.folder / "b.stl"});
  CHECK(outcome.exitCode == 3);
  CHECK_THAT(outcome.err, Contains("s.json"));
}

TEST_CASE("a label map lies on the input grid and encloses the volume of the mesh", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "l.nii.gz", "-o", run.folder / "l.nrrd", "-o", run.folder / "l.mha",
                      "--report", run.folder / "r.json"});
  const double meshVolume = run.json("r.json").at("mesh").at("volume_mm3");
  const Grid grid = readVolume(run.phantom.path).grid;
  for (const char* name : {"l.nii.gz", "l.nrrd", "l.mha"}) {
    INFO(name);
    const Volume label = readVolume(run.folder / name);
    CHECK(label.type == VoxelType::uint8);
    CHECK(label.grid.size == grid.size);
    CHECK((label.grid.origin - grid.origin).norm() < 1e-3);
    std::set<int> values;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < label.grid.voxelCount(); ++i) {
      values.insert(label.data<std::uint8_t>()[i]);
      inside += label.data<std::uint8_t>()[i];
    }
    CHECK(values == std::set<int>{0, 1});
    // The surface of a sphere of 30 mm cuts about 4·pi·144 = 1800 voxels of the 7200: half of each may go
    // either way, and the errors cancel to far below this bound.
    CHECK(static_cast<double>(inside) * label.grid.voxelVolume() == Approx(meshVolume).epsilon(0.03));
  }
}

TEST_CASE("RAS is refused where no mesh that is written could be turned", "[cli][segment]") {
  const SphereRun run;
  const std::string gltf = run.folder / "m.gltf", dicom = run.folder / "m.stl.dcm";
  for (const auto& paths : std::vector<std::vector<std::string>>{
           {gltf}, {gltf, dicom}, {gltf, run.folder / "m.nii"}, {run.folder / "m.nii"}}) {
    std::vector<std::string> arguments{"segment",        run.phantom.path, "--seed",
                                       run.phantom.seed, "--space",        "RAS"};
    for (const std::string& path : paths) arguments.insert(arguments.end(), {"-o", path});
    requireRefusal(run.folder, arguments, 2, "--space RAS has no effect");
  }
  run.requireSuccess({"-o", gltf, "-o", run.folder / "m.stl", "--space", "RAS"});
  run.requireSuccess({"-o", gltf, "--space", "LPS"});
  run.requireSuccess({"-o", run.folder / "m.nii", "--session", run.folder / "s.json", "--space", "RAS"});
}

TEST_CASE("RAS turns x and y, says so, and comes back the same", "[cli][segment]") {
  const SphereRun run;
  for (const char* name : {"m.obj", "m.vtp", "m.ply", "m.stl"}) {
    INFO(name);
    run.requireSuccess({"-o", run.folder / ("lps-" + std::string(name))});
    run.requireSuccess({"-o", run.folder / ("ras-" + std::string(name)), "--space", "RAS"});
    const TriangleSoup lps = readMesh(run.folder / ("lps-" + std::string(name)));
    const TriangleSoup ras = readMesh(run.folder / ("ras-" + std::string(name)));
    CHECK(readBytes(run.folder / ("lps-" + std::string(name))) !=
          readBytes(run.folder / ("ras-" + std::string(name))));
    CHECK(lps.points == ras.points);
    CHECK(lps.triangles == ras.triangles);
  }
}

TEST_CASE("a seed in voxels is the same seed in millimetres", "[cli][segment]") {
  const SphereRun run;
  const Grid grid = readVolume(run.phantom.path).grid;
  const Outcome outcome = runCli({"segment", run.phantom.path, "--seed-ijk", "15,16.5,17,2", "-o",
                                  run.folder / "a.stl", "--report", run.folder / "r.json"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  const Vec3 expected = grid.toWorld({15, 16.5, 17});
  const auto seed = run.json("r.json").at("seeds")[0];
  for (int axis = 0; axis < 3; ++axis) CHECK(seed.at("centre")[axis].get<double>() == expected[axis]);
  CHECK(seed.at("radius").get<double>() == Approx(2 * 2.5));
}

TEST_CASE("seeds in voxels and in millimetres are taken in the order of the command line", "[cli][segment]") {
  const SphereRun run;
  const Vec3 centre = readVolume(run.phantom.path).grid.toWorld({15, 16, 17});
  const std::string world =
      std::to_string(centre[0]) + "," + std::to_string(centre[1]) + "," + std::to_string(centre[2]);
  const Outcome outcome =
      runCli({"segment", run.phantom.path, "--seed-ijk", "15,16,17,2", "--seed", world + ",3", "--seed-ijk",
              "16,16,17,1", "-o", run.folder / "a.stl", "--report", run.folder / "r.json"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  const auto seeds = run.json("r.json").at("requested").at("seeds");  // those used leave the last one out
  REQUIRE(seeds.size() == 3);
  CHECK(seeds[0].at("radius").get<double>() == Approx(2 * 2.5));
  CHECK(seeds[1].at("radius").get<double>() == Approx(3));
  CHECK(seeds[2].at("radius").get<double>() == Approx(2.5));
}

TEST_CASE("a click in the background is no place to start, and replay knows it again", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"--object", "dark", "--background-ijk", "2,2,2", "--background", "2,2,60,3", "-o",
                      run.folder / "a.stl", "--session", run.folder / "s.json", "--report",
                      run.folder / "r.json"});
  const auto report = run.json("r.json");
  CHECK(report.at("seeds").size() == 1);
  CHECK(report.at("background").size() == 2);
  CHECK(report.at("mesh").at("components") == 1);
  for (const char* from : {"s.json", "r.json"}) {
    const Outcome outcome = runCli({"replay", run.folder / from, "-o", run.folder / "b.stl"});
    INFO(outcome.err);
    CHECK(outcome.exitCode == 0);
    CHECK(readBytes(run.folder / "a.stl") == readBytes(run.folder / "b.stl"));
  }
}

TEST_CASE("the likeliest candidate is what grows when none is asked for", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "a.stl", "--report", run.folder / "a.json"});
  run.requireSuccess({"-o", run.folder / "b.stl", "--report", run.folder / "b.json", "--candidate", "1"});
  CHECK(readBytes(run.folder / "a.stl") == readBytes(run.folder / "b.stl"));
  CHECK(run.json("a.json").at("parameters").at("candidate") == 1);
  CHECK(run.json("a.json").at("candidates") == run.json("b.json").at("candidates"));
}

TEST_CASE("options may come in any order", "[cli][segment]") {
  const SphereRun run;
  const std::string out = run.folder / "a.stl", left = run.seedAt(-20), right = run.seedAt(0);
  const auto meshOf = [&](std::vector<std::string> arguments) {
    std::filesystem::remove(out);
    arguments.insert(arguments.begin(), "segment");
    const Outcome outcome = runCli(arguments);
    INFO(outcome.err);
    CHECK(outcome.exitCode == 0);
    return readBytes(out);
  };
  const std::string one = meshOf({run.phantom.path, "--seed", left, "--seed", right, "-o", out});
  CHECK(meshOf({"--seed=" + left, "--seed=" + right, run.phantom.path, "-o", out}) == one);
  CHECK(meshOf({"-o", out, "--seed", left, "--seed", right, run.phantom.path, "--quiet"}) == one);
}

TEST_CASE("coordinates of seeds may be negative", "[cli][segment]") {
  const SphereRun run;
  std::string bytes = readBytes(run.phantom.path);
  const auto from = bytes.find("\nOffset = ");
  REQUIRE(from != std::string::npos);
  bytes.replace(from, bytes.find('\n', from + 1) - from, "\nOffset = -200 -200 -200");
  writeBytes(run.folder / "far.mha", bytes);
  for (const std::vector<std::string>& seed :
       std::vector<std::vector<std::string>>{{"--seed", "-160,-160,-160,5"}, {"--seed=-160,-160,-160,5"}}) {
    std::vector<std::string> arguments{"segment", run.folder / "far.mha", "-o", run.folder / "a.stl"};
    arguments.insert(arguments.end(), seed.begin(), seed.end());
    const Outcome outcome = runCli(arguments);
    INFO(outcome.err);
    CHECK(outcome.exitCode == 0);
  }
}

TEST_CASE("stopping at --max-iterations has its own exit code and still writes the mesh", "[cli][segment]") {
  const SphereRun run;
  const Outcome outcome = runCli(run.arguments(
      {"--max-iterations", "3", "-o", run.folder / "m.vtp", "--report", run.folder / "r.json"}));
  CHECK(outcome.exitCode == 5);
  CHECK(run.json("r.json").at("stopped") == "max-iterations");
  CHECK(run.json("r.json").at("iterations") == 3);
  CHECK(runCli({"check", run.folder / "m.vtp"}).exitCode == 0);
}

TEST_CASE("a picture is written beside the mesh, the same from a replay, and only when asked for",
          "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess(
      {"-o", run.folder / "m.stl", "--picture", run.folder / "a.png", "--session", run.folder / "s.json"});
  const std::string picture = readBytes(run.folder / "a.png");
  CHECK(picture.rfind("\x89PNG\r\n", 0) == 0);
  const Outcome again = runCli(
      {"replay", run.folder / "s.json", "-o", run.folder / "n.stl", "--picture", run.folder / "b.png"});
  CHECK(again.exitCode == 0);
  CHECK(readBytes(run.folder / "b.png") == picture);
  CHECK(run.folder.names() ==
        std::vector<std::string>{"a.png", "b.png", "m.stl", "n.stl", "s.json", "sphere.mha"});
}

TEST_CASE("standard error stays empty when it is not a terminal, and --quiet says nothing",
          "[cli][segment]") {
  const SphereRun run;
  const Outcome loud = runCli(run.arguments({"-o", run.folder / "m.stl"}));
  CHECK(loud.err.empty());
  CHECK_THAT(loud.out, Contains("converged"));
  const Outcome quiet = runCli(run.arguments({"-o", run.folder / "m.stl", "--quiet"}));
  CHECK(quiet.err.empty());
  CHECK(quiet.out.empty());
}

TEST_CASE("segment says when it takes the first of several time points", "[cli][segment]") {
  const SphereRun run;
  const std::string bytes = readBytes(makePhantomFile(run.folder, "plain.nii").path);
  const std::string voxels = bytes.substr(bytes.size() - 32 * 32 * 32);  // MetaImage files are compressed
  writeBytes(run.folder / "4d.mha",
             "ObjectType = Image\nNDims = 4\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
             "Offset = 0.75 0.75 0.75 0\nElementSpacing = 2.5 2.5 2.5 1\nDimSize = 32 32 32 2\n"
             "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                 std::string(voxels.size(), '\1') + voxels);
  const auto arguments = [&](const std::string& frame) {
    return std::vector<std::string>{"segment",  run.folder / "4d.mha", "--frame", frame,
                                    "--seed",   run.phantom.seed,      "-o",      run.folder / "b.stl",
                                    "--report", run.folder / "r.json"};
  };
  REQUIRE(runCli(arguments("1")).exitCode == 0);
  run.requireSuccess({"-o", run.folder / "a.stl"});
  CHECK(readBytes(run.folder / "a.stl") == readBytes(run.folder / "b.stl"));
  CHECK(run.json("r.json").at("input").at("frame") == 1);
  CHECK(run.json("r.json").at("input").at("warnings").empty());
  CHECK(runCli(arguments("2")).exitCode == 2);
  const Outcome silent = runCli({"segment", run.folder / "4d.mha", "--range", "0,200", "--max-iterations",
                                 "1", "--seed", run.phantom.seed, "-o", run.folder / "c.stl"});
  CHECK(silent.exitCode == 5);
  CHECK_THAT(silent.err, Contains("warning") && Contains("frame 0"));
}

TEST_CASE("an open range in the options is an open range in the report", "[cli][segment]") {
  const SphereRun run;
  const auto info = runForJson({"info", run.phantom.path, "--json"});
  const double middle =
      (info.at("intensities").at("min").get<double>() + info.at("intensities").at("max").get<double>()) / 2;
  run.requireSuccess({"--range", "-inf," + std::to_string(middle), "-o", run.folder / "m.stl", "--report",
                      run.folder / "r.json"});
  const auto report = run.json("r.json");
  CHECK(report.at("requested").at("range")[0] == "-inf");
  CHECK(report.at("parameters").at("range")[1].get<double>() == Approx(middle).margin(1e-6));
}

TEST_CASE("a run with two seeds tells of the handle that joins them", "[cli][segment]") {
  const SphereRun run;
  const Outcome outcome =
      runCli({"segment", run.phantom.path, "--seed", run.seedAt(-20), "--seed", run.seedAt(0), "-o",
              run.folder / "m.stl", "--report", run.folder / "r.json", "--trace", run.folder / "t.json"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  const auto report = run.json("r.json");
  CHECK(report.at("mesh").at("components") == 1);
  CHECK(report.at("seeds").size() == 2);
  REQUIRE_FALSE(report.at("events").empty());
  bool joined = false;
  for (const auto& event : report.at("events"))
    joined = joined || (event.at("before").at("components") == 2 && event.at("after").at("components") == 1);
  CHECK(joined);
  CHECK(run.json("t.json").at("events").size() == report.at("events").size());
}

TEST_CASE("a range that is open at both ends fills the volume", "[cli][segment]") {
  const SphereRun run;
  const Outcome outcome = runCli(run.arguments({"--range", "-inf,inf", "-o", run.folder / "m.stl"}));
  INFO(outcome.err);
  CHECK(outcome.exitCode == 0);
}

TEST_CASE("a surface that the curvature holds at its seed comes with a warning", "[cli][segment]") {
  const SphereRun run;
  const Outcome outcome = runCli({"segment", run.phantom.path, "--seed", run.phantom.seed, "--curvature",
                                  "50", "-o", run.folder / "m.stl", "--report", run.folder / "r.json"});
  CHECK(outcome.exitCode == 0);
  CHECK_THAT(outcome.err, Contains("hardly grew"));
  // Held in the middle of the object, it also lies where the image has no boundary.
  const auto report = run.json("r.json");
  CHECK_THAT(report.at("warnings").dump(), Contains("hardly grew"));
  CHECK(report.at("findings").at(0).at("kind") == "held-by-curvature");
  CHECK(report.at("findings").at(0).at("radius_mm").get<double>() > 5);
  run.requireSuccess({"-o", run.folder / "m.stl", "--report", run.folder / "r.json"});
  CHECK(run.json("r.json").at("warnings").empty());
}

TEST_CASE("a close choice is told with a report and without one", "[cli][segment]") {
  const TempFolder folder;
  const PhantomFile torus = makePhantomFile(folder, "torus.mha", {"--noise", "0.15"}, "torus");
  const std::vector<std::string> plain{"segment",           torus.path, "--seed",        torus.seed,
                                       "--list-candidates", "-o",       folder / "m.stl"};
  std::vector<std::string> reported = plain;
  reported.insert(reported.end(), {"--report", folder / "r.json"});
  const Outcome with = runCli(reported), without = runCli(plain);
  CHECK(nlohmann::json::parse(readBytes(folder / "r.json")).at("close_choice") == true);
  CHECK(with.err.find("objects is close") != std::string::npos);
  CHECK(without.err == with.err);
}

TEST_CASE("a seed larger than the object contracts onto it where the surface may shrink", "[cli][segment]") {
  const SphereRun run;
  std::string seed = run.phantom.seed;
  seed.replace(seed.rfind(','), std::string::npos, ",45");  // the ball has 30 mm
  const Outcome outcome = runCli({"segment", run.phantom.path, "--seed", seed, "--direction", "both", "-o",
                                  run.folder / "m.stl", "--report", run.folder / "r.json"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  const auto report = run.json("r.json");
  CHECK(report.at("stopped") == "converged");
  CHECK(report.at("seeds").at(0).at("radius") == 45);
  CHECK(report.at("warnings").empty());
  CHECK(report.at("mesh").at("volume_mm3").get<double>() == Approx(113097).epsilon(0.02));
}

TEST_CASE("a term names, colours and codes the object in what is written of it, and again in a replay",
          "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"--term", "liver", "--label-value", "5", "-o", run.folder / "a.seg.nrrd", "-o",
                      run.folder / "a.nii.gz", "--label-description", run.folder / "a.txt", "--session",
                      run.folder / "s.json"});
  const std::string header = readBytes(run.folder / "a.seg.nrrd").substr(0, 3000);
  CHECK_THAT(header, Contains("Segment0_Name:=Liver\n"));
  CHECK_THAT(header, Contains("SCT^10200004^Liver"));
  CHECK_THAT(header, Contains("Segment0_LabelValue:=5\n"));
  CHECK_THAT(readBytes(run.folder / "a.txt"), Contains("\"Liver\""));
  const Volume labels = readVolume(run.folder / "a.nii.gz");
  std::set<int> values;
  for (std::size_t i = 0; i < labels.grid.voxelCount(); ++i) values.insert(labels.data<std::uint8_t>()[i]);
  CHECK(values == std::set<int>{0, 5});

  const Outcome again = runCli({"replay", run.folder / "s.json", "--color", "1,2,3", "--object-name",
                                "My liver", "-o", run.folder / "b.seg.nrrd"});
  REQUIRE(again.exitCode == 0);
  const std::string second = readBytes(run.folder / "b.seg.nrrd").substr(0, 3000);
  CHECK_THAT(second, Contains("Segment0_Name:=My liver\n"));
  CHECK_THAT(second, Contains("Segment0_Color:=0.00392157 0.00784314 0.0117647\n"));
  CHECK_THAT(second, Contains("SCT^10200004^Liver"));
  CHECK_THAT(second, Contains("Segment0_LabelValue:=5\n"));
}

TEST_CASE("a name, term, colour or label value without meaning is refused with the option's name",
          "[cli][segment]") {
  const SphereRun run;
  const std::vector<std::pair<std::string, std::string>> bad{
      {"--object-name", "a|b"}, {"--term", "lever"},    {"--color", "1,2"},
      {"--color", "1,2,256"},   {"--label-value", "0"}, {"--label-value", "70000"}};
  for (const auto& [option, value] : bad) {
    const Outcome outcome = runCli(run.arguments({option, value, "-o", run.folder / "m.seg.nrrd"}));
    INFO(option << " " << value);
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err, Contains(option));
  }
  CHECK(run.folder.names() == std::vector<std::string>{"sphere.mha"});
}

TEST_CASE("a DICOM file of a volume that is not DICOM is refused before the work", "[cli][segment]") {
  const SphereRun run;
  for (const char* name : {"m.seg.dcm", "m.stl.dcm"}) {
    const Outcome outcome = runCli(run.arguments({"-o", run.folder / name, "-o", run.folder / "m.stl"}));
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err,
               Contains(std::string(name) + ": no DICOM file can be made: the volume was not read from"));
  }
  const Outcome creator = runCli(run.arguments({"-o", run.folder / "m.stl", "--creator", "A\\B"}));
  CHECK(creator.exitCode == 2);
  CHECK_THAT(creator.err, Contains("--creator"));
  CHECK(run.folder.names() == std::vector<std::string>{"sphere.mha"});
}

TEST_CASE("an anonymous session replays with the volume named, and says so without it", "[cli][segment]") {
  const SphereRun run;
  run.requireSuccess({"-o", run.folder / "a.stl", "-o", run.folder / "a.3mf", "--anonymous", "--session",
                      run.folder / "s.json", "--report", run.folder / "r.json"});
  for (const char* name : {"s.json", "r.json"}) {
    CHECK(run.json(name).at("input").at("path").is_null());
    const Outcome lost = runCli({"replay", run.folder / name, "-o", run.folder / "b.stl"});
    CHECK(lost.exitCode == 3);
    CHECK_THAT(lost.err, Contains(std::string(name) + ": it names no volume") && Contains("--volume"));
    const Outcome found =
        runCli({"replay", run.folder / name, "--volume", run.phantom.path, "-o", run.folder / "b.stl"});
    CHECK(found.exitCode == 0);
    CHECK(readBytes(run.folder / "a.stl") == readBytes(run.folder / "b.stl"));
  }
}

TEST_CASE("a smoothing or an edge that no surface of the volume could have is refused by its word", "[cli]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder);
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--smoothing", "1e9"},
                                                        {"--smoothing", "1e308"},
                                                        {"--edge-length", "200"},
                                                        {"--edge-length", "1e20"}}) {
    const Outcome outcome =
        runCli({"segment", phantom.path, "--seed", phantom.seed, option, value, "-o", folder / "m.stl"});
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err, Contains(option == "--smoothing" ? "The smoothing of" : "The edge length of") &&
                                Contains("at most"));
  }
  CHECK(folder.names() == std::vector<std::string>{"sphere.mha"});
}
