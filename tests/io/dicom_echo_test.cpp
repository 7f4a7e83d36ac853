// Philips' "Cartesian" export of 3D echocardiography: volumes over time in one file, the depth in private
// elements. Written here as QLAB writes it (read off a file of ITK-SNAP's test data).

#include "core/io/formats/time_axis.h"
#include "tests/io/dicom_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! 5 x 4 x 3 voxels; voxel n of volume t holds 60 t + n.
struct Echo {
  int volumes = 4;
  double frameTime = 25;          // ms
  double columnDistance = 0.375;  // cm
  std::string creator = "Philips3D";
  std::uint32_t slices = 3;
  std::string syntax = "1.2.840.10008.1.2.1";

  std::string bytes() const;
};

std::string Echo::bytes() const {
  DicomText meta, data;
  meta.add(2, 0x02, "UI", "1.2.840.113543.6.6.1.3.10002");
  meta.add(2, 0x10, "UI", syntax);
  data.add(8, 0x16, "UI", "1.2.840.113543.6.6.1.3.10002");
  data.add(8, 0x60, "CS", "US");
  data.add(8, 0x70, "LO", "PMS QLAB Cart Export");
  data.add(0x18, 0x1063, "DS", list({frameTime}));
  data.addShort(0x18, 0x6024, 3);
  data.addShort(0x18, 0x6026, 3);
  data.addDouble(0x18, 0x602c, columnDistance);
  data.addDouble(0x18, 0x602e, 0.25);
  data.add(0x20, 0x0e, "UI", "");
  data.addShort(0x28, 0x02, 1);
  data.add(0x28, 0x04, "CS", "MONOCHROME2");
  data.add(0x28, 0x08, "IS", std::to_string(volumes));
  data.addShort(0x28, 0x10, 4);
  data.addShort(0x28, 0x11, 5);
  data.addShort(0x28, 0x100, 8);
  data.addShort(0x28, 0x101, 8);
  data.addShort(0x28, 0x102, 7);
  data.addShort(0x28, 0x103, 0);
  data.add(0x3001, 0x10, "LO", creator);
  data.addLong(0x3001, 0x1001, slices);
  data.addDouble(0x3001, 0x1003, 0.5);
  std::string pixels;
  for (int i = 0; i < 60 * volumes; ++i) pixels += static_cast<char>(i);
  data.add(0x7fe0, 0x10, "OW", pixels);
  return std::string(128, '\0') + "DICM" + meta.bytes + data.bytes;
}

}  // namespace

TEST_CASE("a Cartesian echo of Philips is a volume over time, with its private depth") {
  const TemporaryFolder folder;
  writeBytes(folder / "echo.dcm", Echo().bytes());
  const VolumeInfo info = inspectVolume(folder / "echo.dcm");
  CHECK(info.frames == 4);
  const TimeAxis times = readTimeAxis(folder / "echo.dcm");
  CHECK(times.milliseconds == std::vector<double>{0, 25, 50, 75});
  CHECK(times.source == "FrameTime (0018,1063)");
  CHECK(info.calibrated);
  VolumeSelection last;
  last.frame = 3;
  const Volume volume = readVolume(folder / "echo.dcm", last);
  CHECK(volume.type == VoxelType::uint8);
  CHECK(volume.grid.size == std::array<int, 3>{5, 4, 3});
  CHECK((volume.grid.spacing - Vec3(3.75, 2.5, 5)).norm() < 1e-9);
  CHECK(volume.grid.origin.norm() < 1e-9);
  CHECK((volume.grid.direction - Eigen::Matrix3d(Vec3(-1, 1, -1).asDiagonal())).norm() < 1e-9);
  for (int i = 0; i < 60; ++i) REQUIRE(int{volume.data<std::uint8_t>()[i]} == 180 + i);
  expectAmong(info, FindingKind::patientPlaceAssumed,
              "The file does not say how the volume lies in the patient: columns are taken to run to the "
              "right, rows to the back and slices downwards.");
}

TEST_CASE("a Cartesian echo that breaks off keeps its whole volumes and says so") {
  const TemporaryFolder folder;
  const std::string path = folder / "echo.dcm", whole = Echo().bytes();
  for (const auto& [missing, left] : {std::pair{1u, 3}, {59u, 3}, {61u, 2}, {179u, 1}}) {
    INFO(missing);
    writeBytes(path, whole.substr(0, whole.size() - missing));
    const VolumeInfo info = inspectVolume(path);
    CHECK(info.frames == left);
    const std::string are = left == 1 ? "one is" : std::to_string(left) + " are";
    expectWarning(info.warnings.at(0), left == 1 ? FindingKind::breaksOffAfterOne : FindingKind::breaksOff,
                  "The file breaks off: its header declares 4 time points, and only the first " + are +
                      " there in full.");
    VolumeSelection last;
    last.frame = left - 1;
    CHECK(int{readVolume(path, last).data<std::uint8_t>()[59]} == 60 * left - 1);
  }
  writeBytes(path, whole.substr(0, whole.size() - 181));
  expectInputError(path, "truncated or damaged");
}

TEST_CASE("what is no Cartesian echo, or a damaged one, is refused as before") {
  const TemporaryFolder folder;
  const std::string path = folder / "echo.dcm";
  Echo foreign;
  foreign.creator = "Somebody";
  writeBytes(path, foreign.bytes());
  expectInputError(path, "cine", true);
  for (const std::uint32_t slices : {0u, 1u, 5000u, 0xffffffffu}) {
    Echo damaged;
    damaged.slices = slices;
    writeBytes(path, damaged.bytes());
    expectInputError(path, "cine", true);
  }
  for (const double distance : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    Echo damaged;
    damaged.columnDistance = distance;
    writeBytes(path, damaged.bytes());
    expectInputError(path, "cine", true);
  }
  Echo deeper;  // more than the pixels hold
  deeper.slices = 300;
  writeBytes(path, deeper.bytes());
  expectInputError(path, "truncated or damaged", true);
}
