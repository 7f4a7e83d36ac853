// --start and --given: surfaces that are there before anything has grown.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "core/collision/body_contact.h"
#include "core/collision/certify.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/file_labels.h"
#include "core/io/formats/label_map.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/meshes/three_mf.h"
#include "core/mesh/shapes.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/io/overlapping_segments.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using namespace handlebody::testing;
using namespace handlebody::test;

namespace {

const Vec3 kMiddle(20, 20, 20);
constexpr double kRadius = 10;

//! A dark ball of 10 mm in 41³ voxels of 1 mm.
std::string ballVolume(const TempFolder& folder) {
  const Volume volume = volumeByIndex(cubicGrid(41), [](int i, int j, int k) {
    const double in = std::clamp(kRadius + 0.5 - (Vec3(i, j, k) - kMiddle).norm(), 0.0, 1.0);
    return 200 - 180 * in + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  });
  writeVolume(volume, folder / "v.nrrd");
  return folder / "v.nrrd";
}

std::string ballMesh(const TempFolder& folder, const char* name, double radius, double edge = 1.5,
                     const Vec3& centre = kMiddle) {
  writeMesh(icosphere(centre, radius, edge), folder / name);
  return folder / name;
}

//! Label 1: the half of a ball below its middle, 2: the other half, 3: a small ball in that.
std::string halves(const TempFolder& folder) {
  const Volume labels = volumeByIndex(cubicGrid(41), [](int i, int j, int k) {
    const Vec3 p(i, j, k);
    if ((p - Vec3(20, 20, 25)).norm() < 2.5) return 3.0;
    if ((p - kMiddle).norm() > 12) return 0.0;
    return k <= 20 ? 1.0 : 2.0;
  });
  writeVolume(labels, folder / "labels.nrrd");
  return folder / "labels.nrrd";
}

double volumeOf(const std::string& mesh) { return certify(readMesh(mesh)).volume; }

std::vector<int> valuesOf(const std::string& path) {
  std::vector<int> values;
  const Volume labels = readVolume(path);
  visitVoxels(labels, [&](const auto* v) {
    for (std::size_t i = 0; i < labels.grid.voxelCount(); ++i) values.push_back(static_cast<int>(v[i]));
  });
  return values;
}

std::string bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void require(const std::vector<std::string>& arguments) {
  const Outcome outcome = runCli(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
}

}  // namespace

TEST_CASE("a start within the object grows to it, one around it gives ground, and both end where a seed does",
          "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder);
  require({"segment", volume, "--seed", "20,20,20,3", "-o", folder / "seed.stl"});
  const double meant = volumeOf(folder / "seed.stl");
  const std::string small = ballMesh(folder, "small.stl", 5), large = ballMesh(folder, "large.ply", 13);
  require({"segment", volume, "--start", small, "-o", folder / "grown.stl"});
  CHECK(volumeOf(folder / "grown.stl") == Approx(meant).epsilon(0.02));
  require({"segment", volume, "--start", large, "--direction", "both", "-o", folder / "shrunk.stl"});
  CHECK(volumeOf(folder / "shrunk.stl") == Approx(meant).epsilon(0.02));
  SECTION("also from a label map, and from a mesh of a few long edges") {
    const std::string labels = halves(folder);
    require({"segment", volume, "--start", labels, "--direction", "both", "-o", folder / "labels.stl"});
    CHECK(volumeOf(folder / "labels.stl") == Approx(meant).epsilon(0.02));
    const std::string coarse = ballMesh(folder, "coarse.obj", 9, 20);
    require({"segment", volume, "--start", coarse, "--direction", "both", "-o", folder / "coarse.stl"});
    CHECK(volumeOf(folder / "coarse.stl") == Approx(meant).epsilon(0.02));
  }
}

TEST_CASE("a given object is written as it is and is a wall for the next, and a replay makes the same files",
          "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder),
                    given = ballMesh(folder, "given.stl", 5, 1.5, Vec3(27, 20, 20));
  require({"segment",
           volume,
           "--object-name",
           "lesion",
           "--given",
           given,
           "--object-name",
           "organ",
           "--seed",
           "15,20,20,3",
           "-o",
           folder / "all.seg.nrrd",
           "-o",
           "lesion=" + (folder / "lesion.stl"),
           "-o",
           "organ=" + (folder / "organ.vtp"),
           "--session",
           folder / "s.json",
           "--report",
           folder / "r.json"});
  CHECK(readMesh(folder / "lesion.stl").points == readMesh(given).points);
  const TriangleSoup lesion = readMesh(folder / "lesion.stl"), organ = readMesh(folder / "organ.vtp");
  CHECK(bodyContact(lesion, organ) == BodyContact::none);
  CHECK(certify(organ).volume < 4.0 / 3 * 3.1416 * kRadius * kRadius * kRadius - 300);
  const auto report = nlohmann::json::parse(bytes(folder / "r.json"));
  CHECK(report.at("objects")[0].at("stopped") == "given");
  for (const std::string source : {"s.json", "r.json"}) {
    require({"replay", folder / source, "-o", folder / "again.seg.nrrd", "-o",
             "organ=" + (folder / "again.vtp")});
    CHECK(bytes(folder / "again.seg.nrrd") == bytes(folder / "all.seg.nrrd"));
    CHECK(bytes(folder / "again.vtp") == bytes(folder / "organ.vtp"));
  }
}

TEST_CASE("a start is replayed bit for bit, and another file in its place is refused", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), start = ballMesh(folder, "start.stl", 13);
  require({"segment", volume, "--start", start, "--direction", "both", "-o", folder / "a.stl", "--session",
           folder / "s.json", "--threads", "2"});
  require({"replay", folder / "s.json", "-o", folder / "b.stl"});
  CHECK(bytes(folder / "a.stl") == bytes(folder / "b.stl"));
  ballMesh(folder, "start.stl", 12);
  requireRefusal(folder, {"replay", folder / "s.json", "-o", folder / "c.stl"}, 3, "SHA-256");
  SECTION("an anonymous session is told where it is") {
    ballMesh(folder, "start.stl", 13);
    require({"segment", volume, "--start", start, "--direction", "both", "-o", folder / "a.stl", "--session",
             folder / "n.json", "--anonymous"});
    CHECK(bytes(folder / "n.json").find("start.stl") == std::string::npos);
    requireRefusal(folder, {"replay", folder / "n.json", "--volume", volume, "-o", folder / "c.stl"}, 3,
                   "replay --start");
    require({"replay", folder / "n.json", "--volume", volume, "--start", start, "-o", folder / "d.stl"});
    CHECK(bytes(folder / "a.stl") == bytes(folder / "d.stl"));
  }
}

TEST_CASE("a mesh that is inside out is turned, and one whose parts disagree is refused", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder);
  TriangleSoup mesh = icosphere(kMiddle, 5, 1.5);
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  writeMesh(mesh, folder / "turned.stl");
  REQUIRE(volumeOf(folder / "turned.stl") < 0);
  require({"segment", volume, "--given", folder / "turned.stl", "-o", folder / "given.stl"});
  CHECK(volumeOf(folder / "given.stl") == Approx(-volumeOf(folder / "turned.stl")));
  require({"segment", volume, "--start", folder / "turned.stl", "-o", folder / "grown.stl"});
  CHECK(volumeOf(folder / "grown.stl") > volumeOf(folder / "given.stl"));
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  writeMesh(mesh, folder / "mixed.stl");
  requireRefusal(folder, {"segment", volume, "--given", folder / "mixed.stl", "-o", folder / "no.stl"}, 3,
                 "not oriented alike");
}

TEST_CASE("an anonymous session of several starts is told all of them, in any order", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder);
  const std::string one = ballMesh(folder, "one.stl", 3, 1.5, kMiddle - Vec3(5, 0, 0)),
                    two = ballMesh(folder, "two.stl", 3, 1.5, kMiddle + Vec3(5, 0, 0)),
                    third = ballMesh(folder, "third.stl", 2);
  require({"segment", volume, "--object-name", "left", "--given", one, "--object-name", "right", "--given",
           two, "-o", folder / "a.nrrd", "--session", folder / "n.json", "--anonymous"});
  const auto replay = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"replay", folder / "n.json", "--volume", volume, "-o", folder / "b.nrrd"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  requireRefusal(folder, replay({"--start", one}), 3, "replay --start");
  requireRefusal(folder, replay({"--start", one, "--start", two, "--start", third}), 3, "third.stl");
  requireRefusal(folder, replay({"--start", one, "--start", two, "--walls", third}), 3, "has no walls");
  for (const auto& [first, second] : {std::pair(one, two), std::pair(two, one)}) {
    require(replay({"--start", first, "--start", second}));
    CHECK(bytes(folder / "b.nrrd") == bytes(folder / "a.nrrd"));
  }
}

TEST_CASE("a session that names no files is measured when it is told them", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), given = ballMesh(folder, "given.stl", 6);
  require({"segment", volume, "--given", given, "-o", folder / "a.stl", "--session", folder / "n.json",
           "--anonymous"});
  std::vector<std::string> measure{"measure", folder / "n.json", "--volume",
                                   volume,    "--json",          folder / "m.json"};
  requireRefusal(folder, measure, 3, "--start");
  measure.insert(measure.end(), {"--start", given});
  require(measure);
  const auto json = nlohmann::json::parse(bytes(folder / "m.json"));
  CHECK(json.at("objects").at(0).at("measures").at("volume_mm3").get<double>() ==
        Approx(volumeOf(given)).epsilon(1e-6));
  requireRefusal(folder, {"measure", given, "--start", given}, 2, "--start");
  requireRefusal(folder, {"measure", folder / "n.json", "--volume", volume, "--start", given, "--csv", given},
                 2, "given.stl");
}

TEST_CASE("a start is known by the hash of its header alone, as earlier sessions have it", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), labels = halves(folder);
  writeBytes(folder / "labels.raw", "");
  const Volume voxels = readVolume(labels);
  visitVoxels(voxels, [&](const auto* v) {
    std::string raw;
    for (std::size_t i = 0; i < voxels.grid.voxelCount(); ++i) raw += static_cast<char>(v[i]);
    writeBytes(folder / "labels.raw", raw);
  });
  writeBytes(folder / "labels.nhdr",
             "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 41 41 41\n"
             "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n"
             "data file: labels.raw\n");
  require({"segment", volume, "--given", folder / "labels.nhdr", "--start-label", "1", "-o", folder / "a.stl",
           "--session", folder / "s.json"});
  auto json = nlohmann::json::parse(bytes(folder / "s.json"));
  json["requested"]["constraints"]["start"]["sha256"] = hashOfPath(folder / "labels.nhdr").header;
  writeBytes(folder / "s.json", json.dump());
  require({"replay", folder / "s.json", "-o", folder / "b.stl"});
  CHECK(bytes(folder / "b.stl") == bytes(folder / "a.stl"));
  json["requested"]["constraints"]["start"]["sha256"] = std::string(64, '0');
  writeBytes(folder / "s.json", json.dump());
  requireRefusal(folder, {"replay", folder / "s.json", "-o", folder / "b.stl"}, 3, "labels.nhdr");
}

TEST_CASE("the labels of a map become objects that do not meet, one within another too", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), labels = halves(folder);
  std::vector<std::string> arguments{"segment", volume};
  for (const std::string label : {"1", "2", "3"})
    for (const std::string& word : {std::string("--object-name"), "part" + label, std::string("--given"),
                                    labels, std::string("--start-label"), label, std::string("-o"),
                                    "part" + label + "=" + (folder / ("part" + label + ".stl"))})
      arguments.push_back(word);
  for (const std::string& word :
       {std::string("-o"), folder / "all.nrrd", std::string("--session"), folder / "s.json"})
    arguments.push_back(word);
  require(arguments);
  std::vector<TriangleSoup> parts;
  for (const std::string label : {"1", "2", "3"})
    parts.push_back(readMesh(folder / ("part" + label + ".stl")));
  CHECK(bodyContact(parts[0], parts[1]) == BodyContact::none);
  CHECK(bodyContact(parts[1], parts[2]) == BodyContact::none);
  CHECK(certify(parts[1]).cavities == 1);
  const std::vector<int> before = valuesOf(labels), after = valuesOf(folder / "all.nrrd");
  double changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) changed += before[i] != after[i];
  // A gap of a fifth of a voxel, and what smoothing rounds off.
  double area = 0;
  for (const TriangleSoup& part : parts) area += certify(part).area;
  CHECK(changed < 0.2 * area);
  require({"replay", folder / "s.json", "-o", folder / "again.nrrd"});
  CHECK(bytes(folder / "again.nrrd") == bytes(folder / "all.nrrd"));
}

TEST_CASE("a given segment is called, coloured and termed as in its file, unless it is said otherwise",
          "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), all = folder / "all.seg.nrrd", out = folder / "out.seg.nrrd";
  const std::vector<ExportedObject> objects{
      {{"Left kidney", {17, 200, 33}, 3, "kidney"}, icosphere(Vec3(12, 20, 20), 4, 1)},
      {{"Some cyst", {250, 5, 128}, 9, "cyst"}, icosphere(Vec3(28, 20, 20), 4, 1)}};
  writeSlicerSegmentation(labelMap(objects, cubicGrid(41)), objects, all);
  const auto given = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"segment", volume, "--given", all, "--start-label", "9", "-o", out});
    require(more);
    const FileLabels said = readSlicerLabels(out);
    REQUIRE(said.size() == 1);
    return said.begin()->second;
  };
  const FileLabel asThere = given({});
  CHECK(asThere.name == "Some cyst");
  CHECK(asThere.colour == Colour{250, 5, 128});
  CHECK(asThere.term == "cyst");
  const FileLabel named = given({"--object-name", "Mine", "--color", "1,2,3"});
  CHECK(named.name == "Mine");
  CHECK(named.colour == Colour{1, 2, 3});
  CHECK(named.term == "cyst");
  CHECK(given({"--term", "liver"}).colour == termFromName("liver")->colour);
  const FileLabel anonymous = given({"--anonymous"});
  CHECK(anonymous.name == "Object");
  CHECK(anonymous.term == "cyst");
  SECTION("also where several are named") {
    require({"segment", volume, "--given", all, "--object-name", "A", "--start-label", "3", "--object-name",
             "B", "--start-label", "9", "--term", "mass", "-o", out});
    const FileLabels said = readSlicerLabels(out);
    REQUIRE(said.size() == 2);
    CHECK(said.at(1).name == "A");
    CHECK(said.at(1).colour == Colour{17, 200, 33});
    CHECK(said.at(1).term == "kidney");
    CHECK(said.at(2).term == "mass");
    CHECK(said.at(2).colour == termFromName("mass")->colour);
  }
}

TEST_CASE(
    "a given segment keeps codes that are not ours and how it was made, until it grows or is termed anew",
    "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), source = folder / "s.seg.dcm", out = folder / "out.seg.nrrd";
  const Terminology kidney{{"T-D000A", "SRT", "Anatomical Structure"},
                           {{"T-71000", "SRT", "Kidney"}, {{"G-A101", "SRT", "Left"}}},
                           {{"818983003", "SCT", "Abdomen"}, {}}};
  const std::vector<ExportedObject> objects{
      {{"One", {17, 200, 33}, 1, "tissue", {kidney, SegmentAlgorithm{AlgorithmType::automatic, "Net of X"}}},
       icosphere(kMiddle, 6, 1)}};
  DicomOrigin origin;
  origin.straight = false;
  writeDicomSegmentation(labelMap(objects, cubicGrid(41)), objects, origin, {}, source);
  const auto made = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"-o", out});
    require(more);
    return readSlicerLabels(out).at(1).source;
  };
  const auto given = [&](std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"segment", volume, "--given", source, "--session", folder / "s.json"});
    return made(more);
  };
  const SegmentSource kept{kidney, SegmentAlgorithm{AlgorithmType::automatic, "Net of X, Handlebody"}};
  CHECK(given() == kept);
  CHECK(made({"replay", folder / "s.json"}) == kept);
  CHECK_FALSE(made({"replay", folder / "s.json", "--term", "liver"}).terminology);
  const SegmentSource anonymous{kidney, SegmentAlgorithm{AlgorithmType::automatic, "Handlebody"}};
  CHECK(made({"replay", folder / "s.json", "--anonymous"}) == anonymous);
  CHECK(given({"--anonymous"}) == anonymous);
  CHECK(bytes(folder / "s.json").find("Net of X") == std::string::npos);
  CHECK_FALSE(given({"--term", "liver"}).terminology);
  CHECK(given({"--term", "liver"}).algorithm == kept.algorithm);
  const SegmentSource grown = made({"segment", volume, "--start", source});
  CHECK(grown.terminology == kidney);
  CHECK_FALSE(grown.algorithm);  // in .seg.dcm SEMIAUTOMATIC
  SECTION("info tells the codes") {
    CHECK_THAT(runCli({"info", source}).out, Contains("label 1: One (SRT T-71000: Kidney, Left; Abdomen)"));
    const auto told = runForJson({"info", source, "--json"}).at("labels").at(0);
    CHECK(told.at("term") == "");
    CHECK(told.at("terminology").at("type").at("modifiers").at(0).at("value") == "G-A101");
    CHECK(told.at("algorithm").at("type") == "AUTOMATIC");
  }
}

TEST_CASE("given segments that overlap do not meet: what they share is the smaller one's, and it is told",
          "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder);
  const std::vector<test::Segment> segments{{"organ", "1 0 0", inBall(kMiddle, 11)},
                                            {"lesion", "0 1 0", inBall(Vec3(27, 20, 20), 6)}};
  writeLayers(segments, cubicGrid(41), folder / "l.seg.nrrd");
  writeOverlappingDicom(segments, cubicGrid(41), folder / "l.seg.dcm");
  std::size_t organ = 0, shared = 0;
  forEachVoxel(cubicGrid(41), [&](const Vec3& index) {
    organ += segments[0].holds(index);
    shared += segments[0].holds(index) && segments[1].holds(index);
  });
  for (const std::string name : {"l.seg.nrrd", "l.seg.dcm"}) {
    INFO(name);
    const auto given = [&](const std::string& label) {
      return std::vector<std::string>{"--object-name", label,           "--given",
                                      folder / name,   "--start-label", label};
    };
    std::vector<std::string> all{"segment", volume};
    for (const char* label : {"organ", "lesion"})
      for (const std::string& word : given(label)) all.push_back(word);
    for (const std::string& word :
         {std::string("-o"), "organ=" + (folder / "o.stl"), std::string("-o"), "lesion=" + (folder / "l.stl"),
          std::string("--session"), folder / "s.json", std::string("--report"), folder / "r.json"})
      all.push_back(word);
    require(all);
    const TriangleSoup first = readMesh(folder / "o.stl"), second = readMesh(folder / "l.stl");
    CHECK(bodyContact(first, second) == BodyContact::none);
    CHECK(certify(first).volume == Approx(static_cast<double>(organ - shared)).epsilon(0.03));
    const auto report = nlohmann::json::parse(bytes(folder / "r.json"));
    const std::string told = "overlap: " + std::to_string(shared) + " voxels";
    CHECK_THAT(report.at("objects").at(0).at("warnings").dump(), Contains(told));
    CHECK_THAT(report.at("objects").at(1).at("warnings").dump(), !Contains("overlap"));
    require({"replay", folder / "s.json", "-o", "organ=" + (folder / "again.stl")});
    CHECK(bytes(folder / "again.stl") == bytes(folder / "o.stl"));
    // Alone it is whole.
    require({"segment", volume, "--given", folder / name, "--start-label", "organ", "-o", folder / "o.stl"});
    CHECK(volumeOf(folder / "o.stl") == Approx(static_cast<double>(organ)).epsilon(0.02));
  }
  SECTION("nothing is left of one that another covers") {
    const std::vector<test::Segment> twice{{"a", "1 0 0", inBall(kMiddle, 8)},
                                           {"b", "0 1 0", inBall(kMiddle, 8)}};
    writeLayers(twice, cubicGrid(41), folder / "t.seg.nrrd");
    requireRefusal(folder,
                   {"segment", volume, "--given", folder / "t.seg.nrrd", "--object-name", "a",
                    "--start-label", "a", "--object-name", "b", "--start-label", "b", "-o", folder / "x.vtp"},
                   3, "no voxel of the label 1 that no smaller label holds");
  }
}

TEST_CASE(
    "how the surface of a given label is made is chosen, kept in the session, and refused where it cannot be",
    "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), labels = folder / "l.nrrd";
  // A ring, and a small ball apart from it.
  writeVolume(volumeByIndex(cubicGrid(41),
                            [](int i, int j, int k) {
                              const double along = std::hypot(i - 20.0, j - 20.0) - 7;
                              return std::hypot(along, k - 20.0) < 3.5 ||
                                     (Vec3(i, j, k) - Vec3(20, 20, 33)).norm() < 3;
                            }),
              labels);
  const auto made = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"segment", volume,           "--given",   labels,
                                 "-o",      folder / "m.stl", "--session", folder / "s.json"};
    all.insert(all.end(), more.begin(), more.end());
    require(all);
    const std::string mesh = bytes(folder / "m.stl");
    require({"replay", folder / "s.json", "-o", folder / "again.stl"});
    CHECK(bytes(folder / "again.stl") == mesh);
    return certify(readMesh(folder / "m.stl"));
  };
  const Certificate plain = made({});
  CHECK(plain.components == 2);
  CHECK(made({"--start-keep-largest", "on"}).components == 1);
  CHECK(made({"--start-keep-largest", "on", "--start-genus", "0"}).genus == std::vector<int>{0});
  const Certificate steps = made({"--start-smooth", "0"});
  CHECK(steps.area > 1.03 * plain.area);
  const auto refuse = [&](std::vector<std::string> more, int code, const std::string& named) {
    more.insert(more.begin(), {"segment", volume, "-o", folder / "x.stl"});
    requireRefusal(folder, more, code, named);
  };
  refuse({"--given", labels, "--start-smooth", "-1"}, 2, "--start-smooth");
  refuse({"--given", labels, "--start-genus", "-1"}, 2, "--start-genus");
  refuse({"--given", labels, "--start-keep-largest", "yes"}, 2, "--start-keep-largest");
  refuse({"--start-smooth", "1", "--seed", "20,20,20"}, 2, "--start-smooth");
}

TEST_CASE("an encapsulated STL is given, checked, compared and measured as any mesh", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), stl = ballMesh(folder, "m.stl", 6),
                    dicom = folder / "m.stl.dcm";
  writeDicomStl({{{}, readMesh(stl)}}, {}, {}, dicom);
  require({"check", dicom});
  require({"measure", dicom, "--csv", folder / "m.csv"});
  require({"edit", dicom, "--keep-largest", "-o", folder / "edited.stl"});
  require({"segment", volume, "--given", dicom, "-o", folder / "given.stl"});
  CHECK(readMesh(folder / "given.stl").points == readMesh(stl).points);
  const auto same = runForJson({"compare", dicom, stl, "--json"});
  CHECK(same.at("a").at("kind") == "mesh");
  CHECK(same.at("distances").at("hausdorff_mm") < 1e-9);
  requireRefusal(folder, {"check", folder / "none.stl.dcm"}, 3, "none.stl.dcm");
  requireRefusal(folder, {"edit", stl, "--keep-largest", "-o", folder / "out.stl.dcm"}, 2, "a mesh is");
}

TEST_CASE("a 3MF file is given, checked, compared, measured and edited as any mesh", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), stl = ballMesh(folder, "m.stl", 6), print = folder / "m.3mf";
  writeThreeMf({{{}, readMesh(stl)}}, print, CoordinateSpace::ras);
  require({"check", print});
  require({"measure", print, "--csv", folder / "m.csv"});
  require({"edit", print, "--keep-largest", "-o", folder / "edited.3mf"});
  require({"segment", volume, "--given", print, "-o", folder / "given.stl"});
  CHECK(readMesh(folder / "given.stl").points == readMesh(stl).points);
  CHECK(readMesh(folder / "edited.3mf").points.size() == readMesh(stl).points.size());
  const auto same = runForJson({"compare", print, stl, "--json"});
  CHECK(same.at("a").at("kind") == "mesh");
  CHECK(same.at("distances").at("hausdorff_mm") < 1e-9);
  requireRefusal(folder, {"check", folder / "none.3mf"}, 3, "none.3mf");
}

TEST_CASE(
    "an encapsulated STL as a PACS names it is given, checked, compared and measured as one called .stl.dcm",
    "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), stl = ballMesh(folder, "m.stl", 6),
                    plain = folder / "m.stl.dcm", dicom = folder / GENERATE("IM0001.dcm", "IM0001");
  writeDicomStl({{{}, readMesh(stl)}}, {}, {}, plain);
  std::filesystem::copy_file(plain, dicom);
  require({"check", dicom});
  require({"measure", dicom, "--csv", folder / "m.csv"});
  require({"edit", dicom, "--keep-largest", "-o", folder / "edited.stl"});
  const auto same = runForJson({"compare", dicom, plain, "--json"});
  CHECK(same.at("a").at("kind") == "mesh");
  CHECK(same.at("distances").at("hausdorff_mm") < 1e-9);
  requireRefusal(folder, {"compare", dicom, stl, "--label-a", "1"}, 2, "is a mesh");
  require({"segment", volume, "--given", dicom, "-o", folder / "given.stl", "--session", folder / "s.json"});
  CHECK(readMesh(folder / "given.stl").points == readMesh(stl).points);
  require({"replay", folder / "s.json", "-o", folder / "again.stl"});
  CHECK(bytes(folder / "again.stl") == bytes(folder / "given.stl"));
}

TEST_CASE("a DICOM Segmentation as a PACS names it is a label map and no mesh", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), dicom = folder / "IM0001";
  writeOverlappingDicom({{"Ball", {}, inBall(kMiddle, 6)}}, cubicGrid(41), folder / "l.seg.dcm");
  std::filesystem::rename(folder / "l.seg.dcm", dicom);
  require({"segment", volume, "--given", dicom, "--start-label", "Ball", "-o", folder / "given.stl"});
  CHECK(volumeOf(folder / "given.stl") == Approx(4. / 3 * std::numbers::pi * 216).epsilon(0.1));
  CHECK(runForJson({"compare", dicom, folder / "given.stl", "--json"}).at("a").at("kind") == "label map");
  requireRefusal(folder, {"check", dicom}, 3, "not a mesh");
}

TEST_CASE("what cannot be a start is refused with its file and why", "[cli][start]") {
  const TempFolder folder;
  const std::string volume = ballVolume(folder), labels = halves(folder);
  TriangleSoup open = icosphere(kMiddle, 5, 1.5);
  open.triangles.pop_back();
  writeMesh(open, folder / "open.ply");
  TriangleSoup crossing = icosphere(kMiddle, 5, 1.5);
  crossing.points[0] = 2 * kMiddle - crossing.points[0] - Vec3(0.1, 3, 3);
  writeMesh(crossing, folder / "crossing.ply");
  const std::string ball = ballMesh(folder, "ball.stl", 5),
                    far = ballMesh(folder, "far.stl", 5, 1.5, Vec3(200, 20, 20));
  const auto refuse = [&](std::vector<std::string> more, int code, const std::string& named) {
    more.insert(more.begin(), {"segment", volume, "-o", folder / "x.stl"});
    requireRefusal(folder, more, code, named);
  };
  refuse({"--start", folder / "open.ply"}, 3, "open.ply cannot be a surface to begin with: it is not closed");
  refuse({"--given", folder / "crossing.ply"}, 3, "intersects itself");
  refuse({"--start", folder / "none.stl"}, 3, "none.stl");
  refuse({"--start", labels, "--start-label", "7"}, 3, "no voxel of the value 7");
  refuse({"--start", ball, "--start-label", "1"}, 3, "has no labels");
  refuse({"--start", far}, 2, "far.stl, lies outside of the volume");
  refuse({"--start", ball, "--given", ball}, 2, "not both");
  refuse({"--start-label", "1", "--seed", "20,20,20"}, 2, "--start-label");
  refuse({"--object-name", "a", "--given", ball, "--object-name", "b", "--given", ball}, 2, "'a'");
}
