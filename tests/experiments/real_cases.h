#pragma once
// The real volumes that tests grow in, where the machine has them: the folder in HANDLEBODY_VOLUMES, or
// shared/volumes beside the sources.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"

namespace handlebody::testing {

struct RealCase {
  const char* name;
  const char* volume;
  Vec3 seedIndex;
  double radiusVoxels;
  ObjectKind object;
  const char* label;  // or null
};

inline const RealCase kCases[] = {
    {"us_vessel", "us_liver_invivo/liver_us_1mm.mha", {148, 101, 84}, 3, ObjectKind::dark, nullptr},
    {"ventricle", "mr_t1_head/MR.nii.gz", {76, 140, 75}, 2, ObjectKind::dark, nullptr},
    {"trachea", "ct_thorax_cta/ct_thorax_1p5mm.nii.gz", {44, 65, 140}, 3, ObjectKind::dark, nullptr},
    {"aorta",
     "ct_thorax_cta/ct_thorax_1p5mm.nii.gz",
     {61, 72, 140},
     3,
     ObjectKind::bright,
     "ct_thorax_cta/label_aorta_true_lumen.nii.gz"},
    {"cord",
     "mr_spinalcord/t2.nii.gz",
     {32, 20, 26},
     2,
     ObjectKind::dark,
     "mr_spinalcord/t2_seg-manual.nii.gz"},
};

inline std::string folder() {
  if (const char* set = std::getenv("HANDLEBODY_VOLUMES")) return set;
  return std::string(HANDLEBODY_SOURCE_DIR) + "/../shared/volumes";
}

inline double dice(const TriangleSoup& mesh, const Volume& label) {
  const Volume mine = rasterize(mesh, label.grid);
  double both = 0, sum = 0;
  visitVoxels(label, [&](const auto* truth) {
    for (std::size_t i = 0; i < label.grid.voxelCount(); ++i) {
      const bool a = mine.data<std::uint8_t>()[i] != 0, b = truth[i] > 0;
      both += a && b;
      sum += static_cast<double>(a) + static_cast<double>(b);
    }
  });
  return 2 * both / sum;
}

inline const RealCase& caseOf(const std::string& name) {
  return *std::find_if(std::begin(kCases), std::end(kCases),
                       [&](const RealCase& r) { return name == r.name; });
}

inline bool volumesMissing() {
  if (std::filesystem::exists(folder() + "/cases.json")) return false;
  std::cout << "SKIPPED: no real volumes at " << folder() << " (set HANDLEBODY_VOLUMES)\n";
  return true;
}

}  // namespace handlebody::testing
