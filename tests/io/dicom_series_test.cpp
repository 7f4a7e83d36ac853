// Several stacks under one SeriesInstanceUID: told apart, listed, chosen.

#include "tests/io/dicom_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Axial slices at these heights, with these values from `first` on.
std::vector<Slice> axial(const std::vector<double>& heights, int first = 0, int acquisition = 1) {
  std::vector<Slice> slices;
  for (double z : heights) {
    Slice s;
    s.position = Vec3(0, 0, z);
    s.value = static_cast<std::int16_t>(first + static_cast<int>(slices.size()));
    s.number = first + static_cast<int>(slices.size());
    s.acquisition = acquisition;
    slices.push_back(s);
  }
  return slices;
}

std::vector<Slice> together(std::vector<Slice> a, const std::vector<Slice>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

VolumeSelection chosen(const std::string& series) {
  VolumeSelection selection;
  selection.series = series;
  return selection;
}

//! Nothing is opened unasked; the two stacks are listed, with what tells them apart.
std::vector<SeriesInfo> expectTwoStacks(const std::string& folder) {
  expectInputError(folder, "choose one with --series: 1.2.3.4#1 (", true);
  expectInputError(folder, "; 1.2.3.4#2 (", true);
  const VolumeInfo info = inspectVolume(folder);
  CHECK(info.frames == 0);
  REQUIRE(info.series.size() == 2);
  CHECK(info.series[0].uid == "1.2.3.4#1");
  CHECK(info.series[1].uid == "1.2.3.4#2");
  CHECK(inspectVolume(folder, chosen("1.2.3.4")).series.size() == 2);
  CHECK_THROWS_AS(readVolume(folder, chosen("1.2.3.4")), InputError);
  CHECK_THROWS_AS(readVolume(folder, chosen("1.2.3.4#3")), UsageError);
  return info.series;
}

void expectValues(const std::string& folder, const std::string& series, int slices, double spacing,
                  int first) {
  INFO(series);
  const Volume volume = readVolume(folder, chosen(series));
  CHECK(volume.grid.size[2] == slices);
  CHECK(volume.grid.spacing.z() == Approx(spacing));
  const std::size_t n = static_cast<std::size_t>(volume.grid.size[0] * volume.grid.size[1]);
  for (int k = 0; k < slices; ++k)
    CHECK(volume.data<std::int16_t>()[n * static_cast<std::size_t>(k)] == first + k);
}

}  // namespace

TEST_CASE("images of different size under one UID are two stacks to choose from") {
  const TemporaryFolder folder;
  std::vector<Slice> larger = axial({0, 2, 4, 6}, 10);
  for (Slice& s : larger) s.rows = 5;
  writeSeries(folder.path(), together(axial({0, 2, 4}), larger));
  const auto series = expectTwoStacks(folder.path());
  CHECK(series[0].size == std::array<int, 3>{4, 3, 3});
  CHECK(series[1].size == std::array<int, 3>{4, 5, 4});
  CHECK(series[1].slices == 4);
  CHECK(series[1].files == 4);
  expectValues(folder.path(), "1.2.3.4#1", 3, 2, 0);
  expectValues(folder.path(), "1.2.3.4#2", 4, 2, 10);
}

TEST_CASE("two pixel spacings and two orientations under one UID are two stacks to choose from") {
  const TemporaryFolder folder;
  std::vector<Slice> other = axial({0, 2, 4, 6}, 10);
  SECTION("pixel spacing") {
    for (Slice& s : other) s.spacing = "1.5\\0.8";
  }
  SECTION("orientation") {
    for (Slice& s : other) {
      s.direction = Eigen::AngleAxisd(1.5707963267948966, Vec3(1, 0, 0)).toRotationMatrix();
      s.position = s.position.z() * s.direction.col(2);
    }
  }
  writeSeries(folder.path(), together(axial({0, 2, 4}), other));
  expectTwoStacks(folder.path());
  expectValues(folder.path(), "1.2.3.4#1", 3, 2, 0);
  expectValues(folder.path(), "1.2.3.4#2", 4, 2, 10);
}

TEST_CASE("a localizer in the series is listed as no volume, and does not keep the stack from being chosen") {
  const TemporaryFolder folder;
  std::vector<Slice> localizer = axial({0}, 100);
  localizer[0].direction = Eigen::AngleAxisd(1.5707963267948966, Vec3(1, 0, 0)).toRotationMatrix();
  writeSeries(folder.path(), together(axial({0, 2, 4}), localizer));
  const auto series = expectTwoStacks(folder.path());
  CHECK_FALSE(series[0].note.any());
  expectWarning(series[1].note, FindingKind::noVolume, sentence(FindingKind::singleSlice) + ".");
  expectValues(folder.path(), "1.2.3.4#1", 3, 2, 0);
  CHECK_THROWS_AS(readVolume(folder.path(), chosen("1.2.3.4#2")), InputError);
}

TEST_CASE("two acquisitions of different pitch in the same place are two stacks, not one uneven one") {
  const TemporaryFolder folder;
  SECTION("with acquisition numbers") {
    writeSeries(folder.path(), together(axial({0, 2, 4, 6, 8}), axial({1, 6, 11, 16}, 10, 2)));
  }
  SECTION("without") {
    writeSeries(folder.path(), together(axial({0, 2, 4, 6, 8}), axial({1, 6, 11, 16}, 10)));
  }
  SECTION("with copies of slices") {
    std::vector<Slice> slices = together(axial({0, 2, 4, 6, 8}), axial({1, 6, 11, 16}, 10, 2));
    slices.push_back(slices[2]);
    slices.push_back(slices[7]);
    writeSeries(folder.path(), slices);
  }
  const auto series = expectTwoStacks(folder.path());
  CHECK(series[0].spacing.z() == Approx(2));
  CHECK(series[1].spacing.z() == Approx(5));
  expectValues(folder.path(), "1.2.3.4#1", 5, 2, 0);
  expectValues(folder.path(), "1.2.3.4#2", 4, 5, 10);
}

TEST_CASE("stations side by side are stacks, not time points of the first one's place") {
  const TemporaryFolder folder;
  std::vector<Slice> first = axial({0, 2, 4, 6}), second;
  const auto shift = [&](double mm) {
    for (Slice& s : second) s.position.y() += mm;
  };
  SECTION("one after the other") {
    second = axial({0, 2, 4, 6}, 10);
    shift(200);
    writeSeries(folder.path(), together(first, second));
    expectTwoStacks(folder.path());
    expectValues(folder.path(), "1.2.3.4#1", 4, 2, 0);
    expectValues(folder.path(), "1.2.3.4#2", 4, 2, 10);
    CHECK(readVolume(folder.path(), chosen("1.2.3.4#2")).grid.origin.y() == Approx(200));
  }
  SECTION("with the same pixels") {
    second = axial({0, 2, 4, 6});
    for (Slice& s : second) s.number += 10;
    shift(200);
    writeSeries(folder.path(), together(first, second));
    expectTwoStacks(folder.path());
    expectValues(folder.path(), "1.2.3.4#2", 4, 2, 0);
  }
  SECTION("numbered in turn they cannot be told apart") {
    second = axial({0, 2, 4, 6}, 10);
    for (std::size_t i = 0; i < 4; ++i) {
      first[i].number = static_cast<int>(2 * i);
      second[i].number = static_cast<int>(2 * i + 1);
    }
    shift(200);
    writeSeries(folder.path(), together(first, second));
    expectInputError(folder.path(), "shifted against each other by 200 mm");
  }
  SECTION("what differs by less than a quarter of a pixel does not lie beside") {
    second = axial({0, 2, 4, 6}, 10);
    shift(0.1);
    writeSeries(folder.path(), together(first, second));
    CHECK(inspectVolume(folder.path()).frames == 2);
  }
}

TEST_CASE("two pitches one behind the other are one resampled volume, and two stacks to be had alone") {
  const TemporaryFolder folder;
  writeSeries(folder.path(), together(axial({0, 2, 4, 6}), axial({9, 12, 15}, 4)));
  const VolumeInfo info = inspectVolume(folder.path());
  CHECK(info.grid.size[2] == 8);
  expectAmong(
      info, FindingKind::stacksAlone,
      "Its stacks of one pitch each are to be had alone: 1.2.3.4#1 (4 slices), 1.2.3.4#2 (3 slices).");
  REQUIRE(info.series.size() == 3);
  CHECK(info.series[0].uid == "1.2.3.4");
  CHECK(info.series[0].size[2] == 8);
  CHECK(info.series[1].spacing.z() == Approx(2));
  CHECK(info.series[2].spacing.z() == Approx(3));
  CHECK(readVolume(folder.path(), chosen("1.2.3.4")).grid.size[2] == 8);
  expectValues(folder.path(), "1.2.3.4#1", 4, 2, 0);
  expectValues(folder.path(), "1.2.3.4#2", 3, 3, 4);
  CHECK(inspectVolume(folder.path(), chosen("1.2.3.4#2")).warnings.empty());
}

TEST_CASE("missing slices are gaps of one stack, not several stacks") {
  const TemporaryFolder folder;
  writeSeries(folder.path(), axial({0, 2, 4, 6, 10, 12, 14, 20, 22, 24}));
  const VolumeInfo info = inspectVolume(folder.path());
  CHECK(info.series.size() == 1);
  CHECK(info.series[0].uid == "1.2.3.4");
  expectWarning(
      info, FindingKind::slicesMissingResampled,
      "The slices are unevenly spaced (3 gaps of 2 mm, 1 of 4 mm, 2 of 2 mm, 1 of 6 mm, 2 of 2 mm), 3 "
      "seem to be missing; they were resampled to a distance of 2 mm. What lies in the gaps is "
      "interpolated.");
}

TEST_CASE("a second time point that is not complete is a stack of its own") {
  const TemporaryFolder folder;
  writeSeries(folder.path(), together(axial({0, 2, 4, 6}), axial({0, 2, 4}, 10)));
  expectTwoStacks(folder.path());
  expectValues(folder.path(), "1.2.3.4#2", 3, 2, 10);
}

TEST_CASE("the stacks of one enhanced file are told apart by their StackID") {
  const TemporaryFolder folder;
  Slice s;
  s.frames = 8;
  for (double z : {0.0, 2.0, 4.0, 6.0}) s.framePositions.push_back(Vec3(0, 0, z));
  for (double z : {1.0, 5.0, 9.0, 13.0}) s.framePositions.push_back(Vec3(0, 0, z));
  s.frameStacks = {"1", "1", "1", "1", "2", "2", "2", "2"};
  writeBytes(folder / "multi", dicomBytes(s, "1.2"));
  const auto series = expectTwoStacks(folder / "multi");
  CHECK(series[1].spacing.z() == Approx(4));
  expectValues(folder / "multi", "1.2.3.4#1", 4, 2, 0);
  expectValues(folder / "multi", "1.2.3.4#2", 4, 4, 4);
}

TEST_CASE("clips that do not say where they lie are no stack together") {
  const TemporaryFolder folder;
  Slice clip;
  clip.frames = 5;
  clip.placed = false;
  writeSeries(folder.path(), {clip, clip});
  const auto series = expectTwoStacks(folder.path());
  CHECK(series[0].slices == 5);
  const VolumeInfo info = inspectVolume(folder.path(), chosen("1.2.3.4#2"));
  CHECK(info.grid.size[2] == 5);
  CHECK_FALSE(info.calibrated);
}

TEST_CASE("a reading that needs a choice hands out what there is to choose from") {
  const TemporaryFolder folder;
  writeSeries(folder.path(), together(axial({0, 2, 4, 6, 8}), axial({1, 6, 11, 16}, 10, 2)));
  std::vector<SeriesInfo> series;
  try {
    loadVolume(folder.path());
  } catch (const SeriesChoiceNeeded& choice) {
    series = choice.series;
  }
  REQUIRE(series.size() == 2);
  CHECK(series[1].size == std::array<int, 3>{4, 3, 4});
}

TEST_CASE("a folder of folders is refused with what to open instead") {
  const TemporaryFolder folder;
  writeSeries(folder / "series", axial({0, 2, 4}));
  expectInputError(folder.path(), "open one of its subfolders");
}

TEST_CASE("which stack has which number does not depend on the names of the files") {
  const TemporaryFolder folder;
  std::vector<Slice> slices = together(axial({0, 2, 4, 6, 8}), axial({1, 6, 11, 16}, 10, 2));
  std::reverse(slices.begin(), slices.end());
  writeSeries(folder.path(), slices);
  expectValues(folder.path(), "1.2.3.4#1", 5, 2, 0);
  expectValues(folder.path(), "1.2.3.4#2", 4, 5, 10);
}
