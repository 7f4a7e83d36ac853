#include "core/io/report/wall_map.h"

#include <cmath>
#include <map>

#include "core/io/report/label_file.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

constexpr double kSameGrid = 0.1;  // voxels at the volume's corners; formats round their headers

std::string written(const std::array<int, 3>& size) {
  return std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2]);
}

bool isSamePlace(const Grid& a, const Grid& b) {
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis) index[axis] = (corner >> axis & 1) * (a.size[axis] - 1.0);
    if ((a.toWorld(index) - b.toWorld(index)).norm() > kSameGrid * a.spacing.minCoeff()) return false;
  }
  return true;
}

void requireFits(const VolumeInfo& labels, const std::string& path, const Grid& grid) {
  if (labels.frames > 1)
    throw Told<InputError>(Finding(FindingKind::wallsOverTime, {{"file", path}, {"frames", labels.frames}}));
  if (labels.grid.size != grid.size)
    throw Told<InputError>(
        Finding(FindingKind::wallsOtherSize,
                {{"file", path}, {"size", written(labels.grid.size)}, {"volume", written(grid.size)}}));
  if (!isSamePlace(grid, labels.grid))
    throw Told<InputError>(Finding(FindingKind::wallsOtherPlace, {{"file", path}}));
}

//! Those of a mask, one per voxel of the grid that it was cut from.
std::vector<bool> voxelsOf(const Mask& mask, const Grid& grid) {
  std::vector<bool> voxels(grid.voxelCount());
  const Vec3 first = grid.toIndex(mask.grid.origin);
  const int low[] = {static_cast<int>(std::lround(first.x())), static_cast<int>(std::lround(first.y())),
                     static_cast<int>(std::lround(first.z()))};
  const auto place = [&](int axis, int index) {
    return static_cast<std::size_t>(low[axis]) + static_cast<std::size_t>(index);
  };
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  for (int z = 0; z < mask.grid.size[2]; ++z)
    for (int y = 0; y < mask.grid.size[1]; ++y)
      for (int x = 0; x < mask.grid.size[0]; ++x)
        voxels[(place(2, z) * ny + place(1, y)) * nx + place(0, x)] = mask.inside[mask.at(x, y, z)] != 0;
  return voxels;
}

void load(Constraints& constraints, const Grid& grid, const DecoderSettings& decoder,
          std::map<std::string, WallMap>& known) {
  std::optional<WallMap>& map = constraints.walls.map;
  if (!map || map->voxels) return;
  auto at = known.find(map->path);
  if (at == known.end()) at = known.emplace(map->path, readWallMap(map->path, grid, decoder)).first;
  if (!map->sha256.empty() && map->sha256 != at->second.sha256 && !hashOfPath(map->path).is(map->sha256))
    throw Told<InputError>(Finding(FindingKind::wallsChanged, {{"file", map->path}}));
  map = at->second;
}

}  // namespace

WallMap readWallMap(const std::string& path, const Grid& grid, const DecoderSettings& decoder) {
  const std::string hash = sha256OfPath(path);
  LabelFile labels(path, decoder);
  requireFits(labels.info(), path, grid);
  const Mask mask = labels.mask(std::nullopt);
  if (mask.inside.empty()) throw Told<InputError>(Finding(FindingKind::wallsEmpty, {{"file", path}}));
  return {path, hash, std::make_shared<const std::vector<bool>>(voxelsOf(mask, labels.info().grid)),
          labels.warnings()};
}

void loadWalls(Session& session, const Grid& grid) {
  std::map<std::string, WallMap> known;
  const auto loadThose = [&](Constraints& constraints) {
    load(constraints, grid, session.volume.selection.decoder, known);
  };
  loadThose(session.constraints);
  for (ParameterChange& change : session.changes)
    if (change.constraints) loadThose(*change.constraints);
  if (!session.overTime) return;
  for (FrameCorrection& c : session.overTime->corrections) {
    loadThose(c.request.constraints);
    for (ParameterChange& change : c.changes)
      if (change.constraints) loadThose(*change.constraints);
  }
}

}  // namespace handlebody
