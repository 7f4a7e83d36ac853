#include "core/measure/object_measures.h"

namespace handlebody {

ObjectMeasures objectMeasures(const TriangleSoup& mesh, const Volume* volume) {
  ObjectMeasures m{shapeMeasures(mesh)};
  if (!volume) return m;
  const IntensityInside& in = m.intensity.emplace(intensityInside(mesh, *volume));
  if (!in.isWhole)
    m.warnings.push_back(
        "A part of the surface lies outside of the volume, and intensities are of the rest.");
  if (in.withoutValue > 0)
    m.warnings.push_back(std::to_string(in.withoutValue) +
                         " voxels inside have no finite value and do not count.");
  if (in.voxels == 0) m.warnings.push_back("No voxel with a value has its centre inside.");
  return m;
}

}  // namespace handlebody
