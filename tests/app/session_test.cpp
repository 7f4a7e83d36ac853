#include "core/io/report/session.h"

#include <filesystem>

#include "core/io/report/anonymous_names.h"
#include "core/io/report/over_time_report.h"
#include "core/io/report/unnamed_files.h"
#include "core/told_error.h"
#include "tests/app/session_support.h"

using namespace handlebody;
using namespace handlebody::test;

TEST_CASE("a session comes back exactly as it was written", "[session]") {
  const TempFolder folder;
  const Session s = unusualSession(folder / "v.mha");
  writeSession(s, folder / "s.json");
  const Session back = readSession(folder / "s.json");
  CHECK(back.version == s.version);
  CHECK(back.volume.path == s.volume.path);
  CHECK(back.volume.sha256 == s.volume.sha256);
  CHECK(back.volume.selection.series == s.volume.selection.series);
  CHECK(back.volume.selection.frame == s.volume.selection.frame);
  CHECK(back.volume.selection.spacing == s.volume.selection.spacing);
  CHECK(back.volume.selection.uneven == s.volume.selection.uneven);
  CHECK(back.seeds == s.seeds);
  CHECK(back.requested.object == s.requested.object);
  CHECK(back.requested.range->low == s.requested.range->low);
  CHECK(back.requested.range->high == s.requested.range->high);
  CHECK(back.requested.candidate == s.requested.candidate);
  CHECK(back.requested.smoothing == s.requested.smoothing);
  CHECK(back.requested.edgeLength == s.requested.edgeLength);
  CHECK(back.requested.direction == s.requested.direction);
  CHECK(back.requested.balloon == s.requested.balloon);
  CHECK(back.requested.curvature == s.requested.curvature);
  CHECK(back.requested.maxIterations == s.requested.maxIterations);
  CHECK(back.requested.threads == s.requested.threads);
  CHECK(back.space == s.space);
  CHECK(back.polish == s.polish);
  CHECK(back.constraints == s.constraints);
  REQUIRE(back.changes.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(back.changes[i].constraints == s.changes[i].constraints);
    CHECK(back.changes[i].iteration == s.changes[i].iteration);
    CHECK(back.changes[i].parameters == s.changes[i].parameters);
    CHECK(back.changes[i].seeds == s.changes[i].seeds);
  }
  CHECK(back.stopAt == s.stopAt);
  CHECK(back.view == s.view);
}

TEST_CASE("a session without changes, last iteration and view is that of earlier versions", "[session]") {
  nlohmann::json json = validJson();
  json["requested"].erase("changes");
  json["requested"].erase("stop_at");
  json.erase("view");
  const TempFolder folder;
  test::writeBytes(folder / "s.json", json.dump());
  const Session back = readSession(folder / "s.json");
  CHECK(back.changes.empty());
  CHECK_FALSE(back.stopAt.has_value());
  CHECK(back.view.empty());
}

TEST_CASE("a session whose changes have no seeds is that of earlier versions: the seeds stay", "[session]") {
  nlohmann::json json = validJson();
  json["requested"]["changes"][1].erase("seeds");
  const TempFolder folder;
  test::writeBytes(folder / "s.json", json.dump());
  const Session back = readSession(folder / "s.json");
  REQUIRE(back.changes.size() == 4);
  CHECK_FALSE(back.changes[1].seeds.has_value());
  CHECK(changed({back.seeds, back.requested}, back.changes[1]).seeds == back.seeds);
}

TEST_CASE("a session without candidate and side of its seeds is that of earlier versions", "[session]") {
  nlohmann::json json = validJson();
  json["requested"].erase("candidate");
  json["requested"]["changes"][0].erase("candidate");
  for (auto& seed : json["requested"]["seeds"]) seed.erase("background");
  const TempFolder folder;
  test::writeBytes(folder / "s.json", json.dump());
  const Session back = readSession(folder / "s.json");
  CHECK(back.requested.candidate == 1);
  CHECK(back.changes[0].parameters.candidate == 1);
  REQUIRE(back.seeds.size() == 3);
  CHECK(seedsOfSide(back.seeds, false).size() == 3);
}

TEST_CASE("a session of the first candidate without background clicks is written as by earlier versions",
          "[session]") {
  const TempFolder folder;
  Session s;
  s.version = "1.2.3";
  s.volume = {folder / "v.mha", "00ff", {}};
  s.seeds = {{{1, 2, 3}, 4.0}, {{5, 6, 7}, {}}};
  s.requested.resolution = Resolution::uniform;  // the only one there was
  s.resolved = ResolvedParameters{};
  s.resolved->range = {-kInfinity, 8};
  s.resolved->seeds = {{{1, 2, 3}, 3.5}};
  writeSession(s, folder / "s.json");
  CHECK(test::readBytes(folder / "s.json") == R"({
  "version": "1.2.3",
  "notice": "For research use only; not a medical device.",
  "input": {
    "path": "v.mha",
    "sha256": "00ff"
  },
  "requested": {
    "object": "auto",
    "range": null,
    "smoothing": null,
    "edge_length": null,
    "direction": "outward",
    "balloon": 1.0,
    "curvature": 0.2,
    "max_iterations": 3000,
    "threads": 1,
    "seeds": [
      {
        "centre": [1.0,2.0,3.0],
        "radius": 4.0
      },
      {
        "centre": [5.0,6.0,7.0],
        "radius": null
      }
    ],
    "space": "LPS"
  },
  "parameters": {
    "object": "dark",
    "range": ["-inf",8.0],
    "smoothing": 0.0,
    "edge_length": 0.0,
    "direction": "outward",
    "balloon": 1.0,
    "curvature": 0.2,
    "max_iterations": 3000,
    "threads": 1
  },
  "seeds": [
    {
      "centre": [1.0,2.0,3.0],
      "radius": 3.5
    }
  ]
}
)");
}

TEST_CASE("where the surface starts is not where the background was clicked", "[session]") {
  const std::vector<Seed> seeds{
      {{1, 0, 0}, {}}, {{2, 0, 0}, {}, true}, {{3, 0, 0}, 1.0}, {{4, 0, 0}, 1.0, true}};
  CHECK(seedsOfSide(seeds, false) == std::vector<Seed>{seeds[0], seeds[2]});
  CHECK(seedsOfSide(seeds, true) == std::vector<Seed>{seeds[1], seeds[3]});
}

TEST_CASE("a session may be kept before the hash of its volume is known", "[session]") {
  const TempFolder folder;
  Session s = unusualSession(folder / "v.mha");
  s.volume.sha256.clear();
  writeSession(s, folder / "s.json");
  CHECK(readSession(folder / "s.json").volume.sha256.empty());
}

TEST_CASE("what was left to the image stays open in a session", "[session]") {
  const TempFolder folder;
  Session s;
  s.volume = {folder / "v.mha", "00ff", {}};
  s.seeds = {{{1, 2, 3}, {}}};
  writeSession(s, folder / "s.json");
  const Session back = readSession(folder / "s.json");
  CHECK_FALSE(back.requested.range.has_value());
  CHECK_FALSE(back.requested.smoothing.has_value());
  CHECK_FALSE(back.requested.edgeLength.has_value());
  CHECK_FALSE(back.volume.selection.series.has_value());
  CHECK_FALSE(back.volume.selection.frame.has_value());
}

TEST_CASE("a folder with volume and session can be moved", "[session]") {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "a/data");
  test::writeBytes(folder / "a/data/v.mha", "x");
  writeSession(unusualSession(folder / "a/data/v.mha"), folder / "a/s.json");
  std::filesystem::rename(folder / "a", folder / "b");
  CHECK(std::filesystem::exists(readSession(folder / "b/s.json").volume.path));
}

TEST_CASE("a session names a link to a file as that, and finds it", "[session]") {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "store");
  std::filesystem::create_directories(folder / "a");
  test::writeBytes(folder / "store/1234", "x");
  std::filesystem::create_symlink("../store/1234", folder / "a/v.mha");
  std::filesystem::create_directory_symlink("a", folder / "linked");
  writeSession(unusualSession(folder / "linked/v.mha"), folder / "s.json");
  const std::string path = readSession(folder / "s.json").volume.path;
  CHECK(path.ends_with("a/v.mha"));
  CHECK(std::filesystem::exists(path));
}

TEST_CASE("a session that is written to a link lies where that leads to, and names files from there",
          "[session]") {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "deep/er");
  test::writeBytes(folder / "v.mha", "x");
  test::writeBytes(folder / "deep/er/old.json", "{}");
  std::filesystem::create_symlink("deep/er/old.json", folder / "s.json");
  writeSession(unusualSession(folder / "v.mha"), folder / "s.json");
  CHECK(std::filesystem::exists(readSession(folder / "s.json").volume.path));
  CHECK(std::filesystem::is_symlink(folder / "s.json"));
  CHECK(std::filesystem::exists(readSession(folder / "deep/er/old.json").volume.path));
}

TEST_CASE("a session that is opened by a link is looked around where it lies, too", "[session]") {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "a");
  test::writeBytes(folder / "a/v.mha", "x");
  writeSession(unusualSession(folder / "a/v.mha"), folder / "a/s.json");
  std::filesystem::create_symlink("a/s.json", folder / "linked.json");
  CHECK(std::filesystem::exists(readSession(folder / "linked.json").volume.path));
}

TEST_CASE("label maps of walls in corrected frames are named, found and left out as all others are",
          "[session]") {
  const TempFolder folder;
  const std::string path = folder / "patient.mha";
  test::writeBytes(path, "walls");
  const std::string hash = sha256OfPath(path);
  Session s;
  s.version = "1.2.3";
  s.volume = {folder / "v.nii", "00ff", {}};
  s.seeds = {{{1, 2, 3}, {}}};
  const Constraints walled{{{}, WallMap{path, hash, nullptr}}, {}, {}};
  FrameCorrection correction{2, {s.seeds, s.requested, walled}, {{3, s.requested, {}, walled}}, {}};
  s.overTime = OverTimeRequest{};
  s.overTime->corrections = {correction};
  writeSession(s, folder / "s.json");
  CHECK(test::readBytes(folder / "s.json").find(folder.path()) == std::string::npos);
  CHECK(readSession(folder / "s.json").overTime == s.overTime);

  writeSession(anonymous(s), folder / "a.json");
  CHECK(test::readBytes(folder / "a.json").find("patient") == std::string::npos);
  InputPaths inputs{s.volume.path};
  CHECK_THROWS_WITH(readSession(folder / "a.json", inputs), Catch::Matchers::Contains("--walls"));
  inputs.walls = {path};
  CHECK(readSession(folder / "a.json", inputs).overTime == s.overTime);

  OverTimeReport told;
  told.request = *s.overTime;
  const OverTimeReport hidden = anonymous(told);
  REQUIRE(hidden.request.corrections.size() == 1);
  CHECK(hidden.request.corrections[0].request.constraints.walls.map->path.empty());
  CHECK(hidden.request.corrections[0].changes[0].constraints->walls.map->path.empty());
}

TEST_CASE("a session says of a corrected frame that its object has moved there, and names no file for it",
          "[session]") {
  const TempFolder folder;
  Session s;
  s.version = "1.2.3";
  s.volume = {folder / "v.nii", "00ff", {}};
  s.seeds = {{{1, 2, 3}, {}}};
  s.overTime = OverTimeRequest{};
  s.overTime->corrections = {{2, {s.seeds, s.requested, {}}, {}, {}, true},
                             {3, {s.seeds, s.requested, {}}, {}, {}, false}};
  writeSession(s, folder / "s.json");
  CHECK(readSession(folder / "s.json").overTime == s.overTime);
  std::string text = test::readBytes(folder / "s.json");
  const std::string key = "\"moved_object\": true";
  REQUIRE(text.find(key) != std::string::npos);
  CHECK(text.find(key) == text.rfind(key));
  test::writeBytes(folder / "bad.json", text.replace(text.find(key), key.size(), "\"moved_object\": 1"));
  CHECK_THROWS_WITH(readSession(folder / "bad.json"), Catch::Matchers::Contains("moved_object"));
}

TEST_CASE("files that anonymous sessions do not name are asked for in turn, and known by their hashes",
          "[session]") {
  const TempFolder folder;
  const std::vector<std::string> names{"DOE.mha", "DOE_walls.mha", "DOE_a.stl", "DOE_b.stl"};
  for (const std::string& name : names) test::writeBytes(folder / name, name);
  test::writeBytes(folder / "another", "another");
  std::vector<Session> sessions(2);
  for (std::size_t i = 0; i < 2; ++i) {
    Session& s = sessions[i];
    s.version = "1.2.3";
    s.volume = {folder / names[0], sha256OfPath(folder / names[0]), {}};
    s.constraints.walls.map = WallMap{folder / names[1], sha256OfPath(folder / names[1]), nullptr};
    s.constraints.start.emplace();
    s.constraints.start->path = folder / names[2 + i];
    s.constraints.start->sha256 = sha256OfPath(s.constraints.start->path);
    s = anonymous(std::move(s));
  }
  writeSessions(sessions, folder / "s.json");
  CHECK(test::readBytes(folder / "s.json").find("DOE") == std::string::npos);
  CHECK_THROWS_WITH(readSessions(folder / "s.json"),
                    Catch::Matchers::Contains("s.json: it names no volume") &&
                        Catch::Matchers::Contains("replay --volume"));

  InputPaths later;
  later.mayBeUnnamed = true;
  std::vector<Session> back = readSessions(folder / "s.json", later);
  for (const std::string& name : names) {
    const auto file = unnamedFile(back);
    REQUIRE(file);
    for (const char* other : {"another", "missing"})
      CHECK_THROWS_AS(nameFile(back, *file, folder / other), InputError);
    nameFile(back, *file, folder / name);
  }
  CHECK_FALSE(unnamedFile(back));
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(back[i].volume.path == folder / names[0]);
    CHECK(back[i].constraints.walls.map->path == folder / names[1]);
    CHECK(back[i].constraints.start->path == folder / names[2 + i]);
  }
}

TEST_CASE("files given together are known by their hashes, in any order", "[session]") {
  const TempFolder folder;
  for (const char* name : {"v.mha", "a.stl", "b.stl", "other"}) test::writeBytes(folder / name, name);
  std::vector<Session> sessions(2);
  for (std::size_t i = 0; i < 2; ++i) {
    Session& s = sessions[i];
    s.version = "1.2.3";
    s.volume = {folder / "v.mha", sha256OfPath(folder / "v.mha"), {}};
    s.constraints.start.emplace();
    s.constraints.start->path = folder / (i == 0 ? "a.stl" : "b.stl");
    s.constraints.start->sha256 = sha256OfPath(s.constraints.start->path);
    s = anonymous(std::move(s));
  }
  writeSessions(sessions, folder / "s.json");
  const auto read = [&](const std::vector<std::string>& names) {
    InputPaths inputs;
    inputs.volume = folder / "v.mha";
    for (const std::string& name : names) inputs.starts.push_back(folder / name);
    return readSessions(folder / "s.json", inputs);
  };
  for (const auto& names : {std::vector<std::string>{"a.stl", "b.stl"}, {"b.stl", "a.stl"}}) {
    const std::vector<Session> back = read(names);
    CHECK(back[0].constraints.start->path == folder / "a.stl");
    CHECK(back[1].constraints.start->path == folder / "b.stl");
  }
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(read({"a.stl"}), Contains("s.json: ") && Contains("--start"));
  CHECK_THROWS_WITH(read({"a.stl", "b.stl", "other"}),
                    Contains("other is not the file") && Contains("SHA-256"));
  CHECK_THROWS_AS(read({"a.stl", "missing"}), InputError);

  // Without a hash any file will do, but only one.
  for (Session& s : sessions) s.constraints.start->sha256.clear();
  writeSessions(sessions, folder / "s.json");
  for (const Session& s : read({"other"})) CHECK(s.constraints.start->path == folder / "other");
  CHECK_THROWS_WITH(read({"other", "a.stl"}), Contains("a.stl: ") && Contains("other"));
}

TEST_CASE("an object that is called after its file has another name where the patient is not to be named",
          "[session]") {
  using Names = std::vector<std::string>;
  const std::string file = "/scans/DOE_JANE.nii.gz";
  CHECK(anonymousNames({{"DOE_JANE", file}, {"DOE_JANE 3", file}, {"DOE_JANE (2)", file}}) ==
        Names{"Object 1", "Object 2", "Object 3"});
  // What somebody has typed stays, and is nobody else's name.
  CHECK(anonymousNames({{"Object 2", ""}, {"DOE_JANE", file}, {"Liver", "L.stl"}, {"Aorta", file}}) ==
        Names{"Object 2", "Object 3", "Liver", "Aorta"});

  std::vector<Session> sessions(2);
  sessions[0].label.name = "DOE_JANE";
  sessions[0].constraints.start.emplace();
  sessions[0].constraints.start->path = file;
  hideFileNames(sessions);
  CHECK(sessions[0].label.name == "Object 1");
  CHECK(sessions[1].label == ObjectLabel{});
}
