// 4D volumes that are written frame by frame.

#include "core/io/formats/sequence_writer.h"

#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

std::vector<Volume> threeFrames(const Grid& grid, VoxelType type) {
  std::vector<Volume> frames;
  for (unsigned seed : {1u, 2u, 3u}) frames.push_back(randomVolume(grid, type, seed));
  return frames;
}

void write(const std::vector<Volume>& frames, const std::string& path, const TimeAxis& times) {
  writeSequence({frames[0].grid, frames[0].type, static_cast<int>(frames.size()), times}, path,
                [&](int i) { return frames[i]; });
}

}  // namespace

TEST_CASE("a 4D volume that is written is read back voxel for voxel, where it was and when") {
  const TemporaryFolder folder;
  const std::string name = GENERATE("v.nii", "v.nii.gz", "v.nrrd");
  const VoxelType type = GENERATE(VoxelType::uint8, VoxelType::uint16, VoxelType::int16, VoxelType::float32);
  Grid grid = obliqueGrid();
  if (GENERATE(false, true)) grid.direction.col(1) *= -1;  // left-handed
  const std::vector<Volume> frames = threeFrames(grid, type);
  const std::string path = folder / name;
  write(frames, path, {{0, 20, 40}, "given"});
  CHECK(readTimeAxis(path).milliseconds.size() == 3);
  CHECK(evenStep(readTimeAxis(path)) == Approx(20).epsilon(1e-6));
  for (int i = 0; i < 3; ++i) {
    const Volume back = readVolume(path, {.frame = i});
    CHECK(voxelBytes(back) == voxelBytes(frames[i]));
    const Vec3 last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
    CHECK((back.grid.toWorld(last) - grid.toWorld(last)).norm() < 1e-3);
    CHECK((back.grid.toWorld(Vec3::Zero()) - grid.toWorld(Vec3::Zero())).norm() < 1e-3);
  }
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("uneven times are kept by NRRD, and NIfTI says nothing of them") {
  const TemporaryFolder folder;
  const std::vector<Volume> frames = threeFrames(obliqueGrid(), VoxelType::uint8);
  write(frames, folder / "v.nrrd", {{0, 20, 50.5}, "given"});
  CHECK(readTimeAxis(folder / "v.nrrd").milliseconds == std::vector<double>{0, 20, 50.5});
  write(frames, folder / "v.nii", {{0, 20, 50.5}, "given"});
  CHECK(readTimeAxis(folder / "v.nii").milliseconds.empty());
  CHECK(inspectVolume(folder / "v.nii").frames == 3);
}

TEST_CASE("a 4D volume whose making fails leaves the file of before") {
  const TemporaryFolder folder;
  writeBytes(folder / "v.nrrd", "before");
  const SequenceLayout layout{obliqueGrid(), VoxelType::uint8, 2, {}};
  const auto fail = [&](int i) {
    if (i == 1) throw InputError("no such frame.");
    return randomVolume(obliqueGrid(), VoxelType::uint8);
  };
  CHECK_THROWS_AS(writeSequence(layout, folder / "v.nrrd", fail), InputError);
  CHECK(readBytes(folder / "v.nrrd") == "before");
  CHECK(folder.fileCount() == 1);
  CHECK_THROWS_AS(writeSequence(layout, folder / "v.mha", fail), UsageError);
  CHECK_THROWS_AS(writeSequence(layout, folder / "v.seg.nrrd", fail), UsageError);
}

TEST_CASE("a collection names the file of each frame with its time") {
  const TemporaryFolder folder;
  writeCollection(folder / "mesh.vtp", {3, 5}, {{0, 1, 2, 30.5, 4, 50}, "given"});
  const std::string text = readBytes(folder / "mesh.pvd");
  CHECK_THAT(text, Catch::Matchers::Contains("timestep=\"30.5\" part=\"0\" file=\"mesh_0003.vtp\""));
  CHECK_THAT(text, Catch::Matchers::Contains("timestep=\"50\" part=\"0\" file=\"mesh_0005.vtp\""));
  writeCollection(folder / "mesh.vtp", {3}, {});
  CHECK_THAT(readBytes(folder / "mesh.pvd"), Catch::Matchers::Contains("timestep=\"3\""));
}
