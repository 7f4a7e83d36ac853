// Real volumes, where the machine has them (HANDLEBODY_VOLUMES, or shared/volumes beside the sources):
// whatever the image is like, the mesh that comes out is certified.

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "core/collision/certify.h"
#include "core/evolution/active_contour.h"
#include "core/io/mesh_io.h"
#include "core/io/volume_io.h"
#include "tests/support/catch.h"
#ifdef HANDLEBODY_WITH_ORACLE
#include "tests/collision_oracle/oracle.h"
#endif

using namespace handlebody;

namespace {

struct RealCase {
  const char* name;
  const char* volume;
  Vec3 seedIndex;
  double radiusVoxels;
  ObjectKind object;
  const char* label;  // or null
};

const RealCase kCases[] = {
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

std::string folder() {
  if (const char* set = std::getenv("HANDLEBODY_VOLUMES")) return set;
  return std::string(HANDLEBODY_SOURCE_DIR) + "/../shared/volumes";
}

double dice(const TriangleSoup& mesh, const Volume& label) {
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

void expectCertified(const RealCase& c) {
  INFO(c.name);
  const Volume volume = readVolume(folder() + "/" + c.volume);
  Parameters parameters;
  parameters.object = c.object;
  ActiveContour contour(
      volume, {{volume.grid.toWorld(c.seedIndex), c.radiusVoxels * volume.grid.meanSpacing()}}, parameters);
  while (contour.stopReason() == StopReason::running) contour.step();
  const TriangleSoup mesh = contour.mesh().compact();
  const Certificate certificate = certify(mesh);
  CHECK(certificate.passes());
  CHECK(contour.stopReason() == StopReason::converged);
#ifdef HANDLEBODY_WITH_ORACLE
  CHECK(oracle::selfIntersections(mesh).empty());
#endif
  std::cout << c.name << ": iterations " << contour.iteration() << ", vertices " << certificate.vertices
            << ", components " << certificate.components << ", volume " << certificate.volume / 1000 << " ml";
  if (c.label) std::cout << ", Dice " << dice(mesh, readVolume(folder() + "/" + c.label));
  std::cout << '\n';
}

}  // namespace

TEST_CASE("real volumes give a certified mesh with nothing given but seed and object", "[real]") {
  if (!std::filesystem::exists(folder() + "/cases.json")) {
    std::cout << "SKIPPED: no real volumes at " << folder() << " (set HANDLEBODY_VOLUMES)\n";
    return;
  }
  for (const RealCase& c : kCases) expectCertified(c);
}
