#include <cmath>

#include "core/mesh/quality.h"
#include "core/solid/label_mesh.h"
#include "core/units.h"

namespace handlebody {

namespace {

Finding volumeWarning(double volume, const Mask& mask) {
  const double voxels = static_cast<double>(mask.count()) * mask.grid.voxelVolume(),
               more = volume / voxels - 1;
  if (!(std::abs(more) > kMuchVolume)) return {};
  return {FindingKind::volumeOffVoxels,
          {{"mesh_ml", (1 + more) * voxels / kMillilitre},
           {"voxels_ml", voxels / kMillilitre},
           {"percent", std::round(100 * more)}}};
}

Finding edgeWarning(const TriangleSoup& mesh, double asked) {
  const double median = meshQuality(mesh).edges.median;
  if (median >= kShortestWanted * asked && median <= kLongestWanted * asked) return {};
  return {FindingKind::edgesNotAsAsked, {{"median_mm", median}, {"asked_mm", asked}}};
}

}  // namespace

std::vector<Finding> labelMeshWarnings(const TriangleSoup& mesh, const Certificate& its, const Mask& mask,
                                       const LabelMeshOptions& options) {
  std::vector<Finding> told;
  if (Finding volume = volumeWarning(its.volume, mask); volume.any()) told.push_back(std::move(volume));
  if (options.edgeLength > 0 && options.smoothing != 0)
    if (Finding edges = edgeWarning(mesh, options.edgeLength); edges.any()) told.push_back(std::move(edges));
  return told;
}

}  // namespace handlebody
