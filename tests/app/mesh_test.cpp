// mesh, through the program.

#include <algorithm>

#include "core/collision/certify.h"
#include "core/io/dicom/dicom_segments.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/file_labels.h"
#include "core/io/formats/label_map.h"
#include "core/io/formats/sequence_writer.h"
#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/io/overlapping_segments.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody::test;

namespace {

//! Unsigned bytes of a cube of n³ voxels.
template <typename F>
std::string labelCube(int n, F&& value) {
  const std::string size = std::to_string(n);
  std::string bytes =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = " + size +
      " " + size + " " + size +
      "\nElementSpacing = 1 1 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  for (int i = 0; i < n * n * n; ++i) bytes += static_cast<char>(value(i % n, i / n % n, i / (n * n)));
  return bytes;
}

//! Label 1: a block with a hole along z; label 2: two voxels that touch at a corner.
std::string someLabels() {
  return labelCube(16, [](int x, int y, int z) {
    if ((x == 14 && y == 14 && z == 14) || (x == 15 && y == 15 && z == 15)) return 2;
    const bool block = x > 1 && x < 12 && y > 1 && y < 12 && z > 3 && z < 9;
    return block && !(x == 6 && y == 7) ? 1 : 0;
  });
}

//! Balls as a DICOM Segmentation of a patient.
void writeBalls(const std::vector<handlebody::ExportedObject>& balls, const std::string& path) {
  using namespace handlebody;
  Grid grid;
  grid.size = {24, 24, 24};
  DicomOrigin origin;
  origin.values = {{0x10, 0x10, "Doe^Jane"}, {0x08, 0x20, "20221208"}};
  origin.straight = false;
  writeDicomSegmentation(labelMap(balls, grid), balls, origin, {}, path);
}

}  // namespace

TEST_CASE("a label's mesh is certified, with its topology and volume", "[cli][mesh]") {
  const TempFolder folder;
  writeBytes(folder / "l.mha", someLabels());
  const auto one = runForJson({"mesh", folder / "l.mha", "--label", "1", "-o", folder / "a.stl", "-o",
                               folder / "a.nii.gz", "--json"});
  CHECK(one.at("components") == 1);
  CHECK(one.at("genus") == nlohmann::json::array({1}));
  CHECK(one.at("self_intersections") == 0);
  CHECK(one.at("volume_mm3").get<double>() == Approx(2.0 * 99 * 5).epsilon(0.01));
  CHECK(runCli({"check", folder / "a.stl"}).exitCode == 0);
  const auto two = runForJson({"mesh", folder / "l.mha", "--label", "2", "-o", folder / "b.vtp", "--json"});
  CHECK(two.at("components") == 2);  // at a corner: 6-connected voxels do not touch
  CHECK(runForJson({"mesh", folder / "l.mha", "-o", folder / "c.ply", "--json"}).at("components") == 3);
  const auto compared = runForJson(
      {"compare", folder / "a.stl", folder / "l.mha", "--label", "1", "--sampling", "0.3", "--json"});
  CHECK(compared.at("dice") > 0.98);
  CHECK(compared.at("a").at("genus") == compared.at("b").at("genus"));
}

TEST_CASE("a narrow label that is given is as fine as `mesh` makes it", "[cli][mesh]") {
  using namespace handlebody;
  const TempFolder folder;
  Grid grid = testing::cubicGrid(20);
  grid.size = {8, 8, 60};
  grid.spacing = {0.5, 0.5, 3};
  const Volume vessel = testing::volumeByIndex(
      grid, [](int i, int j, int k) { return i == 4 && j == 4 && k >= 5 && k < 55 ? 1.0 : 0.0; });
  writeVolume(vessel, folder / "l.nrrd");
  REQUIRE(runCli({"mesh", folder / "l.nrrd", "-o", folder / "a.stl", "--polish", "off"}).exitCode == 0);
  REQUIRE(runCli({"segment", folder / "l.nrrd", "--given", folder / "l.nrrd", "-o", folder / "b.stl",
                  "--polish", "off"})
              .exitCode == 0);
  const Certificate made = certify(readMesh(folder / "a.stl")), given = certify(readMesh(folder / "b.stl"));
  CHECK(given.volume == made.volume);
  CHECK(given.vertices == made.vertices);
  CHECK(given.volume > 0.75 * 50 * grid.voxelVolume());
}

TEST_CASE("a mesh that has lost much of its voxels' volume, or has other edges than asked for, says so",
          "[cli][mesh]") {
  const TempFolder folder;
  writeBytes(folder / "l.mha", someLabels());
  const auto warned = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"mesh", folder / "l.mha", "-o", folder / "a.stl"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = runCli(all);
    CHECK(outcome.exitCode == 0);
    return outcome.err;
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(warned({"--label", "1"}), !Contains("warning"));
  CHECK_THAT(
      warned({"--label", "2", "--smooth", "0"}),
      Contains("l.mha: The mesh encloses 0.0006667 ml, the voxels that it was made of 0.004 ml (-83 %)"));
  CHECK_THAT(warned({"--label", "1", "--edge-length", "50"}), Contains("not 50 mm as was asked for"));
  const Outcome given =
      runCli({"segment", folder / "l.mha", "--given", folder / "l.mha", "--start-label", "2",
              "--start-smooth", "0", "-o", folder / "b.stl", "--report", folder / "r.json"});
  INFO(given.err);
  REQUIRE(given.exitCode == 0);
  CHECK_THAT(given.err, Contains("The mesh encloses 0.0006667 ml"));
  CHECK_THAT(readBytes(folder / "r.json"), Contains("volume-off-voxels"));
}

TEST_CASE("a time point of a 4D label map is chosen", "[cli][mesh]") {
  using namespace handlebody;
  const TempFolder folder;
  const std::string path = folder / "beat.nii.gz";
  Grid grid;
  grid.size = {20, 20, 20};
  const auto ball = [&grid](double radius) {
    const auto value = [radius](int i, int j, int k) {
      return (Vec3(i, j, k) - Vec3::Constant(9.5)).norm() < radius ? 1 : 0;
    };
    return testing::volumeByIndex(grid, value);
  };
  writeSequence({grid, VoxelType::float32, 2}, path, [&](int frame) { return ball(frame == 0 ? 4 : 7); });
  const auto volume = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all{"mesh", path, "-o", folder / "m.stl", "--json"};
    all.insert(all.end(), options.begin(), options.end());
    return runForJson(all).at("volume_mm3").get<double>();
  };
  CHECK(volume({"--frame", "1"}) > 4 * volume({"--frame", "0"}));
  CHECK(volume({}) == volume({"--frame", "0"}));
  CHECK(runForJson({"mesh", path, "--frame", "1", "-o", folder / "m.stl", "--json"}).at("components") == 1);
  const auto dice = [&](const char* frame) {
    return runForJson({"compare", folder / "m.stl", path, "--frame", frame, "--json"})
        .at("dice")
        .get<double>();
  };
  CHECK(dice("1") > 0.95);
  CHECK(dice("0") < 0.5);
  CHECK(runCli({"mesh", path, "--frame", "2", "-o", folder / "n.stl"}).exitCode == 2);
}

TEST_CASE("the topology is made simpler on request", "[cli][mesh]") {
  const TempFolder folder;
  writeBytes(folder / "l.mha", someLabels());
  const auto mesh = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all{"mesh", folder / "l.mha", "-o", folder / "m.stl", "--json"};
    all.insert(all.end(), options.begin(), options.end());
    return runForJson(all);
  };
  CHECK(mesh({"--keep-largest"}).at("components") == 1);
  const auto filled = mesh({"--keep-largest", "--genus", "0"});
  CHECK(filled.at("genus") == nlohmann::json::array({0}));
  CHECK(filled.at("volume_mm3").get<double>() > 2.0 * 99 * 5);
  const auto steps = mesh({"--label", "1", "--smooth", "0"});
  CHECK(steps.at("genus") == nlohmann::json::array({1}));
  CHECK(mesh({"--label", "1", "--edge-length", "2"}).at("faces") < steps.at("faces"));
}

TEST_CASE("the mesh of a segment is called as there, and that of a DICOM Segmentation can be DICOM, too",
          "[cli][mesh]") {
  using namespace handlebody;
  const TempFolder folder;
  writeBalls({{{"Left kidney", {17, 200, 33}, 1, "kidney"}, icosphere(Vec3(7, 12, 12), 4, 1)},
              {{"Some cyst", {250, 5, 128}, 2, "cyst"}, icosphere(Vec3(17, 12, 12), 4, 1)}},
             folder / "all.seg.dcm");
  const Outcome run = runCli({"mesh", folder / "all.seg.dcm", "--label", "2", "-o", folder / "m.seg.nrrd",
                              "-o", folder / "m.stl.dcm", "-o", folder / "m.seg.dcm"});
  INFO(run.err);
  REQUIRE(run.exitCode == 0);
  const FileLabels said = readSlicerLabels(folder / "m.seg.nrrd");
  REQUIRE(said.size() == 1);
  CHECK(said.at(1).name == "Some cyst");
  CHECK(said.at(1).term == "cyst");
  for (const char* name : {"m.stl.dcm", "m.seg.dcm"})
    CHECK(readBytes(folder / name).find("Doe^Jane") != std::string::npos);
  CHECK(runCli({"check", folder / "m.stl.dcm"}).exitCode == 0);
}

TEST_CASE("the mesh of a segment keeps codes that are not ours, and who made it", "[cli][mesh]") {
  using namespace handlebody;
  const TempFolder folder;
  const Terminology fat{{"85756007", "SCT", "Tissue"}, {{"256674009", "SCT", "Fat"}, {}}, {}};
  writeBalls({{{"Fat", {17, 200, 33}, 1, "tissue", {fat, SegmentAlgorithm{AlgorithmType::manual, ""}}},
               icosphere(Vec3(12, 12, 12), 4, 1)}},
             folder / "s.seg.dcm");
  const Outcome run =
      runCli({"mesh", folder / "s.seg.dcm", "-o", folder / "m.seg.dcm", "-o", folder / "m.seg.nrrd"});
  INFO(run.err);
  REQUIRE(run.exitCode == 0);
  const SegmentSource meant{fat, SegmentAlgorithm{AlgorithmType::manual, ""}};
  CHECK(readDicomLabels(folder / "m.seg.dcm").at(1).source == meant);
  CHECK(readSlicerLabels(folder / "m.seg.nrrd").at(1).source == meant);
  CHECK(runCli({"mesh", folder / "s.seg.dcm", "--term", "liver", "-o", folder / "m.seg.dcm"}).exitCode == 0);
  CHECK(readDicomLabels(folder / "m.seg.dcm").at(1).term == "liver");
  CHECK_FALSE(readDicomLabels(folder / "m.seg.dcm").at(1).source.terminology);
}

TEST_CASE("with --anonymous the mesh of a DICOM Segmentation names neither patient nor what stood in it",
          "[cli][mesh]") {
  using namespace handlebody;
  const TempFolder folder;
  writeBalls({{{"Doe's kidney", {17, 200, 33}, 1, "kidney"}, icosphere(Vec3(12, 12, 12), 4, 1)}},
             folder / "doe.seg.dcm");
  const auto written = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"mesh", folder / "doe.seg.dcm"});
    std::string all;
    for (const char* name : {"m.seg.dcm", "m.stl.dcm", "m.seg.nrrd", "m.obj"})
      more.insert(more.end(), {"-o", folder / name});
    const Outcome run = runCli(more);
    INFO(run.err);
    REQUIRE(run.exitCode == 0);
    for (const char* name : {"m.seg.dcm", "m.stl.dcm", "m.seg.nrrd", "m.obj"})
      all += readBytes(folder / name);
    return all;
  };
  const std::string named = written({"--creator", "Roe^Ann", "--description", "for a print"});
  for (const char* said : {"Doe^Jane", "20221208", "Doe's kidney", "Roe^Ann", "for a print"})
    CHECK_THAT(named, Contains(said));
  const std::string anonymous = written({"--anonymous"});
  for (const char* said : {"Doe", "20221208", "Roe", "for a print"}) CHECK_THAT(anonymous, !Contains(said));
}

TEST_CASE("of segments that overlap each is meshed by number or name, and without one all together",
          "[cli][mesh]") {
  using namespace handlebody;
  const TempFolder folder;
  Grid grid;
  grid.size = {12, 12, 12};
  const auto block = [](double end) {
    return [end](const Vec3& p) { return p.minCoeff() > 2 && p.maxCoeff() < 9 && p.x() < end; };
  };
  const std::vector<test::Segment> segments{{"Half", "1 0 0", block(6)}, {"Whole", "0 1 0", block(8)}};
  writeLayers(segments, grid, folder / "l.seg.nrrd");
  writeOverlappingDicom(segments, grid, folder / "l.seg.dcm");
  const std::string layers = folder / "l.seg.nrrd";
  writeBytes(folder / "one.mha", someLabels());
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"mesh", layers, "-o", folder / "m.stl"},
        {"compare", layers, folder / "one.mha"},
        {"compare", folder / "one.mha", layers, "--label-b", "Half"}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--frame", "0"});
    requireRefusal(folder, all, 2, "--frame: " + layers + " has layers, not time points");
  }
  for (const std::string name : {"l.seg.nrrd", "l.seg.dcm"}) {
    INFO(name);
    const auto volume = [&](const std::vector<std::string>& more) {
      std::vector<std::string> all{"mesh", folder / name, "-o", folder / "m.stl", "--json"};
      all.insert(all.end(), more.begin(), more.end());
      return runForJson(all).at("volume_mm3").get<double>();
    };
    CHECK(volume({"--label", "Half"}) == Approx(3 * 6 * 6).epsilon(0.02));
    CHECK(volume({"--label", "1"}) == volume({"--label", "Half"}));
    CHECK(volume({"--label", "Whole"}) == Approx(5 * 6 * 6).epsilon(0.02));
    CHECK(volume({"--label", "2"}) == volume({"--label", "Whole"}));
    CHECK(volume({}) == volume({"--label", "Whole"}));
    requireRefusal(folder, {"mesh", folder / name, "--label", "Rest", "-o", folder / "x.stl"}, 3,
                   "no label called 'Rest'; it has: 1 'Half', 2 'Whole'");
    const auto same = runForJson(
        {"compare", folder / name, folder / name, "--label-a", "Half", "--label-b", "Whole", "--json"});
    CHECK(same.at("dice").get<double>() == Approx(2 * 3.0 / (3 + 5)));
    CHECK(same.at("b").at("label") == 2);
    const auto info = runForJson({"info", folder / name, "--json"});
    CHECK(info.at("frames") == 1);
    CHECK(info.at("layers") == 2);
    CHECK(info.at("labels").at(1).at("number") == 2);
    CHECK(info.at("labels").at(1).at("name") == "Whole");
    const std::string text = runCli({"info", folder / name}).out;
    CHECK_THAT(text, Contains("label 2: Whole") && !Contains("time points"));
  }
}

TEST_CASE("what is no label map, or has nothing to mesh, is refused in one sentence", "[cli][mesh]") {
  const TempFolder folder;
  const std::string labels = folder / "l.mha", out = folder / "m.stl";
  writeBytes(labels, someLabels());
  writeBytes(folder / "zero.mha", labelCube(8, [](int, int, int) { return 0; }));
  writeBytes(folder / "letter.nii", "This is a letter.\n");
  requireRefusal(folder, {"mesh", labels}, 2, "--output");
  requireRefusal(folder, {"mesh", labels, "-o", folder / "m.xyz"}, 2, "m.xyz");
  requireRefusal(folder, {"mesh", labels, "-o", labels}, 2, "-o");
  requireRefusal(folder, {"mesh", labels, "-o", folder / "missing/m.stl"}, 2, "-o");
  requireRefusal(folder, {"mesh", labels, "-o", folder / "m.seg.dcm"}, 2, "m.seg.dcm");
  requireRefusal(folder, {"mesh", folder / "none.mha", "-o", out}, 3, "none.mha");
  std::string far = someLabels();
  far.insert(far.find("ElementSpacing"), "Offset = 0 0 99999999999\n");
  writeBytes(folder / "far.mha", far);
  requireRefusal(folder, {"mesh", folder / "far.mha", "--label", "1", "-o", out}, 3, "single precision");
  requireRefusal(folder, {"mesh", folder / "letter.nii", "-o", out}, 3, "letter.nii");
  requireRefusal(folder, {"mesh", folder / "zero.mha", "-o", out}, 3, "zero.mha");
  requireRefusal(folder, {"mesh", labels, "--label", "9", "-o", out}, 3, "9");
  requireRefusal(folder, {"mesh", labels, "--label", "", "-o", out}, 2, "--label");
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--smooth", "-1"},
                                                        {"--smooth", "inf"},
                                                        {"--smooth", "1e6"},
                                                        {"--edge-length", "1e-6"},
                                                        {"--edge-length", "0"},
                                                        {"--genus", "-1"},
                                                        {"--label", "1.5"},
                                                        {"--space", "MNI"},
                                                        {"--threads", "0"}})
    requireRefusal(folder, {"mesh", labels, option, value, "-o", out}, 2, option);
}
