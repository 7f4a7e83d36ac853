#include "core/evolution/region_levels.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/evolution/edge_profile.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

//! The object's cells as voxels of a volume of cells, with the faces between them and the rest.
ObjectRegion facesOf(const WorkImage& work, const Region& region) {
  ObjectRegion out;
  const CellGrid& cells = work.cells();
  const auto& n = cells.grid.size;
  std::size_t i = 0;
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x, ++i) {
        if (!region.inside[i]) continue;
        const ObjectRegion::Voxel v{x, y, z};
        bool isListed = false;
        for (std::int8_t a = 0; a < 3; ++a)
          for (const std::int8_t step : {std::int8_t{-1}, std::int8_t{1}}) {
            ObjectRegion::Voxel w = v;
            w[a] += step;
            if (w[a] < 0 || w[a] >= n[a]) continue;
            const std::size_t j = cells.at(w);
            if (region.inside[j] || work.image.padding[j]) continue;
            if (!isListed) out.voxels.push_back(v);
            isListed = true;
            out.faces.push_back({static_cast<std::int32_t>(out.voxels.size()) - 1, a, step});
          }
      }
  return out;
}

SmoothedVolume asVolume(const WorkImage& work) {
  void* buffer = nullptr;
  Volume pooled = makeVolume(work.cells().grid, VoxelType::float32, &buffer);
  std::copy(work.values.begin(), work.values.end(), static_cast<float*>(buffer));
  return SmoothedVolume(std::move(pooled), 0);
}

std::shared_ptr<const LevelField> spread(const LevelField::Samples& samples, const Grid& grid) {
  return std::make_shared<LevelField>(samples.empty() ? LevelField(grid, 0) : samples.spread());
}

}  // namespace

RegionLevels levelsOn(const WorkImage& work, const Region& region, const Grid& grid,
                      const KnownLevel& known) {
  const Grid& cells = work.cells().grid;
  const bool same = grid.size == cells.size && grid.origin == cells.origin;
  const SmoothedVolume volume = asVolume(work);
  const EdgeReader rising(volume, 1), falling(volume, -1);
  LevelField::Samples high(grid), low(grid), side(grid);
  const ObjectRegion voxels = facesOf(work, region);
  std::vector<double> steps;
  double sides = 0;
  for (const ObjectRegion::Face& face : voxels.faces) {
    const ObjectRegion::Voxel& v = voxels.voxels[face.voxel];
    const auto rise = rising.halfWay(v, face), fall = falling.halfWay(v, face);
    if (!rise && !fall) continue;
    const bool rises = !fall || (rise && rise->step >= fall->step);
    const ImageEdge& e = rises ? *rise : *fall;
    const Vec3 place = same ? e.place : grid.toIndex(cells.toWorld(e.place));
    const double weight = e.step * e.step;
    const std::optional<double> kept = known ? known(cells.toWorld(e.place), rises) : std::nullopt;
    if (rises)
      high.add(place, kept.value_or(e.level), weight);
    else
      low.add(place, kept.value_or(-e.level), weight);
    side.add(place, rises ? 1 : -1, weight);
    sides += rises ? weight : -weight;
    steps.push_back(e.step);
  }
  RegionLevels out{spread(high, grid), spread(low, grid), spread(side, grid)};
  out.kind = sides >= 0 ? ObjectKind::dark : ObjectKind::bright;
  if (!steps.empty()) out.halfStep = quantile(std::move(steps), 0.5);
  return out;
}

}  // namespace handlebody
