// Grows a surface in an array of voxels: a dark ball of 10 mm radius, seeded in its middle.
#include <algorithm>
#include <iostream>

#include "core/evolution/active_contour.h"
#include "core/mesh/topology.h"
#include "core/version.h"

using namespace handlebody;

int main() {
  Grid grid;  // 41 x 41 x 41 voxels of 1 mm
  grid.size = {41, 41, 41};
  void* voxels = nullptr;
  const Volume volume = makeVolume(grid, VoxelType::float32, &voxels);
  auto* value = static_cast<float*>(voxels);  // x runs fastest
  for (int k = 0; k < 41; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i) {
        const double outside = (grid.toWorld(Vec3(i, j, k)) - Vec3(20, 20, 20)).norm() - 10;  // mm
        *value++ = static_cast<float>(20 + 180 * std::clamp(outside + 0.5, 0.0, 1.0));
      }
  ActiveContour contour(volume, {Seed{Vec3(20, 20, 20), 3.0}}, {});
  while (contour.stopReason() == StopReason::running) contour.step();
  std::cout << "Handlebody " HANDLEBODY_VERSION ": " << stopReasonName(contour.stopReason()) << " after "
            << contour.iteration() << " iterations: " << contour.mesh().vertexCount() << " vertices, genus "
            << topologyNumbers(contour.mesh()).genus << ", " << signedVolume(contour.mesh()) << " mm3\n";
}
