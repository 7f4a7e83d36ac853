// Label maps label by label, with segments that overlap.

#include "core/io/report/label_file.h"

#include <limits>

#include "core/io/refuse_input.h"
#include "core/io/report/start_surface.h"
#include "core/io/report/wall_map.h"
#include "core/told_error.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/overlapping_segments.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

Grid someGrid() {
  Grid grid;
  grid.size = {15, 13, 4};  // frames whose bits are no whole bytes
  return grid;
}

//! All of it, its left third, and its right third.
std::vector<test::Segment> threeSegments() {
  return {{"body", "1 0 0", [](const Vec3&) { return true; }, 0, 1},
          {"left", "0 1 0", [](const Vec3& p) { return p.x() < 5; }, 1, 1},
          {"right", "0 0 1", [](const Vec3& p) { return p.x() >= 10 && p.y() > 0; }, 1, 2}};
}

void expectThree(const std::string& path) {
  INFO(path);
  LabelFile file(path);
  CHECK(file.info().layers == 2);
  CHECK(file.info().frames == 1);  // no time points
  const std::vector<NamedLabel> labels = file.labels();
  REQUIRE(labels.size() == 3);
  const std::size_t counts[] = {15 * 13 * 4, 5 * 13 * 4, 5 * 12 * 4};
  for (int l = 0; l < 3; ++l) {
    const auto at = static_cast<std::size_t>(l);
    CHECK(labels[at].value == l + 1);
    CHECK(labels[at].name == threeSegments()[at].name);
    CHECK(labelCalled(path, labels[at].name) == l + 1);
    CHECK(labelIn(path, l + 1).name == labels[at].name);
    const Mask mask = file.mask(l + 1);
    CHECK(mask.count() == counts[at]);
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 15; ++i)
        CHECK(mask.holds(Vec3(i, 6, k)) == threeSegments()[at].holds(Vec3(i, 6, k)));
  }
  CHECK(file.mask(std::nullopt).count() == counts[0]);
  CHECK(file.mask(4).inside.empty());
  CHECK(file.mask(0).inside.empty());
}

}  // namespace

TEST_CASE("segments that overlap are each read whole, of a .seg.nrrd and of DICOM", "[labels]") {
  const TemporaryFolder folder;
  writeLayers(threeSegments(), someGrid(), folder / "l.seg.nrrd");
  writeOverlappingDicom(threeSegments(), someGrid(), folder / "l.seg.dcm");
  expectThree(folder / "l.seg.nrrd");
  expectThree(folder / "l.seg.dcm");
  SECTION("where they are read as an image it is said that it is the first layer alone") {
    for (const char* name : {"l.seg.nrrd", "l.seg.dcm"}) {
      const VolumeInfo info = inspectVolume(folder / name);
      expectAmong(
          info, FindingKind::firstLayerUsed,
          "The segmentation has 2 layers, since segments overlap: only the segments of the first layer "
          "are read.");
    }
  }
  SECTION("what is made of DICOM ones still refers to them") {
    REQUIRE(loadVolume(folder / "l.seg.dcm").info.dicom);
    CHECK(loadVolume(folder / "l.seg.dcm").info.dicom->images.size() == 1);
  }
}

TEST_CASE("segments that do not overlap are one layer, also where several lie in one slice", "[labels]") {
  const TemporaryFolder folder;
  std::vector<test::Segment> apart = threeSegments();
  apart.erase(apart.begin());
  writeOverlappingDicom(apart, someGrid(), folder / "l.seg.dcm");
  LabelFile file(folder / "l.seg.dcm");
  CHECK(file.info().layers == 1);
  CHECK(file.info().frames == 1);
  CHECK(file.mask(1).count() == 5 * 13 * 4);
  CHECK(file.mask(2).count() == 5 * 12 * 4);
}

TEST_CASE("numbers of a further layer go on behind the largest value of those before", "[labels]") {
  const TemporaryFolder folder;
  std::vector<test::Segment> segments = threeSegments();
  segments[0].value = 7;
  writeLayers(segments, someGrid(), folder / "l.seg.nrrd");
  LabelFile file(folder / "l.seg.nrrd");
  CHECK(file.mask(7).count() == 15 * 13 * 4);
  CHECK(file.mask(8).count() == 5 * 13 * 4);
  CHECK(file.mask(9).count() == 5 * 12 * 4);
  CHECK(file.mask(1).inside.empty());
  CHECK(labelCalled(folder / "l.seg.nrrd", "right") == 9);
}

TEST_CASE("segments of an older 3D Slicer, which says neither values nor layers, are no time points",
          "[labels]") {
  const TemporaryFolder folder;
  std::vector<test::Segment> segments = threeSegments();
  for (test::Segment& s : segments) {  // each in a layer of its own
    s.layer.reset();
    s.value = 1;
  }
  writeLayers(segments, someGrid(), folder / "l.seg.nrrd", true);
  LabelFile file(folder / "l.seg.nrrd");
  CHECK(file.info().layers == 3);
  CHECK(file.info().frames == 1);
  const std::vector<NamedLabel> labels = file.labels();
  REQUIRE(labels.size() == 3);
  const std::size_t counts[] = {15 * 13 * 4, 5 * 13 * 4, 5 * 12 * 4};
  for (int l = 0; l < 3; ++l) {
    const auto at = static_cast<std::size_t>(l);
    CHECK(labels[at].value == l + 1);
    CHECK(labels[at].name == segments[at].name);
    CHECK(labels[at].colour.has_value());
    CHECK(file.mask(l + 1).count() == counts[at]);
  }
  CHECK(labelCalled(folder / "l.seg.nrrd", "right") == 3);
}

TEST_CASE("a name that a file has not, or twice, is refused with those that it has", "[labels]") {
  const TemporaryFolder folder;
  const std::string path = folder / "l.seg.nrrd";
  std::vector<test::Segment> segments = threeSegments();
  writeLayers(segments, someGrid(), path);
  CHECK_THROWS_WITH(labelCalled(path, "liver"),
                    Contains(path) && Contains("'liver'") && Contains("1 'body', 2 'left', 3 'right'"));
  segments[2].name = "left";
  writeLayers(segments, someGrid(), path);
  CHECK_THROWS_WITH(labelCalled(path, "left"), Contains("several labels called 'left'"));
  writeLayers({}, someGrid(), folder / "plain.nrrd");
  CHECK_THROWS_WITH(labelCalled(folder / "plain.nrrd", "left"), Contains("names none"));
  CHECK(labelCalled(folder / "plain.nrrd", "12") == 12);
}

TEST_CASE("a file whose header counts its layers wrong has no more labels than voxels", "[labels]") {
  const TemporaryFolder folder;
  std::vector<test::Segment> segments = threeSegments();
  writeLayers(segments, someGrid(), folder / "l.seg.nrrd");
  std::string bytes = readBytes(folder / "l.seg.nrrd");
  for (const char* wrong : {"Segment1_Layer:=9", "Segment1_Layer:=-", "Segment1_Layer:=z"}) {
    std::string changed = bytes;
    changed.replace(changed.find("Segment1_Layer:=1"), std::string(wrong).size(), wrong);
    writeBytes(folder / "wrong.seg.nrrd", changed);
    LabelFile file(folder / "wrong.seg.nrrd");
    CHECK(file.labels().size() == 3);
    CHECK(file.mask(1).count() == 15 * 13 * 4);
  }
}

TEST_CASE("why a mask becomes no surface is told of its file, with the cause") {
  try {
    refuseSurface("a.nii", Told<InputError>(Finding(FindingKind::surfaceTooLarge, {{"most", 100}})));
  } catch (const InputError& error) {
    CHECK(std::string(error.what()) == "a.nii: it has a surface of more than 100 triangles.");
    CHECK(findingOf(error).kind == FindingKind::noSurface);
    CHECK(findingOf(error).causes.at(0).kind == FindingKind::surfaceTooLarge);
  }
}

TEST_CASE("a wall is what any layer of a label map holds, and nothing else", "[labels]") {
  const TemporaryFolder folder;
  const std::vector<test::Segment> segments{
      {"left", "1 0 0", [](const Vec3& p) { return p.x() < 5 && p.z() > 0; }},
      {"upper", "0 1 0", [](const Vec3& p) { return p.x() < 7 && p.x() > 2 && p.y() > 3 && p.z() > 1; }}};
  writeLayers(segments, someGrid(), folder / "l.seg.nrrd");
  writeOverlappingDicom(segments, someGrid(), folder / "l.seg.dcm");
  std::vector<bool> expected;
  forEachVoxel(someGrid(),
               [&](const Vec3& p) { expected.push_back(segments[0].holds(p) || segments[1].holds(p)); });
  for (const char* name : {"l.seg.nrrd", "l.seg.dcm"}) {
    INFO(name);
    const WallMap map = readWallMap(folder / name, someGrid());
    CHECK(*map.voxels == expected);
    CHECK(map.warnings.empty());
  }
}

namespace {

//! An NRRD of someGrid() with what `lines` say of its voxels, and with those.
std::string wallsFile(const std::string& lines, const std::string& voxels) {
  return "NRRD0004\n" + lines + "endian: little\nencoding: raw\n\n" + voxels;
}

constexpr const char* kPlaced =
    "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n";

}  // namespace

TEST_CASE("walls of several time points or of values that are no whole numbers are refused", "[labels]") {
  const TemporaryFolder folder;
  const std::string path = folder / "w.nrrd";
  const std::size_t count = someGrid().voxelCount();
  writeBytes(path, wallsFile("type: uint8\ndimension: 4\nsizes: 15 13 4 2\nkinds: domain domain domain time\n"
                             "space: left-posterior-superior\n"
                             "space directions: (1,0,0) (0,1,0) (0,0,1) none\nspace origin: (0,0,0)\n",
                             std::string(2 * count, '\1')));
  CHECK_THROWS_WITH(readWallMap(path, someGrid()), Contains(path) && Contains("2 time points"));
  for (const float odd : {0.5F, std::numeric_limits<float>::quiet_NaN()}) {
    std::vector<float> values(count, 0);
    values[3] = 1;
    values[5] = odd;
    const std::string bytes(reinterpret_cast<const char*>(values.data()), count * sizeof(float));
    writeBytes(path, wallsFile("type: float\ndimension: 3\nsizes: 15 13 4\n" + std::string(kPlaced), bytes));
    CHECK_THROWS_WITH(readWallMap(path, someGrid()), Contains(path) && Contains("whole numbers"));
  }
}

TEST_CASE("what is to be known of the files of walls and starts stands with them", "[labels]") {
  const TemporaryFolder folder;
  const std::string walls = folder / "w.nrrd", start = folder / "s.nrrd";
  const std::size_t count = someGrid().voxelCount();
  std::string voxels(count, '\0');
  voxels[3] = '\1';
  writeBytes(walls, wallsFile("type: uint8\ndimension: 3\nsizes: 15 13 4\nspacings: 1 1 1\n", voxels));
  std::string times(2 * count, '\0');
  forEachVoxel(someGrid(), [&, at = std::size_t{0}](const Vec3& p) mutable {
    times[at++] = inBall(Vec3(7, 6, 1.5), 3)(p) ? '\1' : '\0';
  });
  writeBytes(start,
             wallsFile("type: uint8\ndimension: 4\nsizes: 15 13 4 2\nkinds: domain domain domain time\n"
                       "space: left-posterior-superior\n"
                       "space directions: (1,0,0) (0,1,0) (0,0,1) none\nspace origin: (0,0,0)\n",
                       times));
  Session session;
  session.constraints.walls.map = WallMap{walls, {}, nullptr};
  session.constraints.start.emplace().path = start;
  loadWalls(session, someGrid());
  loadStarts(session);
  const std::vector<Finding>& ofWalls = session.constraints.walls.map->warnings;
  REQUIRE(ofWalls.size() == 1);
  CHECK(ofWalls[0].causes.at(0).kind == FindingKind::axesTakenAsLps);
  CHECK_THAT(sentence(ofWalls[0]), Contains(walls));
  const std::vector<Finding>& ofStart = session.constraints.start->warnings;
  REQUIRE(ofStart.size() == 1);
  CHECK(sentence(ofStart[0]) == start + ": There are 2 time points; the first one is used.");
}
