#include "core/measure/object_measures.h"

#include "core/phase.h"

namespace handlebody {

ObjectMeasures objectMeasures(const TriangleSoup& mesh, const Volume* volume) {
  const Phase phase("measures");
  ObjectMeasures m{shapeMeasures(mesh)};
  if (!volume) return m;
  const IntensityInside& in = m.intensity.emplace(intensityInside(mesh, *volume));
  if (!in.isWhole) m.warnings.push_back(FindingKind::surfacePartlyOutside);
  if (in.withoutValue > 0)
    m.warnings.push_back({FindingKind::voxelsWithoutValue, {{"voxels", in.withoutValue}}});
  if (in.voxels == 0) m.warnings.push_back(FindingKind::noVoxelInside);
  return m;
}

}  // namespace handlebody
