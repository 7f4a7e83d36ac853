// edit: what it lists, what it does, what it refuses; through the program.

#include <algorithm>
#include <filesystem>

#include "core/io/meshes/mesh_io.h"

#include "tests/app/run_cli.h"
#include "tests/support/catch.h"
#include "tests/support/tunnel_shapes.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Two tori with a cavity in the larger one, and a small ball: the tunnels have loops of 6.3 and 12.6 mm.
struct PiecesFile {
  TempFolder folder;
  std::string path = folder / "pieces.ply";

  PiecesFile() {
    const TriangleSoup large =
        zoo::both(zoo::torus(60, 30, 6, 2), zoo::insideOut(zoo::moved(zoo::sphere(3), Vec3(6, 0, 0))));
    const TriangleSoup small = zoo::moved(zoo::torus(40, 20, 3, 1), Vec3(20, 0, 0));
    writeMesh(zoo::both(zoo::both(large, small), zoo::moved(zoo::sphere(2), Vec3(0, 20, 0))), path);
  }
  nlohmann::json check(const std::string& name) const {
    return runForJson({"check", folder / name, "--json"});
  }
};

void expectRefusal(const std::vector<std::string>& arguments, int exitCode, const std::string& says) {
  const Outcome outcome = runCli(arguments);
  INFO(outcome.err);
  CHECK(outcome.exitCode == exitCode);
  CHECK_THAT(outcome.err, Contains(says));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(outcome.out.empty());
}

}  // namespace

TEST_CASE("edit without an edit lists tunnels, components and cavities", "[cli]") {
  const PiecesFile file;
  const auto json = runForJson({"edit", file.path, "--json"});
  const auto& before = json.at("before");
  REQUIRE(before.at("components").size() == 4);
  CHECK(before.at("components")[1].at("cavity") == true);
  CHECK(before.at("components")[1].at("within") == 0);
  CHECK(before.at("components")[0].at("genus") == 1);
  CHECK(before.at("components")[0].at("volume_ml").get<double>() == Approx(0.4737).epsilon(0.03));
  CHECK(before.at("components")[0].at("size_mm")[2].get<double>() == Approx(4).epsilon(0.02));
  REQUIRE(before.at("tunnels").size() == 2);
  CHECK(before.at("tunnels")[0].at("handle_loop_mm").get<double>() == Approx(6.283).epsilon(0.02));
  CHECK(before.at("tunnels")[0].at("tunnel_loop_mm").get<double>() == Approx(12.57).epsilon(0.02));
  CHECK(before.at("tunnels")[1].at("handle_loop_mm").get<double>() == Approx(12.57).epsilon(0.02));
  CHECK(before.at("tunnels_not_listed") == 0);
  CHECK_FALSE(json.contains("edits"));
  const Outcome text = runCli({"edit", file.path});
  CHECK(text.exitCode == 0);
  CHECK_THAT(text.out, Contains("cavity of") && Contains("mm round the tunnel"));
}

TEST_CASE("an edited mesh is written in every format that needs no volume", "[cli]") {
  const PiecesFile file;
  const std::string three = file.folder / "m.3mf", gltf = file.folder / "m.gltf", stl = file.folder / "m.stl";
  const Outcome done = runCli({"edit", file.path, "--keep-largest", "-o", stl, "-o", three, "-o", gltf});
  INFO(done.err);
  REQUIRE(done.exitCode == 0);
  CHECK(readBytes(three).starts_with("PK"));
  CHECK(nlohmann::json::parse(readBytes(gltf)).at("meshes").size() == 1);
  CHECK(file.check("m.stl").at("components") == 2);
  expectRefusal({"edit", file.path, "--keep-largest", "-o", file.folder / "m.seg.nrrd"}, 2, ".gltf");
}

TEST_CASE("with --anonymous the report of an edit does not say where the mesh was", "[cli]") {
  const PiecesFile file;
  for (const std::vector<std::string>& edits : {std::vector<std::string>{}, {"--keep-largest"}}) {
    std::vector<std::string> words{"edit", file.path, "--json", "--report", file.folder / "r.json"};
    words.insert(words.end(), edits.begin(), edits.end());
    if (!edits.empty()) words.insert(words.end(), {"-o", file.folder / "m.stl"});
    CHECK_THAT(runCli(words).out, Contains("pieces.ply"));
    words.emplace_back("--anonymous");
    const Outcome done = runCli(words);
    CHECK(done.exitCode == 0);
    CHECK_THAT(done.out + readBytes(file.folder / "r.json"),
               !Contains("pieces") && !Contains(file.folder.path()));
  }
}

TEST_CASE("edit closes short tunnels, keeps the largest body and fills its cavity", "[cli]") {
  const PiecesFile file;
  const auto json = runForJson({"edit", file.path, "--close-tunnels", "shorter-than", "8", "--json", "-o",
                                file.folder / "closed.stl", "-o", file.folder / "closed.obj"});
  CHECK(json.at("edits").size() == 1);
  CHECK(json.at("edits")[0].at("kind") == "handle cut");
  CHECK(json.at("edits")[0].at("after").at("genus") == 1);
  CHECK(json.at("still_open").empty());
  CHECK(json.at("after").at("tunnels").size() == 1);
  for (const char* name : {"closed.stl", "closed.obj"}) CHECK(file.check(name).at("genus").size() == 4);

  const Outcome all =
      runCli({"edit", "--close-tunnels", "100", file.path, "--keep-largest", "--fill-cavities", "-o",
              file.folder / "all.vtp", "--report", file.folder / "r.json"});
  CHECK(all.exitCode == 0);
  CHECK(all.err.empty());
  CHECK_THAT(all.out, Contains("volume") && Contains("components 1, was 4; genus 0, was 2"));
  const auto check = file.check("all.vtp");
  CHECK(check.at("genus") == nlohmann::json::array({0}));
  CHECK(check.at("self_intersections") == 0);
  const auto report = nlohmann::json::parse(readBytes(file.folder / "r.json"));
  CHECK(report.at("edits").size() == 4);
  CHECK(report.at("edits")[0].at("volume_before_ml").get<double>() ==
        Approx(report.at("before").at("mesh").at("volume_mm3").get<double>() / 1000).epsilon(1e-6));
}

TEST_CASE("edit says which tunnel it could not close, and ends with 7", "[cli]") {
  const TempFolder folder;
  TriangleSoup rod = zoo::sphere(4);
  for (Vec3& p : rod.points) p = Vec3(0.4 * p.x(), 0.4 * p.y(), 6 * p.z());
  writeMesh(zoo::both(zoo::torus(48, 24, 3, 1), rod), folder / "threaded.ply");
  const Outcome outcome = runCli({"edit", folder / "threaded.ply", "--close-tunnels", "inf", "--cut",
                                  "tunnel", "-o", folder / "out.ply"});
  CHECK(outcome.exitCode == 7);
  CHECK_THAT(outcome.err, Contains("still open: no cap fits"));
  CHECK(runCli({"check", folder / "out.ply"}).exitCode == 0);
}

TEST_CASE("edit refuses what it cannot do, in one sentence, and writes nothing", "[cli]") {
  const PiecesFile file;
  const std::string out = file.folder / "out.stl";
  TriangleSoup open = zoo::torus(12, 8, 3, 1);
  open.triangles.pop_back();
  writeMesh(open, file.folder / "open.obj");
  expectRefusal({"edit", file.folder / "open.obj", "--keep-largest", "-o", out}, 3, "does not pass `check`");
  expectRefusal({"edit", file.folder / "none.obj"}, 3, "none.obj");
  expectRefusal({"edit"}, 2, "MESH is required");
  expectRefusal({"edit", file.path, "--keep-largest"}, 2, "-o");
  expectRefusal({"edit", file.path, "-o", out}, 2, "there is no edit to write");
  expectRefusal({"edit", file.path, "--cut", "handle", "--keep-largest", "-o", out}, 2, "--close-tunnels");
  expectRefusal({"edit", file.path, "--close-tunnels", "shorter-than", "-o", out}, 2, "--close-tunnels");
  expectRefusal({"edit", file.path, "--close-tunnels", "-3", "-o", out}, 2, "--close-tunnels");
  expectRefusal({"edit", file.path, "--close-tunnels", "shorter-than", "x", "-o", out}, 2, "'x'");
  expectRefusal({"edit", file.path, "--close-tunnels", "longer-than", "3", "-o", out}, 2, "longer-than");
  expectRefusal({"edit", file.path, "--close-tunnels", "3", "--cut", "both", "-o", out}, 2, "--cut");
  expectRefusal({"edit", file.path, "--keep-largest", "-o", file.path}, 2, "it is the input");
  expectRefusal({"edit", file.path, "--keep-largest", "-o", file.folder / "out.nii"}, 2, "a mesh is");
  expectRefusal({"edit", file.path, "--keep-largest", "-o", out, "--report", out}, 2, "named twice");
  CHECK(file.folder.names() == std::vector<std::string>{"open.obj", "pieces.ply"});
}

TEST_CASE("check and the report of segment list the tunnels", "[cli]") {
  const PiecesFile file;
  CHECK(file.check("pieces.ply").at("tunnels").size() == 2);
  CHECK_THAT(runCli({"check", file.path}).out, Contains("mm round the tunnel"));
  const PhantomFile phantom = makePhantomFile(file.folder);
  REQUIRE(runCli({"segment", phantom.path, "--seed", phantom.seed, "-o", file.folder / "s.stl", "--report",
                  file.folder / "r.json", "--quiet"})
              .exitCode == 0);
  CHECK(nlohmann::json::parse(readBytes(file.folder / "r.json")).at("tunnels").empty());
}

TEST_CASE("segment makes edits as steps, report and session tell them, and replay makes the same bytes",
          "[cli]") {
  const TempFolder folder;
  const PhantomFile torus = makePhantomFile(folder, "torus.mha", {}, "torus");
  const auto segment = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"segment",  torus.path,       "--seed",    torus.seed,
                                       "-o",       folder / "a.stl", "--session", folder / "s.json",
                                       "--report", folder / "r.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runCli(arguments);
  };
  REQUIRE(segment({}).exitCode == 0);
  const auto free = nlohmann::json::parse(readBytes(folder / "r.json"));
  REQUIRE(free.at("tunnels").size() == 1);
  const std::string next = std::to_string(free.at("iterations").get<int>() + 1);
  const std::string at = free.at("tunnels").at(0).at("position").dump();
  const std::string place = at.substr(1, at.size() - 2);

  REQUIRE(segment({"--edit", next + ":cut-handle:" + place}).exitCode == 0);
  const auto cut = nlohmann::json::parse(readBytes(folder / "r.json"));
  CHECK(cut.at("tunnels").empty());
  CHECK(cut.at("stopped") == "converged");
  const auto& event = cut.at("events").back();
  CHECK(event.at("kind") == "handle cut");
  CHECK(event.at("edit").at("volume_after_ml") < event.at("edit").at("volume_before_ml"));
  CHECK(event.at("edit").at("loop_mm").get<double>() ==
        Approx(free.at("tunnels").at(0).at("handle_loop_mm").get<double>()).epsilon(0.01));
  CHECK(cut.at("requested").at("constraints").at("edits").at(0).at("loop") == "handle");
  for (const char* file : {"s.json", "r.json"}) {
    REQUIRE(runCli({"replay", folder / file, "-o", folder / "b.stl"}).exitCode == 0);
    CHECK(readBytes(folder / "a.stl") == readBytes(folder / "b.stl"));
  }

  const auto refused = [&](const std::string& edit, const std::string& says) {
    expectRefusal(
        {"segment", torus.path, "--seed", torus.seed, "-o", folder / "c.stl", "--quiet", "--edit", edit}, 2,
        says);
  };
  refused("2:close-tunnel:" + place, "The edit of iteration 2 finds no tunnel at");
  refused("9:paint:1,2,3", "--edit");
  refused("0:close-tunnel:1,2,3", "--edit");
  refused("close-tunnel:1,2,3", "--edit");
  CHECK_FALSE(std::filesystem::exists(folder / "c.stl"));
}

TEST_CASE("an edit in a session that means nothing is refused with the file's name", "[cli]") {
  const TempFolder folder;
  const PhantomFile torus = makePhantomFile(folder, "torus.mha", {}, "torus");
  REQUIRE(runCli({"segment", torus.path, "--seed", torus.seed, "--edit", "2:keep-component:1,2,3", "-o",
                  folder / "a.stl"})
              .exitCode == 2);
  REQUIRE(runCli({"segment", torus.path, "--seed", torus.seed, "--max-iterations", "3", "-o",
                  folder / "a.stl", "--session", folder / "s.json"})
              .exitCode == 5);
  auto session = nlohmann::json::parse(readBytes(folder / "s.json"));
  const auto refused = [&](const nlohmann::json& edit, const std::string& says) {
    session["requested"]["constraints"] = {{"edits", {edit}}};
    writeBytes(folder / "bad.json", session.dump());
    expectRefusal({"replay", folder / "bad.json", "-o", folder / "b.stl", "--quiet"}, 3, says);
  };
  const nlohmann::json good = {{"iteration", 2}, {"kind", "fill-cavity"}, {"place", {1, 2, 3}}};
  auto bad = good;
  bad["kind"] = "paint";
  refused(bad, "edits[0].kind' is 'paint'");
  bad = good;
  bad["iteration"] = 0;
  refused(bad, "edits[0].iteration' is 0, and must be at least 1");
  bad = good;
  bad["place"] = {1, 2};
  refused(bad, "bad.json");
  bad = good;
  bad["loop"] = "long";
  refused(bad, "edits[0].loop' is 'long'");
}

TEST_CASE("edit smooths, pulls and cuts in the order given, certified", "[cli][touch]") {
  const TempFolder folder;
  writeMesh(zoo::scaled(zoo::sphere(10), 10), folder / "ball.ply");
  const auto json = runForJson({"edit", folder / "ball.ply", "--pull=0,0,10,0,0,14,5", "--cut-plane",
                                "0,0,12,0,0,1,negative", "--smooth-here", "10,0,0,4",
                                "--pull=0,0,-10,0,0,-12,5", "--json", "-o", folder / "out.ply"});
  const auto& edits = json.at("edits");
  REQUIRE(edits.size() == 4);
  CHECK(edits[0].at("kind") == "pulled");
  CHECK(edits[1].at("kind") == "cut by a plane");
  CHECK(edits[2].at("kind") == "smoothed by hand");
  CHECK(edits[3].at("kind") == "pulled");
  for (std::size_t i = 1; i < edits.size(); ++i)
    CHECK(edits[i].at("volume_before_ml").get<double>() ==
          Approx(edits[i - 1].at("volume_after_ml").get<double>()));
  CHECK(edits[0].at("volume_after_ml") > edits[0].at("volume_before_ml"));
  CHECK(edits[1].at("volume_after_ml") < edits[1].at("volume_before_ml"));
  CHECK(edits[2].at("volume_after_ml").get<double>() ==
        Approx(edits[2].at("volume_before_ml").get<double>()).epsilon(1e-6));
  CHECK(json.at("after").at("mesh").at("self_intersections") == 0);
  CHECK(json.at("after").at("mesh").at("components") == 1);

  const Outcome both =
      runCli({"edit", folder / "ball.ply", "--cut-plane", "0,0,0,1,1,0", "-o", folder / "b.stl"});
  CHECK(both.exitCode == 0);
  CHECK_THAT(both.out, Contains("cut by a plane at 0,0,0") && Contains("components 2, was 1"));
  CHECK(runForJson({"check", folder / "b.stl", "--json"}).at("genus").size() == 2);
}

TEST_CASE("local edits without sense are refused in one sentence, and nothing is written", "[cli][touch]") {
  const TempFolder folder;
  writeMesh(zoo::scaled(zoo::sphere(6), 10), folder / "ball.ply");
  const auto refuse = [&](const std::string& option, const std::string& value, const std::string& says) {
    CAPTURE(option, value);
    expectRefusal({"edit", folder / "ball.ply", option + "=" + value, "-o", folder / "out.ply"}, 2, says);
    CHECK_FALSE(std::filesystem::exists(folder / "out.ply"));
  };
  refuse("--smooth-here", "0,0,0,5", "--smooth-here 0,0,0,5: No vertex of the surface lies in the ball.");
  refuse("--smooth-here", "0,0,10,0", "radius above 0");
  refuse("--smooth-here", "0,0,10", "X,Y,Z,R");
  refuse("--pull", "0,0,10,0,0,-20,4", "The surface would meet itself there.");
  refuse("--pull", "0,0,10,0,0,nan,4", "--pull: 'nan' is not a number.");
  refuse("--pull", "0,0,10,0,0,inf,4", "finite numbers");
  refuse("--pull", "0,0,10,0,0,12,-1", "radius above 0");
  refuse("--cut-plane", "0,0,11,0,0,1", "The plane does not meet the surface.");
  refuse("--cut-plane", "0,0,1,0,0,0", "normal of some length");
  refuse("--cut-plane", "0,0,1,0,0,1,upper", "both|positive|negative");
  refuse("--cut-plane", "0,0,1,0,0,1,0", "radius above 0");
  refuse("--cut-plane", "0,0,1,0,0", "X,Y,Z,NX,NY,NZ");
}
