// The surfaces of all frames: polished one after the other, written together or not at all.

#include "core/io/report/frame_files.h"

#include <limits>

#include "core/cancellation.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/report/polished_frames.h"
#include "core/io/report/result.h"
#include "core/mesh/shapes.h"
#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Balls in the frames 0, 1 and 3; frame 2 has no surface.
OverTimeReport ballsOverTime() {
  OverTimeReport over;
  for (int f = 0; f < 4; ++f) {
    FrameResult r;
    r.frame = f;
    if (f != 2) r.mesh = certifiedForExport(icosphere(Vec3(0, 0, 0), 10 + f, 3)).mesh;
    r.volume = 1000 + f;
    over.frames.push_back(std::move(r));
  }
  over.curve = curveOf(over.frames, {});
  return over;
}

}  // namespace

TEST_CASE("files of a set get their names together, or leave nothing and keep what was there") {
  const TemporaryFolder folder;
  writeTextAtomically(folder / "a", "old");
  {
    FileSet set;
    writeTextAtomically(folder / "a", "new", &set);
    writeTextAtomically(folder / "b", "new", &set);
    CHECK(readBytes(folder / "a") == "old");
    CHECK_FALSE(fs::exists(folder / "b"));
  }
  CHECK(readBytes(folder / "a") == "old");
  CHECK(folder.fileCount() == 1);
  FileSet set;
  writeTextAtomically(folder / "a", "new", &set);
  writeTextAtomically(folder / "b", "new", &set);
  set.commit();
  CHECK(readBytes(folder / "a") == "new");
  CHECK(readBytes(folder / "b") == "new");
  CHECK(folder.fileCount() == 2);
}

TEST_CASE("a file that is of no set gets its name at once, whatever sets there are") {
  const TemporaryFolder folder;
  const FileSet set;
  writeTextAtomically(folder / "a", "alone");
  CHECK(readBytes(folder / "a") == "alone");
}

TEST_CASE("meshes of frames of which one cannot be written leave those of before") {
  const TemporaryFolder folder;
  OverTimeReport over = ballsOverTime();
  writeFrameMeshes(over, CoordinateSpace::lps, folder / "m.vtp");
  CHECK(folder.fileCount() == 4);  // three meshes and their list
  const std::string before = readBytes(folder / "m_0000.vtp");
  over.frames[0].mesh = over.frames[1].mesh;
  over.frames[3].mesh.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(writeFrameMeshes(over, CoordinateSpace::lps, folder / "m.vtp"), OutputError);
  CHECK(readBytes(folder / "m_0000.vtp") == before);
  CHECK(folder.fileCount() == 4);
}

TEST_CASE("a frame that has no surface any more keeps no mesh of an earlier run") {
  const TemporaryFolder folder;
  OverTimeReport over = ballsOverTime();
  for (const char* name : {"m_0002.stl", "m_0004.stl", "n_0002.stl", "m_0002.ply"})
    writeTextAtomically(folder / name, "earlier");
  const auto mesh = over.frames[3].mesh;
  over.frames[3].mesh.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(writeFrameMeshes(over, CoordinateSpace::lps, folder / "m.stl"), OutputError);
  CHECK(readBytes(folder / "m_0002.stl") == "earlier");
  over.frames[3].mesh = mesh;
  writeFrameMeshes(over, CoordinateSpace::lps, folder / "m.stl");
  CHECK_FALSE(fs::exists(folder / "m_0002.stl"));
  for (const char* other : {"m_0004.stl", "n_0002.stl", "m_0002.ply"})  // not of these frames and files
    CHECK(readBytes(folder / other) == "earlier");
  CHECK(folder.fileCount() == 6);
}

TEST_CASE("what a 4D label map leaves out of a frame is told of that frame") {
  const OverTimeReport over = ballsOverTime();  // radii of 10, 11 and 13 mm
  Grid grid;
  grid.size = {25, 25, 25};
  grid.origin = Vec3(-12, -12, -12);
  const auto told = frameLabelWarnings(over, grid, {"m.nii"});
  REQUIRE(told.size() == 1);
  CHECK(told.at(3).at(0).kind == FindingKind::surfacePartlyOutside);
  CHECK(frameLabelWarnings(over, grid, {"m.stl"}).empty());
  grid.origin = Vec3(50, 50, 50);
  CHECK(frameLabelWarnings(over, grid, {"m.nii"}).at(0).size() == 2);
}

TEST_CASE("frames that nobody wants any more are not written") {
  const TemporaryFolder folder;
  const OverTimeReport over = ballsOverTime();
  const std::atomic<bool> stop{true};
  const CancelScope scope(stop);
  CHECK_THROWS_AS(writeFrameMeshes(over, CoordinateSpace::lps, folder / "m.stl"), Cancelled);
  CHECK_THROWS_AS(writeFrameLabels(over, {}, obliqueGrid(), folder / "m.nii"), Cancelled);
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("frames are polished in their order, but those that are, until nobody wants it any more") {
  OverTimeReport over = ballsOverTime();
  over.polish[1] = {};
  std::vector<int> told;
  polishFrames(over, [&](int frame) { told.push_back(frame); });
  CHECK(told == std::vector<int>{0, 3});
  CHECK(over.polish.size() == 3);
  over.polish.clear();
  std::atomic<bool> stop{false};
  const CancelScope scope(stop);
  CHECK_THROWS_AS(polishFrames(over, [&](int) { stop = true; }), Cancelled);
  CHECK(over.polish.count(3) == 0);
}

TEST_CASE("of all frames the bad places are added, and the least angle is that of the worst frame") {
  PolishReport one, other;
  one.before = {3, 1, 7, 12};
  one.after = {0, 0, 16, 21};
  one.farthest = 0.1;
  other.before = {2, 0, 9, 30};
  other.after = {1, 0, 9, 30};
  other.changedFaces = 4;
  const PolishReport all = together({{0, one}, {5, other}});
  CHECK(all.before.faces == 5);
  CHECK(all.before.edges == 1);
  CHECK(all.before.leastAngle == 7);
  CHECK(all.before.leastDihedral == 12);
  CHECK(all.after.faces == 1);
  CHECK(all.after.leastAngle == 9);
  CHECK(all.farthest == 0.1);
  CHECK(all.changedFaces == 4);
}
