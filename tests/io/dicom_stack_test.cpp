// Stacks that are no plain grid, multi-frame files, and files without geometry.

#include "tests/io/dicom_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Values of a function that is linear in space (mm), as a scanner would see them; integers for whole
//! numbers.
int linear(const Vec3& p) { return static_cast<int>(std::lround(10 * p.x() + 20 * p.y() - 7 * p.z())); }

//! Slices whose pixels hold linear() of their place. `positions`: of the first pixels.
std::vector<Slice> linearStack(const std::vector<Vec3>& positions) {
  std::vector<Slice> slices;
  for (const Vec3& p : positions) {
    Slice s;
    s.position = p;
    s.columns = 20;
    s.rows = 24;
    s.spacing = "2\\1";
    s.pixel = [p](int x, int y) { return linear(p + Vec3(x, 2 * y, 0)); };
    slices.push_back(s);
  }
  return slices;
}

//! Every voxel is either outside (the smallest value of all) or the linear function within `tolerance`.
double partOfLinear(const Volume& volume, double tolerance) {
  std::size_t right = 0, outside = 0;
  const auto* values = volume.data<std::int16_t>();
  const Grid& g = volume.grid;
  const std::int16_t smallest = *std::min_element(values, values + g.voxelCount());
  std::size_t n = 0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i, ++n) {
        const double expected = linear(g.toWorld(Vec3(i, j, k)));
        const bool near = std::abs(values[n] - expected) <= tolerance;
        right += near;
        outside += !near && values[n] == smallest;
      }
  CHECK(right + outside == g.voxelCount());
  return static_cast<double>(right) / static_cast<double>(g.voxelCount());
}

}  // namespace

TEST_CASE("a tilted stack is resampled to a straight grid, everything in its place in space") {
  const TemporaryFolder folder;
  std::vector<Vec3> positions;
  for (int k = 0; k < 10; ++k) positions.push_back(Vec3(3, 5 + 0.7 * k, 2.0 * k));
  writeSeries(folder.path(), linearStack(positions));
  const VolumeInfo info = inspectVolume(folder.path());
  expectWarning(info, FindingKind::slicesTilted,
                "The slices are tilted by 19.3 degrees (gantry tilt) and were resampled to a straight grid.");
  const Volume volume = readVolume(folder.path());
  CHECK((volume.grid.direction - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  CHECK((volume.grid.spacing - Vec3(1, 2, 2)).norm() < 1e-9);
  CHECK(partOfLinear(volume, 1) > 0.7);
}

TEST_CASE(
    "unevenly spaced slices are resampled with a warning that names the pitches, or refused by choice") {
  const TemporaryFolder folder;
  std::vector<Vec3> positions;
  for (double z : {0.0, 2.0, 4.0, 6.0, 9.0, 12.0, 15.0}) positions.push_back(Vec3(0, 0, z));
  writeSeries(folder.path(), linearStack(positions));
  expectAmong(inspectVolume(folder.path()), FindingKind::slicesResampled,
              "The slices are unevenly spaced (3 gaps of 2 mm, 3 of 3 mm); they were resampled to a distance "
              "of 2 mm. What lies in the gaps is interpolated.");
  const Volume volume = readVolume(folder.path());
  CHECK(volume.grid.size[2] == 8);
  CHECK(volume.grid.spacing.z() == Approx(2));
  CHECK(partOfLinear(volume, 1) == 1);
  VolumeSelection refuse;
  refuse.uneven = UnevenSlices::refuse;
  CHECK_THROWS_AS(readVolume(folder.path(), refuse), InputError);
  CHECK_THROWS_AS(inspectVolume(folder.path(), refuse), InputError);
}

TEST_CASE("missing slices are counted, and what lies in the gap is interpolated") {
  const TemporaryFolder folder;
  std::vector<Vec3> positions;
  for (double z : {0.0, 2.0, 4.0, 10.0, 12.0, 14.0}) positions.push_back(Vec3(0, 0, z));
  writeSeries(folder.path(), linearStack(positions));
  expectAmong(inspectVolume(folder.path()), FindingKind::slicesMissingResampled,
              "The slices are unevenly spaced (2 gaps of 2 mm, 1 of 6 mm, 2 of 2 mm), 2 seem to be missing; "
              "they were resampled to a distance of 2 mm. What lies in the gaps is interpolated.");
  const Volume volume = readVolume(folder.path());
  CHECK(volume.grid.size[2] == 8);
  CHECK(partOfLinear(volume, 1) == 1);
}

TEST_CASE("copies of slices are left out with a warning") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(5);
  slices.push_back(slices[1]);  // the same pixels under another UID
  slices.push_back(slices[3]);
  writeSeries(folder.path(), slices);
  expectWarning(inspectVolume(folder.path()), FindingKind::slicesAreCopies,
                "2 slices are copies of others and were left out.");
  const Volume volume = readVolume(folder.path());
  CHECK(volume.grid.size[2] == 5);
  for (int k = 0; k < 5; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == k);
}

TEST_CASE("slices in which nothing moves are no copies of those of another time") {
  const TemporaryFolder folder;
  std::vector<Slice> slices;
  for (int t = 0; t < 3; ++t)
    for (Slice s : evenStack(5)) {  // the first and the last are the same at all times
      if (s.value > 0 && s.value < 4) s.value = static_cast<std::int16_t>(s.value + 50 * t);
      s.number = static_cast<int>(slices.size()) + 1;
      s.temporalPosition = 1 + t;
      slices.push_back(s);
    }
  writeSeries(folder.path(), slices);
  const VolumeInfo info = inspectVolume(folder.path(), {.frame = 2});
  CHECK(info.frames == 3);
  CHECK(info.warnings.empty());
  const Volume volume = readVolume(folder.path(), {.frame = 2});
  for (int k = 0; k < 5; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == (k == 0 || k == 4 ? k : k + 100));
}

TEST_CASE("slices that are alike in several time points are no copies, though the header has no times") {
  const TemporaryFolder folder;
  std::vector<Slice> slices;
  for (int t = 0; t < 3; ++t)
    for (Slice s : evenStack(5)) {  // blank ones at both ends
      s.value = static_cast<std::int16_t>(s.value == 0 || s.value == 4 ? 0 : s.value + 50 * t);
      s.number = static_cast<int>(slices.size()) + 1;
      slices.push_back(s);
    }
  writeSeries(folder / "blank", slices);
  const VolumeInfo info = inspectVolume(folder / "blank", {.frame = 2});
  CHECK(info.frames == 3);
  CHECK(info.series.size() == 1);
  CHECK(info.warnings.empty());
  const Volume volume = readVolume(folder / "blank", {.frame = 2});
  for (int k = 0; k < 5; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == (k == 0 || k == 4 ? 0 : k + 100));
  // A file that is there twice is a copy all the same.
  for (std::size_t i = 0; i < slices.size(); ++i) slices[i].instance = "1.2." + std::to_string(i);
  slices.push_back(slices[7]);
  writeSeries(folder / "twice", slices);
  const VolumeInfo twice = inspectVolume(folder / "twice", {.frame = 2});
  CHECK(twice.frames == 3);
  expectWarning(twice, FindingKind::sliceIsCopy, "1 slice is a copy of another and was left out.");
}

TEST_CASE("slices of the same pixels that are scaled differently are no copies") {
  const TemporaryFolder folder;
  std::vector<Slice> slices;
  for (const char* slope : {"1", "3"})
    for (Slice s : evenStack(4)) {
      s.slope = slope;
      s.number = static_cast<int>(slices.size()) + 1;
      slices.push_back(s);
    }
  writeSeries(folder.path(), slices);
  REQUIRE(inspectVolume(folder.path()).frames == 2);
  REQUIRE(inspectVolume(folder.path()).type == VoxelType::int32);
  CHECK(readVolume(folder.path(), {.frame = 0}).data<std::int32_t>()[12 * 2] == 2);
  CHECK(readVolume(folder.path(), {.frame = 1}).data<std::int32_t>()[12 * 2] == 6);
}

TEST_CASE("a scale of 0 is taken as 1, with a warning") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(4);
  for (Slice& s : slices) s.slope = "0", s.intercept = "-10";
  writeSeries(folder.path(), slices);
  expectWarning(inspectVolume(folder.path()), FindingKind::slopeIsZero,
                "The header scales voxels by 0, which would make them all alike; 1 is taken instead.");
  const Volume volume = readVolume(folder.path());
  REQUIRE(volume.type == VoxelType::int32);  // 16 bits and the intercept
  for (int k = 0; k < 4; ++k) CHECK(volume.data<std::int32_t>()[12 * k] == k - 10);
}

TEST_CASE("several different slices in every place are time points; incomplete ones are refused") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(4);
  for (int i = 0; i < 4; ++i) {
    Slice later = slices[i];
    later.value = static_cast<std::int16_t>(later.value + 50);
    later.number = 10 + i;
    slices.push_back(later);
  }
  writeSeries(folder / "whole", slices);
  const VolumeInfo info = inspectVolume(folder / "whole");
  CHECK(info.frames == 2);
  expectAmong(info, FindingKind::frameZeroUsed,
              "There are 2 time points; frame 0 is used (--frame chooses another).");
  CHECK(readVolume(folder / "whole").data<std::int16_t>()[12] == 1);
  CHECK(readVolume(folder / "whole", {.frame = 1}).data<std::int16_t>()[12] == 51);
  CHECK_THROWS_AS(readVolume(folder / "whole", {.frame = 2}), UsageError);
  slices.pop_back();
  writeSeries(folder / "part", slices);
  expectInputError(folder / "part", "not equally many in every place");
}

TEST_CASE("time points are in the order of their trigger times, in whatever order the files are numbered") {
  const TemporaryFolder folder;
  std::vector<Slice> slices;
  for (Slice s : evenStack(4)) {
    const bool isBackwards = s.value % 2 == 1;
    for (int i = 0; i < 3; ++i) {
      const int phase = isBackwards ? 2 - i : i;
      s.value = static_cast<std::int16_t>(100 * phase + static_cast<int>(slices.size()) / 3);
      s.triggerTime = 100 * phase + 3.5 * static_cast<double>(slices.size() / 3);  // hearts beat unevenly
      s.number = static_cast<int>(slices.size()) + 1;
      slices.push_back(s);
    }
  }
  writeSeries(folder / "timed", slices);
  REQUIRE(inspectVolume(folder / "timed").frames == 3);
  for (int t = 0; t < 3; ++t) {
    const Volume volume = readVolume(folder / "timed", {.frame = t});
    for (int k = 0; k < 4; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == 100 * t + k);
  }
  slices.back().triggerTime = -1;  // where one has no time, numbers are all there is
  writeSeries(folder / "partly", slices);
  const Volume volume = readVolume(folder / "partly", {.frame = 0});
  for (int k = 0; k < 4; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == (k % 2 == 1 ? 200 + k : k));
}

TEST_CASE("an enhanced multi-frame file takes its places from the functional groups, in any order") {
  const TemporaryFolder folder;
  Slice s = evenStack(1)[0];
  const Vec3 first = s.position, normal = s.direction.col(2);
  s.frames = 4;
  for (int k : {2, 0, 3, 1}) s.framePositions.push_back(first + 1.5 * k * normal);
  writeBytes(folder / "multi", dicomBytes(s, "1.2"));
  const VolumeInfo info = inspectVolume(folder / "multi");
  CHECK(info.calibrated);
  CHECK_THAT(info.sources.spacing[0], Contains("Pixel Measures"));
  CHECK_THAT(info.sources.origin, Contains("Plane Position"));
  const Volume volume = readVolume(folder / "multi");
  CHECK(volume.grid.size == std::array<int, 3>{4, 3, 4});
  CHECK((volume.grid.spacing - Vec3(0.75, 1.5, 1.5)).norm() < 1e-6);
  CHECK((volume.grid.origin - first).norm() < 1e-6);
  CHECK((volume.grid.direction - s.direction).norm() < 1e-6);
  const int expected[] = {1, 3, 0, 2};  // frame f holds the value f
  for (int k = 0; k < 4; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == expected[k]);
}

TEST_CASE("a multi-frame file without geometry is uncalibrated until the user gives the spacing") {
  const TemporaryFolder folder;
  Slice s;
  s.frames = 5;
  s.placed = false;
  s.spacing = "";
  writeBytes(folder / "multi", dicomBytes(s, "1.2"));
  const VolumeInfo info = inspectVolume(folder / "multi");
  CHECK_FALSE(info.calibrated);
  expectAmong(info, FindingKind::placesAssumed,
              "The header does not say where the slices lie; they are taken one behind the other, with LPS "
              "axes.");
  expectAmong(info, FindingKind::uncalibrated, sentence(FindingKind::uncalibrated));
  for (const std::string& source : info.sources.spacing) CHECK(source == "assumed");
  CHECK(info.sources.origin == "assumed");
  VolumeSelection given;
  given.spacing = Vec3(0.5, 0.25, 2);
  const VolumeInfo calibrated = inspectVolume(folder / "multi", given);
  CHECK(calibrated.calibrated);
  CHECK(calibrated.sources.spacing[2] == "given by the user");
  CHECK(readVolume(folder / "multi", given).grid.spacing == Vec3(0.5, 0.25, 2));
}

TEST_CASE("ultrasound regions give the pixel spacing, in millimetres") {
  const TemporaryFolder folder;
  Slice s;
  s.frames = 5;
  s.placed = false;
  s.spacing = "";
  s.modality = "US";
  s.regionDelta = 0.025;
  s.sliceDistance = 0.7;
  writeBytes(folder / "us", dicomBytes(s, "1.2"));
  const VolumeInfo info = inspectVolume(folder / "us");
  CHECK(info.calibrated);
  CHECK((info.grid.spacing - Vec3(0.25, 0.5, 0.7)).norm() < 1e-12);
  CHECK_THAT(info.sources.spacing[0], Contains("0018,602C"));
  CHECK_THAT(info.sources.spacing[2], Contains("0018,0088"));
}

TEST_CASE("a cine is refused as a volume with a way out") {
  const TemporaryFolder folder;
  Slice s;
  s.frames = 30;
  s.placed = false;
  s.frameTime = 33;
  writeBytes(folder / "cine", dicomBytes(s, "1.2"));
  expectInputError(folder / "cine", "a cine (2D images over time: 30 frames)");
  VolumeSelection given;
  given.spacing = Vec3(1, 1, 2);
  CHECK(readVolume(folder / "cine", given).grid.size[2] == 30);
}

TEST_CASE("series are listed with modality, description, size, slices and spacing") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(3);
  Slice lone = evenStack(1)[0];
  lone.series = "9.8.7";
  lone.modality = "CT";
  slices.push_back(lone);
  writeSeries(folder.path(), slices);
  const auto series = inspectVolume(folder.path()).series;
  REQUIRE(series.size() == 2);
  CHECK(series[0].modality == "MR");
  CHECK(series[0].description == "MR made by hand");
  CHECK(series[0].slices == 3);
  CHECK(series[0].size == std::array<int, 3>{4, 3, 3});
  CHECK((series[0].spacing - Vec3(0.75, 1.5, 2.5)).norm() < 1e-6);
  CHECK_FALSE(series[0].note.any());
  CHECK(series[1].modality == "CT");
  expectWarning(series[1].note, FindingKind::noVolume, sentence(FindingKind::singleSlice) + ".");
}

TEST_CASE("a description that begins with the modality does not say it twice") {
  const TemporaryFolder folder;  // the descriptions are "made by hand"
  std::vector<Slice> said = evenStack(3), other = evenStack(3);
  for (Slice& s : said) s.modality = "made";
  for (Slice& s : other) s.modality = "MA", s.series = "9.8.7";
  said.insert(said.end(), other.begin(), other.end());
  writeSeries(folder.path(), said);
  const auto series = inspectVolume(folder.path()).series;
  REQUIRE(series.size() == 2);
  CHECK(series[0].description == "made by hand");
  CHECK(series[1].description == "MA made by hand");
}

TEST_CASE("a series without a UID is chosen by an empty one") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(3), other = evenStack(4);
  for (Slice& s : other) s.series = "";
  slices.insert(slices.end(), other.begin(), other.end());
  writeSeries(folder.path(), slices);
  CHECK_THAT(sentence(inspectVolume(folder.path()).warnings.back()), Contains("\"\" (MR"));
  VolumeSelection chosen;
  chosen.series = "";
  CHECK(readVolume(folder.path(), chosen).grid.size[2] == 4);
}

TEST_CASE("a slice cut within its first 132 bytes is not dropped silently") {
  const TemporaryFolder folder;
  writeSeries(folder.path(), evenStack(4));
  const std::string bytes = readBytes(folder / "1000");  // the first in space: no gap would show
  for (const std::size_t n : {0u, 1u, 50u, 128u, 131u}) {
    INFO(n);
    writeBytes(folder / "1000", bytes.substr(0, n));
    expectInputError(folder.path(), "1000 is truncated");
  }
}

TEST_CASE("files that are not DICOM are named in a warning") {
  const TemporaryFolder folder;
  writeSeries(folder.path(), evenStack(4));
  writeBytes(folder / "notes.txt", "something else");
  expectWarning(inspectVolume(folder.path()), FindingKind::fileNotDicom,
                "1 file in the folder is not DICOM and left out: notes.txt.");
  writeBytes(folder / "a.txt", "something else");
  expectWarning(inspectVolume(folder.path()), FindingKind::filesNotDicom,
                "2 files in the folder are not DICOM and left out: a.txt, notes.txt.");
  for (const char* name : {"b.txt", "c.txt", "d.txt"}) writeBytes(folder / name, "something else");
  expectWarning(inspectVolume(folder.path()), FindingKind::filesNotDicomAndMore,
                "5 files in the folder are not DICOM and left out: a.txt, b.txt, c.txt and 2 more.");
}

TEST_CASE("a truncated slice of another series does not keep one from being read") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(3);
  Slice other = evenStack(1)[0];
  other.series = "9.8.7";
  slices.push_back(other);
  writeSeries(folder.path(), slices);
  const std::string bytes = readBytes(folder / "997");
  writeBytes(folder / "997", bytes.substr(0, bytes.size() - 4));
  VolumeSelection first;
  first.series = "1.2.3.4";
  CHECK(readVolume(folder.path(), first).grid.size[2] == 3);
  expectAmong(inspectVolume(folder.path(), first), FindingKind::otherFileDamaged,
              "1 file of other series is truncated or damaged.");
}

TEST_CASE("bits beside the stored ones are no part of a value") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = evenStack(3);
  writeSeries(folder.path(), slices);
  for (int i = 0; i < 3; ++i) {
    const std::string file = folder / std::to_string(1000 - i);
    std::string bytes = readBytes(file);
    // BitsStored 12, HighBit 11, and overlays in the upper four bits.
    const auto stored = bytes.find(std::string("\x28\0\x01\x01US\x02\0", 8));
    REQUIRE(stored != std::string::npos);
    bytes[stored + 8] = 12;
    bytes[stored + 18] = 11;
    for (std::size_t at = bytes.size() - 23; at < bytes.size(); at += 2)
      bytes[at] = static_cast<char>(bytes[at] | 0x50);
    writeBytes(file, bytes);
  }
  const Volume volume = readVolume(folder.path());
  for (int k = 0; k < 3; ++k) CHECK(volume.data<std::int16_t>()[12 * k] == k);
}
