#include <algorithm>
#include <cstdio>

#include "core/io/dicom_geometry.h"
#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

struct Slice {
  std::string series = "1.2.3.4";
  Vec3 position{0, 0, 0};
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();
  std::string spacing = "1.5\\0.75";  // between rows, then between columns
  std::string slope = "1", intercept = "0";
  int frames = 1, columns = 4, rows = 3;
  std::int16_t value = 0;  // of all pixels
};

//! Explicit little-endian data elements.
class DicomText {
 public:
  void add(unsigned group, unsigned element, const std::string& vr, std::string value) {
    if (value.size() % 2) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
    put(group, 2);
    put(element, 2);
    bytes += vr;
    if (vr == "OB" || vr == "OW") {
      put(0, 2);
      put(static_cast<unsigned>(value.size()), 4);
    } else {
      put(static_cast<unsigned>(value.size()), 2);
    }
    bytes += value;
  }
  void addShort(unsigned group, unsigned element, int value) {
    add(group, element, "US", std::string{static_cast<char>(value & 255), static_cast<char>(value >> 8)});
  }
  std::string bytes;

 private:
  void put(unsigned value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
  }
};

std::string list(std::initializer_list<double> values) {
  std::string text;
  for (double v : values) {
    char number[40];
    std::snprintf(number, sizeof number, "%.10g", v);
    text += (text.empty() ? "" : "\\") + std::string(number);
  }
  return text;
}

std::string dicomBytes(const Slice& s, const std::string& instance) {
  DicomText meta;
  meta.add(2, 0x02, "UI", "1.2.840.10008.5.1.4.1.1.4");
  meta.add(2, 0x03, "UI", instance);
  meta.add(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  DicomText data;
  data.add(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.4");
  data.add(8, 0x18, "UI", instance);
  data.add(8, 0x60, "CS", "MR");
  data.add(8, 0x103e, "LO", "made by hand");
  data.add(0x20, 0x0d, "UI", "1.2.3");
  data.add(0x20, 0x0e, "UI", s.series);
  data.add(0x20, 0x32, "DS", list({s.position[0], s.position[1], s.position[2]}));
  const Eigen::Matrix3d& d = s.direction;
  data.add(0x20, 0x37, "DS", list({d(0, 0), d(1, 0), d(2, 0), d(0, 1), d(1, 1), d(2, 1)}));
  data.addShort(0x28, 0x02, 1);
  data.add(0x28, 0x04, "CS", "MONOCHROME2");
  if (s.frames > 1) data.add(0x28, 0x08, "IS", std::to_string(s.frames));
  data.addShort(0x28, 0x10, s.rows);
  data.addShort(0x28, 0x11, s.columns);
  data.add(0x28, 0x30, "DS", s.spacing);
  data.addShort(0x28, 0x100, 16);
  data.addShort(0x28, 0x101, 16);
  data.addShort(0x28, 0x102, 15);
  data.addShort(0x28, 0x103, 1);
  data.add(0x28, 0x1052, "DS", s.intercept);
  data.add(0x28, 0x1053, "DS", s.slope);
  std::string pixels;
  for (int i = 0; i < s.rows * s.columns * s.frames; ++i)
    pixels += {static_cast<char>(s.value & 255), static_cast<char>(s.value >> 8)};
  data.add(0x7fe0, 0x10, "OW", pixels);
  DicomText length;
  const auto n = static_cast<std::uint32_t>(meta.bytes.size());
  length.add(2, 0, "UL", std::string(reinterpret_cast<const char*>(&n), 4));
  return std::string(128, '\0') + "DICM" + length.bytes + meta.bytes + data.bytes;
}

//! An even oblique stack of `count` slices, 2.5 mm apart; slice i holds the value i. File names run against
//! the order in space.
std::vector<Slice> evenStack(int count) {
  std::vector<Slice> slices(static_cast<std::size_t>(count));
  const Eigen::Matrix3d direction = Eigen::AngleAxisd(0.4, Vec3(1, -1, 2).normalized()).toRotationMatrix();
  for (int i = 0; i < count; ++i) {
    Slice& s = slices[static_cast<std::size_t>(i)];
    s.direction = direction;
    s.position = Vec3(-50, 20, 10) + 2.5 * i * direction.col(2);
    s.value = static_cast<std::int16_t>(i);
  }
  return slices;
}

void writeSeries(const std::string& folder, const std::vector<Slice>& slices) {
  fs::create_directories(folder);
  for (std::size_t i = 0; i < slices.size(); ++i)
    writeBytes(folder + "/" + std::to_string(1000 - i),
               dicomBytes(slices[i], slices[i].series + "." + std::to_string(i + 1)));
}

}  // namespace

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
  expectInputError(folder.path(), "1.2.3.4 (MR made by hand, 3 files), 9.8.7 (MR made by hand, 4 files)",
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
  SECTION("a missing slice") {
    slices.erase(slices.begin() + 2);
    refusedFor("unevenly spaced");
  }
  SECTION("two slice distances") {
    for (std::size_t i = 4; i < 6; ++i)
      slices[i].position += (2.5 * static_cast<double>(i - 3)) * slices[0].direction.col(2);
    refusedFor("unevenly spaced");
  }
  SECTION("a slice 0.2 mm off") {
    slices[3].position += 0.2 * slices[0].direction.col(2);
    refusedFor("unevenly spaced");
  }
  SECTION("two slices in one place") {
    slices.push_back(slices[1]);
    refusedFor("same place");
  }
  SECTION("a gantry tilt") {
    for (Slice& s : slices) s.position += 0.1 * s.value * s.direction.col(1);
    refusedFor("tilted");
  }
  SECTION("different orientations") {
    slices[2].direction = Eigen::Matrix3d::Identity();
    refusedFor("orientations");
  }
  SECTION("different sizes") {
    slices[2].rows = 5;
    refusedFor("different sizes");
  }
  SECTION("different pixel spacings") {
    slices[2].spacing = "1.5\\0.8";
    refusedFor("pixel spacings");
  }
  SECTION("no pixel spacing") {
    slices[2].spacing = "";
    refusedFor("does not say where it lies");
  }
  SECTION("several frames in a file") {
    slices[0].frames = 3;
    refusedFor("multi-frame");
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
      REQUIRE(info.warnings.size() == 1);
      REQUIRE_THAT(info.warnings[0], Contains("hold no image"));
      ++warned;
    } catch (const InputError&) {
      SUCCEED();
    }
  }
  // Only where it ends between two elements before its series is named.
  CHECK(warned < 10);
}
