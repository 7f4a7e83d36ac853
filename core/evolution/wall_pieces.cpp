#include "core/evolution/wall_pieces.h"

#include <algorithm>

#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

using Voxels = std::vector<std::size_t>;

std::array<int, 3> voxelAt(const Grid& grid, std::size_t i) {
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  return {static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / nx / ny)};
}

//! The voxels around one, itself too.
template <typename F>
void forEachAround(const Grid& grid, std::size_t i, F&& f) {
  const auto v = voxelAt(grid, i);
  const auto nx = static_cast<std::size_t>(grid.size[0]), ny = static_cast<std::size_t>(grid.size[1]);
  for (int z = std::max(0, v[2] - 1); z <= std::min(grid.size[2] - 1, v[2] + 1); ++z)
    for (int y = std::max(0, v[1] - 1); y <= std::min(grid.size[1] - 1, v[1] + 1); ++y)
      for (int x = std::max(0, v[0] - 1); x <= std::min(grid.size[0] - 1, v[0] + 1); ++x)
        f((static_cast<std::size_t>(z) * ny + static_cast<std::size_t>(y)) * nx +
          static_cast<std::size_t>(x));
}

//! Takes the piece that holds voxel i out of `left`.
Voxels takePiece(std::vector<bool>& left, const Grid& grid, std::size_t i) {
  Voxels piece{i};
  left[i] = false;
  for (std::size_t at = 0; at < piece.size(); ++at)
    forEachAround(grid, piece[at], [&](std::size_t n) {
      if (!left[n]) return;
      left[n] = false;
      piece.push_back(n);
    });
  return piece;
}

WallList ofVoxels(const WallMap& map, const Voxels& voxels) {
  std::vector<bool> flags(map.voxels->size(), false);
  for (const std::size_t i : voxels) flags[i] = true;
  return {{}, WallMap{map.path, {}, std::make_shared<const std::vector<bool>>(std::move(flags))}};
}

Vec3 centreOf(const Grid& grid, std::size_t voxel) {
  const auto v = voxelAt(grid, voxel);
  return grid.toWorld(Vec3(v[0], v[1], v[2]));
}

Walls::Touched touched(const Mesh& mesh, const Walls& walls, bool one) {
  Walls::Touched which;
  std::vector<bool> near(mesh.vertexSlots());
  for (int v = 0; v < mesh.vertexSlots(); ++v) near[v] = mesh.isVertex(v) && walls.isNear(mesh.position(v));
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0 || std::none_of(t.begin(), t.end(), [&](int v) { return near[v]; })) continue;
    const bool here = walls.touches(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]), &which);
    if (here && one) break;
  }
  return which;
}

//! Whether points lie in what a mesh encloses.
class Inside {
 public:
  explicit Inside(const Mesh& mesh) : mesh_(mesh), parts_(findComponents(mesh)) {
    for (int v = 0; v < mesh.vertexSlots(); ++v) {
      if (!mesh.isVertex(v)) continue;
      low_ = low_.cwiseMin(mesh.position(v));
      high_ = high_.cwiseMax(mesh.position(v));
    }
  }
  bool operator()(const Vec3& p) const {
    const bool inBox = (p.array() >= low_.array()).all() && (p.array() <= high_.array()).all();
    return inBox && windingNumber(mesh_, parts_, kNone, p) > 0;
  }

 private:
  static constexpr int kNone = -2;  // no component is left out
  const Mesh& mesh_;
  Components parts_;
  Vec3 low_ = Vec3::Constant(1e300), high_ = Vec3::Constant(-1e300);
};

}  // namespace

std::vector<WallList> piecesOf(const WallList& walls, const Grid& grid) {
  std::vector<WallList> out;
  for (const WallBall& w : walls.balls) out.push_back({{w}, {}});
  for (const WallDisc& d : walls.discs) out.push_back({{}, {}, {}, {d}});
  for (const WallObject& o : walls.objects) out.push_back({{}, {}, {o}});
  if (!walls.map) return out;
  std::vector<bool> left = *walls.map->voxels;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (left[i]) out.push_back(ofVoxels(*walls.map, takePiece(left, grid, i)));
  return out;
}

WallList without(const WallList& walls, const WallList& known) {
  WallList out;
  for (const WallBall& w : walls.balls)
    if (std::find(known.balls.begin(), known.balls.end(), w) == known.balls.end()) out.balls.push_back(w);
  for (const WallDisc& d : walls.discs)
    if (std::find(known.discs.begin(), known.discs.end(), d) == known.discs.end()) out.discs.push_back(d);
  for (const WallObject& o : walls.objects)
    if (std::find(known.objects.begin(), known.objects.end(), o) == known.objects.end())
      out.objects.push_back(o);
  if (!walls.map || walls.map == known.map) return out;
  out.map = walls.map;
  if (!known.map || !known.map->voxels) return out;
  std::vector<bool> left = *walls.map->voxels;
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = left[i] && !(*known.map->voxels)[i];
  const bool any = std::find(left.begin(), left.end(), true) != left.end();
  out.map->voxels = std::make_shared<const std::vector<bool>>(std::move(left));
  if (!any) out.map.reset();
  return out;
}

WallList together(const std::vector<WallList>& pieces) {
  WallList all;
  std::vector<bool> flags;
  for (const WallList& piece : pieces) {
    all.balls.insert(all.balls.end(), piece.balls.begin(), piece.balls.end());
    all.discs.insert(all.discs.end(), piece.discs.begin(), piece.discs.end());
    all.objects.insert(all.objects.end(), piece.objects.begin(), piece.objects.end());
    if (!piece.map) continue;
    flags.resize(piece.map->voxels->size(), false);
    for (std::size_t i = 0; i < flags.size(); ++i) flags[i] = flags[i] || (*piece.map->voxels)[i];
    all.map = piece.map;
  }
  if (all.map) all.map->voxels = std::make_shared<const std::vector<bool>>(std::move(flags));
  return all;
}

Vec3 placeOf(const WallList& walls, const Grid& grid) {
  if (!walls.balls.empty()) return walls.balls[0].centre;
  if (!walls.discs.empty()) return walls.discs[0].centre;
  if (!walls.objects.empty()) return walls.objects[0].mesh->points[0];
  const std::vector<bool>& flags = *walls.map->voxels;
  return centreOf(grid,
                  static_cast<std::size_t>(std::find(flags.begin(), flags.end(), true) - flags.begin()));
}

bool touchesAny(const Mesh& mesh, const Walls& walls) {
  const Walls::Touched which = touched(mesh, walls, true);
  return !which.balls.empty() || !which.voxels.empty() || !which.objects.empty() || !which.discs.empty();
}

bool enclosesAny(const Mesh& mesh, const std::vector<Vec3>& places) {
  if (places.empty()) return false;
  const Inside inside(mesh);
  return std::any_of(places.begin(), places.end(), inside);
}

bool enclosesAny(const Mesh& mesh, const Walls& walls, const Vec3& place, double within) {
  return enclosesAny(mesh, walls.places(place, within));
}

namespace {

//! An object whose surface the mesh does not meet lies in it as any part of its surface does.
void findObjects(const Walls& walls, const Walls::Touched& which, const Inside& inside, Occupied& out) {
  for (std::size_t i = 0; i < walls.list().objects.size(); ++i) {
    const int object = static_cast<int>(i);
    const auto isTouched =
        std::find(which.objects.begin(), which.objects.end(), object) != which.objects.end();
    const auto& parts = walls.objects()->parts();
    const bool isEnclosed = std::any_of(parts.begin(), parts.end(), [&](const WallSurface::Part& part) {
      return part.object == object && inside(part.place);
    });
    if (isTouched || isEnclosed)
      (isTouched ? out.touched : out.enclosed).push_back({{}, {}, {walls.list().objects[i]}});
  }
}

}  // namespace

Occupied findOccupied(const Mesh& mesh, const Walls& walls) {
  const Walls::Touched which = touched(mesh, walls, false);
  const Inside inside(mesh);
  Occupied out;
  for (std::size_t i = 0; i < walls.list().balls.size(); ++i) {
    const WallBall& w = walls.list().balls[i];
    const bool isTouched =
        std::find(which.balls.begin(), which.balls.end(), static_cast<int>(i)) != which.balls.end();
    if (isTouched || inside(w.centre)) (isTouched ? out.touched : out.enclosed).push_back({{w}, {}});
  }
  for (std::size_t i = 0; i < walls.list().discs.size(); ++i) {
    const WallDisc& d = walls.list().discs[i];
    const bool isTouched =
        std::find(which.discs.begin(), which.discs.end(), static_cast<int>(i)) != which.discs.end();
    if (isTouched || inside(d.centre)) (isTouched ? out.touched : out.enclosed).push_back({{}, {}, {}, {d}});
  }
  findObjects(walls, which, inside, out);
  if (!walls.list().map) return out;
  const WallMap& map = *walls.list().map;
  std::vector<bool> hit(map.voxels->size(), false), left = *map.voxels;
  for (const std::size_t i : which.voxels) hit[i] = true;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i]) continue;
    const Voxels piece = takePiece(left, walls.grid(), i);
    const bool isTouched = std::any_of(piece.begin(), piece.end(), [&](std::size_t v) { return hit[v]; });
    if (isTouched || inside(centreOf(walls.grid(), i)))
      (isTouched ? out.touched : out.enclosed).push_back(ofVoxels(map, piece));
  }
  return out;
}

}  // namespace handlebody
