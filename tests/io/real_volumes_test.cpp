// Real files, where the machine has them: the folder in HANDLEBODY_VOLUMES or shared/volumes beside the
// sources.

#include <cstdlib>
#include <iostream>

#include "tests/io/io_test_support.h"

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
  expectInputError(volumes() + "/odd_volumes/nibabel/example_nifti2.nii.gz", "NIfTI-2");
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
