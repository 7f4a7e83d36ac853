// Real files, where the machine has them: the folder in HANDLEBODY_VOLUMES or shared/volumes beside the
// sources.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "tests/io/dicom_test_support.h"
#include "tests/io/peak_memory.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

std::string volumes() {
  if (const char* set = std::getenv("HANDLEBODY_VOLUMES")) return set;
  return std::string(HANDLEBODY_SOURCE_DIR) + "/../shared/volumes";
}

bool skipped() {
  if (fs::exists(volumes() + "/cases.json")) return false;
  std::cout << "SKIPPED: no real volumes at " << volumes() << " (set HANDLEBODY_VOLUMES)\n";
  return true;
}

void expectGrid(const std::string& name, VoxelType type, std::array<int, 3> size, const Vec3& spacing) {
  INFO(name);
  const Volume volume = readVolume(volumes() + "/" + name);
  CHECK(volume.type == type);
  CHECK(volume.grid.size == size);
  CHECK((volume.grid.spacing - spacing).norm() < 1e-3);
}

}  // namespace

TEST_CASE("the real cases open with their size, type and spacing") {
  if (skipped()) return;
  expectGrid("us_liver_invivo/liver_us_1mm.mha", VoxelType::uint8, {235, 189, 141}, Vec3(1, 1, 1));
  expectGrid("mr_t1_head/MR.nii.gz", VoxelType::float32, {160, 232, 160}, Vec3(1, 0.898437, 0.898437));
  expectGrid("ct_thorax_cta/ct_thorax_1p5mm.nii.gz", VoxelType::int16, {120, 126, 164}, Vec3(1.5, 1.5, 1.5));
  expectGrid("mr_spinalcord/t2.nii.gz", VoxelType::int16, {60, 55, 52}, Vec3(1, 1, 1));
  expectGrid("ct_head_small_dicom", VoxelType::int16, {64, 64, 93}, Vec3(3.2, 3.2, 1.5));
  expectGrid("ct_abdomen_dicom_j2k", VoxelType::int16, {512, 512, 20}, Vec3(0.976562, 0.976562, 2));
  expectGrid("us_liver_invivo/liver_enhanced_us_volume_rle.dcm", VoxelType::uint8, {260, 210, 156},
             Vec3(0.9, 0.9, 0.9));
  expectGrid("ct_head_ge_tilt_nonuniform", VoxelType::int16, {512, 611, 37}, Vec3(0.48828, 0.48828, 4.002));
  expectGrid("mr_oblique_dicom", VoxelType::int16, {256, 256, 20}, Vec3(0.859375, 0.859375, 7.0));
}

TEST_CASE("the same data in two formats give the same volume in the same place") {
  if (skipped()) return;
  const std::pair<std::string, std::string> pairs[] = {
      {"mra_vessels/avf_float_32.nii.gz", "mra_vessels/avf_float_32.nrrd"},
      {"odd_dicom_shared/dcmqi_24x38x3/image", "odd_dicom_shared/dcmqi_24x38x3/nrrd/label.nrrd"}};
  for (const auto& [first, second] : pairs) {
    INFO(first);
    const Volume a = readVolume(volumes() + "/" + first), b = readVolume(volumes() + "/" + second);
    CHECK(a.grid.size == b.grid.size);
    const Vec3 corner(a.grid.size[0], a.grid.size[1], a.grid.size[2]);
    CHECK((a.grid.toWorld(Vec3(0, 0, 0)) - b.grid.toWorld(Vec3(0, 0, 0))).norm() < 1e-3);
    CHECK((a.grid.toWorld(corner) - b.grid.toWorld(corner)).norm() < 1e-3);
    visitVoxels(a, [&](const auto* va) {
      visitVoxels(b, [&](const auto* vb) {
        std::size_t different = 0;
        for (std::size_t i = 0; i < a.grid.voxelCount(); ++i)
          different += static_cast<double>(va[i]) != static_cast<double>(vb[i]);
        CHECK(different == 0);
      });
    });
  }
}

TEST_CASE("labels lie on the grid of their volume") {
  if (skipped()) return;
  const Grid a = inspectVolume(volumes() + "/ct_thorax_cta/ct_thorax_1p5mm.nii.gz").grid;
  const Grid b = inspectVolume(volumes() + "/ct_thorax_cta/label_aorta_true_lumen.nii.gz").grid;
  CHECK(a.size == b.size);
  CHECK((a.origin - b.origin).norm() < 1e-3);
  CHECK((a.direction - b.direction).norm() < 1e-5);
}

TEST_CASE("what is not supported yet is refused with one sentence") {
  if (skipped()) return;
  expectInputError(volumes() + "/odd_volumes/rgb2d_spine_report.nii.gz", "2D image");
  expectInputError(volumes() + "/odd_volumes/vtkdata/FullHead.mhd", "is missing");
  expectInputError(volumes() + "/odd_volumes/lfs_pointer/17.nii.gz", "Git LFS pointer");
}

TEST_CASE("every odd file is read or refused with one line that begins with its path") {
  if (skipped()) return;
  int refused = 0;
  for (const char* folder : {"/odd_volumes", "/odd_dicom_shared"})
    for (const auto& entry : fs::recursive_directory_iterator(volumes() + folder)) {
      const std::string path = entry.path().string();
      INFO(path);
      try {
        const Volume volume = readVolume(path);
        CHECK(volume.grid.voxelCount() > 0);
      } catch (const InputError& e) {
        ++refused;
        CHECK(std::string(e.what()).rfind(path, 0) == 0);
        CHECK(std::string(e.what()).find('\n') == std::string::npos);
      }
    }
  CHECK(refused > 50);
}

namespace {

//! A volume of two slices: the file, and the file with another position of the same length.
void writePair(const std::string& file, const std::string& folder) {
  std::string bytes = readBytes(file);
  const auto at = bytes.find("\\4.700000");
  REQUIRE(at != std::string::npos);
  fs::create_directory(folder);
  writeBytes(folder + "/1", bytes);
  bytes.replace(at, 9, "\\9.700000");
  writeBytes(folder + "/2", bytes);
}

//! Mean and largest difference of two volumes' voxels.
std::pair<double, double> difference(const Volume& a, const Volume& b) {
  double sum = 0, largest = 0;
  visitVoxels(a, [&](const auto* va) {
    visitVoxels(b, [&](const auto* vb) {
      for (std::size_t i = 0; i < a.grid.voxelCount(); ++i) {
        const double d = std::abs(static_cast<double>(va[i]) - static_cast<double>(vb[i]));
        sum += d;
        largest = std::max(largest, d);
      }
    });
  });
  return {sum / static_cast<double>(a.grid.voxelCount()), largest};
}

}  // namespace

TEST_CASE("one CT slice in every transfer syntax gives the same pixels, lossy ones nearly") {
  if (skipped()) return;
  const std::string source = volumes() + "/odd_dicom_shared/ct_all_transfer_syntaxes/CTImage.dcm_";
  const TemporaryFolder folder;
  writePair(source + "LittleEndianExplicitTransferSyntax_1.2.840.10008.1.2.1.dcm", folder / "plain");
  const Volume plain = readVolume(folder / "plain");
  REQUIRE(plain.grid.size == std::array<int, 3>{512, 512, 2});
  for (const char* name : {"BigEndianExplicitTransferSyntax_1.2.840.10008.1.2.2",
                           "LittleEndianImplicitTransferSyntax_1.2.840.10008.1.2",
                           "RLELosslessTransferSyntax_1.2.840.10008.1.2.5",
                           "JPEG2000LosslessOnlyTransferSyntax_1.2.840.10008.1.2.4.90",
                           "JPEGLSLosslessTransferSyntax_1.2.840.10008.1.2.4.80",
                           "JPEGProcess14SV1TransferSyntax_1.2.840.10008.1.2.4.70",
                           "JPEGProcess14TransferSyntax_1.2.840.10008.1.2.4.57"}) {
    INFO(name);
    writePair(source + name + ".dcm", folder / name);
    const Volume volume = readVolume(folder / name);
    CHECK(volume.type == plain.type);
    CHECK((voxelBytes(volume) == voxelBytes(plain)));
  }
  for (const char* name : {"JPEG2000TransferSyntax_1.2.840.10008.1.2.4.91",
                           "JPEGLSLossyTransferSyntax_1.2.840.10008.1.2.4.81"}) {
    INFO(name);
    writePair(source + name + ".dcm", folder / name);
    CHECK(difference(readVolume(folder / name), plain).first < 10);  // of some 4000 grey values
  }
}

TEST_CASE("the same CT as slices, as a multi-frame file and as NRRD lies in the same place") {
  if (skipped()) return;
  const std::string base = volumes() + "/odd_dicom_shared/dcmqi_24x38x3/";
  const Volume slices = readVolume(base + "image"), frames = readVolume(base + "multiframe/mf.dcm"),
               segmented = readVolume(base + "seg/label.seg");
  const Volume label = readVolume(base + "nrrd/label.nrrd");
  for (const Volume* v : {&frames, &segmented, &label}) {
    CHECK(v->grid.size == slices.grid.size);
    CHECK((v->grid.toWorld(Vec3(23, 37, 2)) - slices.grid.toWorld(Vec3(23, 37, 2))).norm() < 1e-3);
  }
  CHECK(difference(frames, slices).second == 0);
}

namespace {

//! All files and folders that somebody may want to open.
std::vector<std::string> everyPath() {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(volumes())) {
    const std::string path = entry.path().string();
    const bool slice = path.find("headsq/quarter.") != std::string::npos && !path.ends_with(".nhdr");
    if (entry.is_directory() ||
        (entry.is_regular_file() && !slice && !path.ends_with(".txt") && !path.ends_with(".json")))
      paths.push_back(path);
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

long memoryOfInfo(const std::string& path) { return memoryOf({HANDLEBODY_CLI, "info", path}).peak; }

//! kB of the voxels of one time point; 0 if it is refused.
double honestSize(const std::string& path) try {
  const VolumeInfo info = inspectVolume(path);
  return static_cast<double>(info.grid.voxelCount() * bytesPerVoxel(info.type)) / 1024;
} catch (const InputError&) {
  return 0;
}

}  // namespace

TEST_CASE(
    "every volume of the machine opens with its geometry or is refused with file and cause: the table") {
  if (skipped()) return;
  const std::vector<std::string> paths = everyPath();
  int opened = 0, refused = 0;
  for (const std::string& path : paths) {
    const auto start = std::chrono::steady_clock::now();
    std::string line;
    try {
      const LoadedVolume loaded = loadVolume(path);
      const Grid& g = loaded.volume.grid;
      line = std::to_string(g.size[0]) + " x " + std::to_string(g.size[1]) + " x " +
             std::to_string(g.size[2]) + (loaded.info.calibrated ? "" : ", uncalibrated");
      for (const std::string& source : loaded.info.sources.spacing) CHECK_FALSE(source.empty());
      ++opened;
    } catch (const InputError& error) {
      line = error.what();
      INFO(line);
      // The file itself, or of a folder over time the one that does not go with the others.
      const auto named = line.substr(0, line.find(": "));
      CHECK((named == path || std::filesystem::path(named).parent_path() == path));
      CHECK(line.find('\n') == std::string::npos);
      line = line.substr(std::min(line.size(), named.size() + 2));
      CHECK(line.size() > 10);
      ++refused;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    CHECK(seconds.count() < 10);
    std::cout << path.substr(volumes().size() + 1) << "\t" << line << "\n";
  }
  std::cout << opened << " opened, " << refused << " refused\n";
  CHECK(opened >= 50);
}

TEST_CASE("no file of the machine takes more than three times its honest size of memory", "[.][slow]") {
  if (skipped()) return;
  // What the program and its decoder take for a volume of nothing. Memory is looked at now and then: on a
  // busy machine one look may miss the moment when both have most.
  const TemporaryFolder folder;
  writeSeries(folder / "series", evenStack(3));
  long rest = 0;
  for (int look = 0; look < 20; ++look) rest = std::max(rest, memoryOfInfo(folder / "series"));
  REQUIRE(rest > 0);
  double worst = 0;
  for (const std::string& path : everyPath()) {
    const double honest = honestSize(path);
    const double taken = static_cast<double>(memoryOfInfo(path) - rest);
    INFO(path << ": " << taken << " kB for " << honest << " kB of voxels");
    // A header's and a heap's own unevenness; a refused file has no size to its credit.
    constexpr double kUneven = 16 * 1024;
    CHECK(taken <= 3 * honest + kUneven);
    if (honest > kUneven) worst = std::max(worst, taken / honest);
    std::cout << path.substr(volumes().size() + 1) << "\t" << std::lround(honest) << "\t"
              << std::lround(taken) << "\n";
  }
  std::cout << "program and decoder at rest: " << rest << " kB; at most " << worst << " times the size\n";
}
