#include "core/io/report/wall_map.h"

#include <algorithm>
#include <map>

#include "core/io/formats/volume_io.h"
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
  WallMap map{path, sha256OfPath(path), nullptr};
  const Volume labels = readVolume(path, {.decoder = decoder});
  if (labels.grid.size != grid.size)
    throw Told<InputError>(
        Finding(FindingKind::wallsOtherSize,
                {{"file", path}, {"size", written(labels.grid.size)}, {"volume", written(grid.size)}}));
  if (!isSamePlace(grid, labels.grid))
    throw Told<InputError>(Finding(FindingKind::wallsOtherPlace, {{"file", path}}));
  std::vector<bool> voxels(grid.voxelCount());
  visitVoxels(labels, [&](const auto* value) {
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = value[i] != 0;
  });
  if (std::find(voxels.begin(), voxels.end(), true) == voxels.end())
    throw Told<InputError>(Finding(FindingKind::wallsEmpty, {{"file", path}}));
  map.voxels = std::make_shared<const std::vector<bool>>(std::move(voxels));
  return map;
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
