// --frames: a surface through the frames of a 4D volume, on the command line.

#include <cmath>
#include <filesystem>

#include "core/io/report/session.h"
#include "core/version.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using handlebody::Constraints;
using handlebody::OverTimeRequest;
using handlebody::Session;
using handlebody::Vec3;
using handlebody::WallMap;

namespace {

//! Four frames of the beating phantom, coarse.
struct Beating {
  std::string path, seed;
  nlohmann::json json;
};

Beating makeBeating(const TempFolder& folder, const std::string& name = "heart.nii.gz") {
  Beating made;
  made.path = folder / name;
  made.json = runForJson({"phantom", "beating", "-o", made.path, "--frames", "4", "--spacing", "2,2,2"});
  const auto& centre = made.json.at("seed").at("centre");
  for (int a = 0; a < 3; ++a)
    made.seed += (a ? "," : "") + std::to_string(centre.at(static_cast<std::size_t>(a)).get<double>());
  return made;
}

Outcome run(std::vector<std::string> arguments, int exitCode = 0) {
  const Outcome outcome = runCli(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == exitCode);
  return outcome;
}

std::string withText(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

//! Two frames of a small gyroid, each with its own noise. Grown with coarse edges it has thin triangles in
//! both.
struct Gyroids {
  std::string folder, seed;
};

Gyroids makeGyroids(const TempFolder& folder) {
  Gyroids made{folder / "gyroids", {}};
  std::filesystem::create_directory(made.folder);
  for (const std::string number : {"1", "2"}) {
    const auto json =
        runForJson({"phantom", "gyroid", "-o", made.folder + "/f" + number + ".nii.gz", "--size", "34,34,34",
                    "--spacing", "3,3,3", "--noise", "0.2", "--random-seed", number});
    made.seed.clear();
    for (const auto& x : json.at("seed").at("centre")) made.seed += x.dump() + ",";
    made.seed += json.at("seed").at("radius").dump();
  }
  return made;
}

//! Of all frames, with a seed that no test grows.
Session sessionOverTime(const std::string& volume) {
  Session session;
  session.version = HANDLEBODY_VERSION;
  session.volume = {volume, {}, {}};
  session.seeds = {{Vec3(1, 2, 3), {}}};
  session.overTime = OverTimeRequest{};
  return session;
}

double leastOf(const std::string& mesh, const std::string& angles) {
  return runForJson({"check", mesh, "--json"}).at("quality").at(angles).at("least");
}

}  // namespace

TEST_CASE("every frame is polished as it is written, and nothing of its growth depends on that",
          "[cli][time][polish]") {
  const TempFolder folder;
  const Gyroids gyroids = makeGyroids(folder);
  const auto reportWith = [&](const std::string& polish) {
    run({"segment", gyroids.folder, "--seed", gyroids.seed, "--range", "-inf,110", "--edge-length", "6",
         "--frames", "all", "--drift-check", "none", "--polish", polish, "-o", folder / (polish + ".ply"),
         "--report", folder / (polish + ".json"), "--quiet"});
    return nlohmann::json::parse(readBytes(folder / (polish + ".json")));
  };
  const auto on = reportWith("on"), off = reportWith("off");
  CHECK(on.at("iterations") == off.at("iterations"));
  CHECK(on.at("events") == off.at("events"));
  CHECK(on.at("over_time").at("curve") == off.at("over_time").at("curve"));
  for (std::size_t f = 0; f < 2; ++f) {
    const std::string file = f == 0 ? "_0000.ply" : "_0001.ply";
    INFO(file);
    REQUIRE(leastOf(folder / ("off" + file), "angles_degrees") < 15);
    CHECK(leastOf(folder / ("on" + file), "angles_degrees") >= 15);
    CHECK(leastOf(folder / ("on" + file), "dihedral_angles_degrees") >= 20);
    const auto &is = on.at("over_time").at("results").at(f), &was = off.at("over_time").at("results").at(f);
    for (const char* key : {"volume_mm3", "components", "genus", "iterations", "stopped", "faults"})
      CHECK(is.at(key) == was.at(key));
    CHECK(is.at("polish").at("changed_faces") > 0);
    CHECK_FALSE(was.contains("polish"));
  }
}

TEST_CASE("segment --frames writes numbered meshes, a 4D label map, the curve and a report", "[cli][time]") {
  const TempFolder folder;
  const Beating heart = makeBeating(folder);
  const Outcome told = run({"segment",
                            heart.path,
                            "--seed",
                            heart.seed,
                            "--frame",
                            "1",
                            "--frames",
                            "all",
                            "-o",
                            folder / "m.vtp",
                            "-o",
                            folder / "m.stl",
                            "-o",
                            folder / "labels.nii.gz",
                            "--curve",
                            folder / "curve.csv",
                            "--curve",
                            folder / "curve.svg",
                            "--report",
                            folder / "r.json",
                            "--drift-check",
                            "wrap"});
  CHECK_THAT(told.out, Contains("over 4 frames: end-diastole") && Contains("ejection fraction"));
  CHECK_THAT(told.out, Contains("from frame 3 back at frame 0: Dice 0.9"));
  CHECK_THAT(told.err, Contains("frame 2: ") && Contains("iterations from frame 1"));
  for (const char* name : {"m_0000.vtp", "m_0001.vtp", "m_0002.vtp", "m_0003.vtp", "m_0003.stl", "m.pvd"})
    CHECK_FALSE(readBytes(folder / name).empty());
  CHECK_THAT(readBytes(folder / "m.pvd"), Contains("timestep=\"250\" part=\"0\" file=\"m_0001.vtp\""));
  CHECK_THAT(readBytes(folder / "curve.csv"), StartsWith("frame,time_ms,volume_ml"));
  CHECK_THAT(readBytes(folder / "curve.svg"), Contains("ejection fraction"));

  const auto labels = runForJson({"info", folder / "labels.nii.gz", "--json"});
  CHECK(labels.at("frames") == 4);
  CHECK(labels.at("frame_time_ms").get<double>() == Approx(250).epsilon(1e-6));
  const auto report = nlohmann::json::parse(readBytes(folder / "r.json"));
  const auto& over = report.at("over_time");
  CHECK(over.at("frames") == nlohmann::json::array({0, 3}));
  CHECK(over.at("results").size() == 4);
  CHECK(over.at("results").at(1).at("from_frame").is_null());
  CHECK(over.at("results").at(1).at("volume_mm3") == report.at("mesh").at("volume_mm3"));
  CHECK(over.at("results").at(3).at("from_frame") == 2);
  for (std::size_t f = 0; f < 4; ++f) {
    const double truth = heart.json.at("frames").at(f).at("volume_ml");
    CHECK(over.at("results").at(f).at("volume_mm3").get<double>() / 1000 == Approx(truth).epsilon(0.04));
    CHECK(over.at("results").at(f).at("trusted") == true);
  }
  const double ejection = heart.json.at("ejection_fraction");
  CHECK(std::abs(over.at("curve").at("ejection_fraction").get<double>() - ejection) < 0.02);
  CHECK(over.at("drift").at(0).at("dice").get<double>() > 0.97);
}

TEST_CASE("the frame that is grown has the mesh of a run on it alone, and replay makes all bit for bit",
          "[cli][time]") {
  const TempFolder folder;
  const Beating heart = makeBeating(folder, "heart.nrrd");
  run({"segment", heart.path, "--seed", heart.seed, "--frame", "2", "-o", folder / "alone.stl", "--quiet"});
  run({"segment", heart.path, "--seed", heart.seed, "--frame", "2", "--frames", "1-3", "-o", folder / "m.stl",
       "--session", folder / "s.json", "--report", folder / "r.json", "--quiet", "--drift-check", "none"});
  CHECK(readBytes(folder / "alone.stl") == readBytes(folder / "m_0002.stl"));
  CHECK_FALSE(readBytes(folder / "m_0001.stl").empty());
  CHECK_FALSE(std::filesystem::exists(folder / "m_0000.stl"));
  for (const char* session : {"s.json", "r.json"}) {
    run({"replay", folder / session, "-o", folder / "again.stl", "--curve", folder / "again.csv", "--quiet"});
    for (const char* number : {"_0001", "_0002", "_0003"})
      CHECK(readBytes(folder / ("m" + std::string(number) + ".stl")) ==
            readBytes(folder / ("again" + std::string(number) + ".stl")));
  }
  CHECK_THAT(readBytes(folder / "again.csv"), Contains("\n3,"));
}

TEST_CASE("replay over time does not write over the session that it reads", "[cli][time]") {
  const TempFolder folder;
  const Session session = sessionOverTime(makeBeating(folder).path);
  const std::string path = folder / "s.json";
  writeSession(session, path);
  const std::string before = readBytes(path);
  for (const char* option : {"--trace", "--report", "--session"})
    requireRefusal(folder, {"replay", path, "-o", folder / "m.stl", option, path}, 2, option);
  CHECK(readBytes(path) == before);
}

TEST_CASE("nothing is written over the label maps of walls in corrected frames", "[cli][time]") {
  const TempFolder folder;
  Session session = sessionOverTime(makeBeating(folder).path);
  const auto walled = [&](const std::string& name) {
    writeBytes(folder / name, "walls");
    return Constraints{.walls = {.map = WallMap{folder / name, {}, nullptr}}};
  };
  session.overTime->corrections = {
      {2, {session.seeds, session.requested, walled("first.mha")}, {}, {}},
      {3, {session.seeds, session.requested, {}}, {{4, session.requested, {}, walled("later.mha")}}, {}}};
  const std::string path = folder / "s.json";
  writeSession(session, path);
  for (const char* name : {"first.mha", "later.mha"}) {
    const std::string map = folder / name;
    requireRefusal(folder, {"replay", path, "-o", folder / "m.stl", "--report", map}, 2, map);
    requireRefusal(folder, {"measure", path, "--csv", map}, 2, map);
    CHECK(readBytes(map) == "walls");
  }
}

TEST_CASE("a frame that cannot be read is a warning and exit code 7, and the others are written",
          "[cli][time]") {
  const TempFolder folder;
  const std::string frames = folder / "frames";
  std::filesystem::create_directory(frames);
  std::string seed;
  for (const std::string number : {"0", "1", "2"})
    seed = makePhantomFile(folder, "frames/f" + number + ".nii.gz", {"--random-seed", number}).seed;
  std::string bytes = readBytes(frames + "/f1.nii.gz");
  for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 64; ++i)
    bytes[i] = static_cast<char>(~bytes[i]);
  writeBytes(frames + "/f1.nii.gz", bytes);
  const Outcome told = run({"segment", frames, "--seed", seed, "--frames", "all", "-o", folder / "m.vtp",
                            "-o", folder / "labels.nii", "--report", folder / "r.json"},
                           7);
  CHECK_THAT(told.err, Contains("warning: frame 1: ") && Contains("f1.nii.gz"));
  CHECK_FALSE(readBytes(folder / "m_0002.vtp").empty());
  CHECK_FALSE(std::filesystem::exists(folder / "m_0001.vtp"));
  CHECK_THAT(readBytes(folder / "m.pvd"), !Contains("m_0001.vtp") && Contains("m_0002.vtp"));
  CHECK(runForJson({"info", folder / "labels.nii", "--json"}).at("frames") == 3);
  const auto results = nlohmann::json::parse(readBytes(folder / "r.json")).at("over_time").at("results");
  const auto& fault = results.at(1).at("faults").at(0);
  CHECK(fault.at("kind") == "unreadable");
  CHECK(fault.at("finding").at("kind") == "frame-unreadable");
  CHECK(fault.at("finding").at("sentence") == fault.at("text"));
  CHECK_THAT(fault.at("text").get<std::string>(), Contains("f1.nii.gz"));
  CHECK(results.at(1).at("volume_mm3").is_null());
  CHECK(results.at(2).at("from_frame") == 0);
  CHECK(results.at(2).at("trusted") == true);
  run({"segment", frames, "--seed", seed, "--frames", "all", "-o", folder / "m.vtp", "--curve",
       folder / "c.csv", "--report", folder / "a.json", "--anonymous"},
      7);
  const auto hidden = nlohmann::json::parse(readBytes(folder / "a.json")).at("over_time").at("results");
  CHECK(hidden.at(1).at("faults").at(0).at("text") == "its voxels cannot be read");
  CHECK(hidden.at(1).at("faults").at(0).at("finding").at("kind") == "frame-not-read");
  for (const char* file : {"a.json", "c.csv"}) CHECK_THAT(readBytes(folder / file), !Contains("f1.nii.gz"));
}

TEST_CASE("the frame that is grown is judged as the others are: what is not at rest is told", "[cli][time]") {
  const TempFolder folder;
  const Beating heart = makeBeating(folder);
  const Outcome told = run({"segment", heart.path, "--seed", heart.seed, "--frames", "0-1",
                            "--max-iterations", "6", "-o", folder / "m.stl", "--report", folder / "r.json"},
                           5);
  CHECK_THAT(told.err, Contains("warning: frame 0: the surface was not at rest"));
  const auto results = nlohmann::json::parse(readBytes(folder / "r.json")).at("over_time").at("results");
  CHECK(results.at(0).at("faults").at(0).at("kind") == "unfinished");
}

namespace {

//! Frame 0 has a hole in the wall between two rooms, the others have none.
Beating makeLeaking(const TempFolder& folder) {
  const std::string frames = folder / "rooms";
  std::filesystem::create_directory(frames);
  Beating made{frames, {}, {}};
  for (const std::string number : {"0", "1", "2"}) {
    std::vector<std::string> arguments{"phantom", "wall", "--noise",
                                       "0",       "-o",   frames + "/f" + number + ".nii"};
    if (number == "0") arguments.insert(arguments.end(), {"--gap", "4"});
    made.json = runForJson(arguments);
  }
  for (const auto& x : made.json.at("seed").at("centre"))
    made.seed += (made.seed.empty() ? "" : ",") + x.dump();
  return made;
}

nlohmann::json overTimeOf(const std::string& report) {
  return nlohmann::json::parse(readBytes(report)).at("over_time");
}

}  // namespace

TEST_CASE("a leak before which the surface was stopped is no fault of it, and replay says the same",
          "[cli][time]") {
  const TempFolder folder;
  const Beating rooms = makeLeaking(folder);
  run({"segment", rooms.path, "--seed", rooms.seed, "--range", "0,120", "--frames", "all", "--on-leak",
       "stop", "-o", folder / "m.stl", "--report", folder / "r.json", "--session", folder / "s.json"},
      6);  // a leak, and no frame that failed
  const nlohmann::json first = overTimeOf(folder / "r.json");
  CHECK(first.at("results").at(0).at("trusted") == true);
  runCli({"replay", folder / "s.json", "-o", folder / "again.stl", "--report", folder / "again.json"});
  const nlohmann::json again = overTimeOf(folder / "again.json");
  CHECK(again.at("curve") == first.at("curve"));
  for (std::size_t f = 0; f < 3; ++f)
    CHECK(again.at("results").at(f).at("faults") == first.at("results").at(f).at("faults"));
}

TEST_CASE("what is carried from a surface that leaked is not trusted, and there is no ejection fraction",
          "[cli][time]") {
  const TempFolder folder;
  const Beating rooms = makeLeaking(folder);
  const Outcome told = run({"segment", rooms.path, "--seed", rooms.seed, "--range", "0,120", "--frames",
                            "all", "-o", folder / "m.stl", "--report", folder / "r.json"},
                           7);
  CHECK_THAT(told.err, Contains("frame 1: it was carried from frame 0, whose surface failed") &&
                           !Contains("on its way back"));
  const nlohmann::json over = overTimeOf(folder / "r.json");
  for (const auto& r : over.at("results")) CHECK(r.at("trusted") == false);
  CHECK(over.at("curve").is_null());
}

TEST_CASE("what does not go with --frames is refused before any work", "[cli][time]") {
  const TempFolder folder;
  const Beating heart = makeBeating(folder);
  const PhantomFile ball = makePhantomFile(folder);
  const auto refused = [&](const std::string& path, const std::string& seed, std::vector<std::string> more,
                           const std::string& named) {
    std::vector<std::string> all{"segment", path, "--seed", seed};
    all.insert(all.end(), more.begin(), more.end());
    requireRefusal(folder, all, 2, named);
  };
  const auto heartRefused = [&](std::vector<std::string> more, const std::string& named) {
    refused(heart.path, heart.seed, std::move(more), named);
  };
  const std::string out = folder / "m.stl";
  refused(ball.path, ball.seed, {"--frames", "all", "-o", out}, "--frames is for a 4D volume");
  heartRefused({"--frames", "1-4", "-o", out}, "there is no frame 4");
  heartRefused({"--frames", "2-1", "-o", out}, "--frames");
  heartRefused({"--frames", "some", "-o", out}, "--frames");
  heartRefused({"--frames", "-2", "-o", out}, "--frames");
  heartRefused({"--frame", "0", "--frames", "1-3", "-o", out}, "--frame 0 is not one of --frames 1-3");
  heartRefused({"--topology", "free", "-o", out}, "--topology needs --frames");
  heartRefused({"--frame-time", "20", "-o", out}, "--frame-time needs --frames");
  heartRefused({"--curve", folder / "c.csv", "-o", out}, "--curve needs --frames");
  heartRefused({"--frames", "all", "--topology", "loose", "-o", out}, "--topology");
  heartRefused({"--frames", "all", "--drift-check", "twice", "-o", out}, "--drift-check");
  heartRefused({"--frames", "all", "--frame-time", "0", "-o", out}, "--frame-time");
  heartRefused({"--frames", "all", "--curve", folder / "c.png", "-o", out}, "--curve");
  heartRefused({"--frames", "all", "-o", folder / "m.mha"}, "m.mha: with --frames");
  heartRefused({"--frames", "all", "-o", folder / "m.seg.nrrd"}, "m.seg.nrrd: with --frames");
  heartRefused({"--frames", "all", "-o", folder / "m.3mf"}, "m.3mf: with --frames");
  heartRefused({"--frames", "all", "-o", folder / "none/m.stl"}, "none");
}

TEST_CASE("info tells when frames were taken, and --frame-time says it for a file that does not",
          "[cli][time]") {
  const TempFolder folder;
  const Beating heart = makeBeating(folder, "heart.nrrd");
  CHECK_THAT(run({"info", heart.path}).out,
             Contains("4 time points, 250 ms apart (from axis 3 index values, units)"));
  const auto known = runForJson({"info", heart.path, "--json"});
  CHECK(known.at("time_ms") == nlohmann::json::array({0.0, 250.0, 500.0, 750.0}));
  std::string text = withText(readBytes(heart.path), "units: \"\" \"\" \"\" \"ms\"\n", "");
  const std::string unknown = folder / "unknown.nrrd";
  writeBytes(unknown, text);
  CHECK_THAT(run({"info", unknown}).out, Contains("4 time points (the file does not say when)"));
  run({"segment", unknown, "--seed", heart.seed, "--frames", "0-1", "--frame-time", "40", "-o",
       folder / "m.stl", "--curve", folder / "c.csv", "--quiet", "--drift-check", "none"});
  CHECK_THAT(readBytes(folder / "c.csv"), Contains("\n1,40,"));
}

TEST_CASE("options of the beating phantom belong to it alone", "[cli][time]") {
  const TempFolder folder;
  requireRefusal(folder, {"phantom", "sphere", "-o", folder / "v.nii", "--ejection", "50"}, 2, "--ejection");
  requireRefusal(folder, {"phantom", "beating", "-o", folder / "v.mha"}, 2, "v.mha");
  requireRefusal(folder, {"phantom", "beating", "-o", folder / "v.nii", "--ejection", "90"}, 2, "--ejection");
  requireRefusal(folder, {"phantom", "beating", "-o", folder / "v.nii", "--surface", folder / "s.stl"}, 2,
                 "--surface");
}
