#include "tests/io/dicom_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

TEST_CASE("a DICOM series is stacked by position, whatever its files are called, with its oblique geometry") {
  const TemporaryFolder folder;
  const std::vector<Slice> slices = evenStack(6);
  writeSeries(folder / "series", slices);
  writeBytes(folder / "series/notes.txt", "not an image");
  const Volume volume = readVolume(folder / "series");
  CHECK(volume.type == VoxelType::int16);
  CHECK(volume.grid.size == std::array<int, 3>{4, 3, 6});
  CHECK((volume.grid.spacing - Vec3(0.75, 1.5, 2.5)).norm() < 1e-6);
  CHECK((volume.grid.origin - slices[0].position).norm() < 1e-6);
  CHECK((volume.grid.direction - slices[0].direction).norm() < 1e-6);
  for (int k = 0; k < 6; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == k);
  const VolumeInfo info = inspectVolume(folder / "series");
  CHECK(info.format == "DICOM");
  REQUIRE(info.series.size() == 1);
  CHECK(info.series[0].uid == "1.2.3.4");
  CHECK(info.series[0].files == 6);
  CHECK(info.series[0].description == "MR made by hand");
}

TEST_CASE("slices with different rescaling hold their values in one wider type") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(3);
  slices[2].slope = "0.5";
  slices[2].intercept = "10";
  writeSeries(folder / "series", slices);
  const Volume volume = readVolume(folder / "series");
  CHECK(inspectVolume(folder / "series").type == volume.type);
  visitVoxels(volume, [](const auto* values) {
    CHECK(static_cast<double>(values[0]) == 0);
    CHECK(static_cast<double>(values[12]) == 1);
    CHECK(static_cast<double>(values[24]) == 11);
  });
}

TEST_CASE("several series in a folder need a choice, and the refusal lists them") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(3);
  std::vector<Slice> others = evenStack(4);
  for (Slice& s : others) {
    s.series = "9.8.7";
    s.value = static_cast<std::int16_t>(s.value + 100);
  }
  slices.insert(slices.end(), others.begin(), others.end());
  writeSeries(folder.path(), slices);
  expectInputError(folder.path(),
                   "1.2.3.4 (MR made by hand, 3 files, 4 x 3 x 3 voxels of 0.75, 1.5, 2.5 mm); 9.8.7 (MR "
                   "made by hand, 4 files",
                   true);
  const VolumeInfo info = inspectVolume(folder.path());
  CHECK(info.series.size() == 2);
  CHECK(info.frames == 0);
  const Volume chosen = readVolume(folder.path(), {.series = "9.8.7"});
  CHECK(chosen.grid.size[2] == 4);
  CHECK(chosen.data<std::int16_t>()[0] == 100);
  CHECK_THROWS_AS(readVolume(folder.path(), {.series = "5"}), UsageError);
}

TEST_CASE("stacks that are no plain grid are refused") {
  const TemporaryFolder folder;
  const std::string path = folder / "series";
  std::vector<Slice> slices = evenStack(6);
  const auto refusedFor = [&](const std::string& cause) {
    writeSeries(path, slices);
    expectInputError(path, cause);
  };
  SECTION("no pixel spacing") {
    slices[2].spacing = "";
    refusedFor("does not say where it lies");
  }
  SECTION("every slice in another direction") {
    for (int i = 0; i < 6; ++i)
      slices[i].direction = Eigen::AngleAxisd(0.3 * i, Vec3(0, 0, 1)).toRotationMatrix();
    refusedFor("orientations");
  }
  SECTION("a single slice") {
    slices.resize(1);
    refusedFor("2D image");
    expectInputError(path + "/1000", "2D image");
  }
}

TEST_CASE("positions rounded to a hundredth of a millimetre are an even stack") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(20);
  for (Slice& s : slices)
    for (int a = 0; a < 3; ++a) s.position[a] = std::round(s.position[a] * 100) / 100;
  writeSeries(folder.path(), slices);
  CHECK(readVolume(folder.path()).grid.spacing[2] == Approx(2.5).margin(1e-3));
}

TEST_CASE("a truncated slice is refused") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(3);
  for (Slice& s : slices) s.rows = s.columns = 40;
  writeSeries(folder.path(), slices);
  const std::string victim = folder / "999";
  const std::string bytes = readBytes(victim);
  for (const std::size_t missing : {2u, 100u, 1600u, 3190u}) {
    INFO(missing);
    writeBytes(victim, bytes.substr(0, bytes.size() - missing));
    expectInputError(folder.path(), "", true);
  }
  // Only the first part of the header: this slice is missing from the stack.
  writeBytes(victim, bytes.substr(0, 200));
  expectInputError(folder.path(), "", true);
}

TEST_CASE("a slice that ends anywhere is refused or warned about, and GDCM does not abort") {
  const TemporaryFolder folder;
  writeSeries(folder.path(), evenStack(3));
  const std::string bytes = readBytes(folder / "999");
  int warned = 0;
  // Before its preamble is whole a file is no DICOM file at all.
  for (std::size_t n = 132; n < bytes.size(); ++n) {
    INFO(n << " of " << bytes.size() << " bytes");
    writeBytes(folder / "999", bytes.substr(0, n));
    try {
      const VolumeInfo info = inspectVolume(folder.path());
      expectWarning(info, FindingKind::fileWithoutImage,
                    "1 file of DICOM in the folder is without an image and left out.");
      ++warned;
    } catch (const InputError&) {
      SUCCEED();
    }
  }
  // Only where it ends between two elements before its series is named.
  CHECK(warned < 10);
}
