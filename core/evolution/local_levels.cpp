#include "core/evolution/local_levels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstdio>

#include "core/evolution/object_region.h"

namespace handlebody {

namespace {

int kReach = getenv("REACH") ? atoi(getenv("REACH")) : 2;
constexpr int kMostPasses = 8;
// Levels that change by less than this part of the contrast in a pass stay: a fiftieth of the half-step is a
// hundredth of a voxel on an edge of one voxel.
constexpr double kStays = 0.02;
constexpr std::size_t kMostVoxels = 2'000'000;

void addFace(const SmoothedVolume& volume, const ObjectRegion::Face& face, double sign,
             LevelField::Samples& samples) {
  const auto axis = static_cast<std::size_t>(face.axis);
  const int last = volume.grid().size[axis] - 1;
  ObjectRegion::Voxel v = face.inner;
  const auto valueAt = [&](int t) {
    v[axis] = std::clamp(face.inner[axis] + face.step * t, 0, last);
    return sign * static_cast<double>(volume.at(v[0], v[1], v[2]));
  };
  double weight = 0, sum = 0, before = valueAt(-kReach);
  for (int t = 1 - kReach; t <= kReach + 1; ++t) {
    const double here = valueAt(t), step = std::max(0.0, here - before);
    weight += step * step;
    sum += step * step * 0.5 * (here + before);
    before = here;
  }
  if (weight > 0)
    samples.add(Vec3(face.inner[0], face.inner[1], face.inner[2]), sign * sum / weight, weight);
}

}  // namespace

LevelField findLocalLevels(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                           double level, double contrast) {
  LevelField levels(volume.grid(), level);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const ObjectRegion region = floodObject(volume, seeds, sign, levels, kMostVoxels);
    LevelField::Samples samples(volume.grid());
    for (const ObjectRegion::Face& face : region.faces) addFace(volume, face, sign, samples);
    if (samples.empty()) return levels;
    LevelField next = samples.spread();
    double change = 0;
    for (std::size_t i = 0; i < region.faces.size(); i += 16) {
      const ObjectRegion::Voxel& v = region.faces[i].inner;
      const Vec3 at(v[0], v[1], v[2]);
      change += std::abs(next.at(at) - levels.at(at));
    }
    change /= static_cast<double>((region.faces.size() + 15) / 16);
    levels = std::move(next);
    if (getenv("DBG")) fprintf(stderr,"pass %d voxels %zu faces %zu change %g levels %g..%g\n",pass,region.voxels.size(),region.faces.size(),change/contrast,levels.lowest(),levels.highest());
    if (change <= kStays * contrast) break;
  }
  return levels;
}

}  // namespace handlebody
