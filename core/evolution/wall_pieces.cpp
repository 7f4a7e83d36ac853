#include "core/evolution/wall_pieces.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/indices.h"
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

//! Which of the places lie in what a mesh encloses.
std::vector<bool> areInside(const Mesh& mesh, const std::vector<Vec3>& places) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (!mesh.isVertex(v)) continue;
    low = low.cwiseMin(mesh.position(v));
    high = high.cwiseMax(mesh.position(v));
  }
  std::vector<std::size_t> inBox;
  std::vector<Vec3> asked;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3& p = places[i];
    if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) continue;
    inBox.push_back(i);
    asked.push_back(p);
  }
  std::vector<bool> inside(places.size(), false);
  if (asked.empty()) return inside;
  const std::vector<int> windings = windingNumbers(mesh, findComponents(mesh), asked);
  for (std::size_t i = 0; i < asked.size(); ++i) inside[inBox[i]] = windings[i] > 0;
  return inside;
}

}  // namespace

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

Vec3 placeOf(const WallList& walls, const Grid& grid) {
  if (!walls.balls.empty()) return walls.balls[0].centre;
  if (!walls.discs.empty()) return walls.discs[0].centre;
  if (!walls.objects.empty()) return walls.objects[0].mesh->points[0];
  const std::vector<bool>& flags = *walls.map->voxels;
  return centreOf(grid,
                  static_cast<std::size_t>(std::find(flags.begin(), flags.end(), true) - flags.begin()));
}

std::optional<Vec3> placeOfFresh(const WallList& walls, const WallList& known, const Grid& grid) {
  WallList fresh = without(walls, known);
  if (fresh.empty()) return std::nullopt;
  const std::optional<WallMap> map = std::exchange(fresh.map, std::nullopt);
  if (!fresh.empty()) return placeOf(fresh, grid);
  std::vector<bool> left = *walls.map->voxels;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i]) continue;
    const Voxels piece = takePiece(left, grid, i);
    if (std::any_of(piece.begin(), piece.end(), [&](std::size_t v) { return (*map->voxels)[v]; }))
      return centreOf(grid, i);
  }
  return std::nullopt;
}

bool touchesAny(const Mesh& mesh, const Walls& walls) {
  const Walls::Touched which = touched(mesh, walls, true);
  return !which.balls.empty() || !which.voxels.empty() || !which.objects.empty() || !which.discs.empty();
}

bool enclosesAny(const Mesh& mesh, const std::vector<Vec3>& places) {
  if (places.empty()) return false;
  const std::vector<bool> inside = areInside(mesh, places);
  return std::find(inside.begin(), inside.end(), true) != inside.end();
}

bool enclosesAny(const Mesh& mesh, const Walls& walls, const Vec3& place, double within) {
  return enclosesAny(mesh, walls.places(place, within));
}

namespace {

//! `placesOf`: of the wall with that index, which the mesh does not touch; it is enclosed if one of them is.
template <typename Wall, typename PlacesOf>
void sortOut(const Mesh& mesh, const std::vector<Wall>& all, const std::vector<int>& touched,
             PlacesOf&& placesOf, std::vector<Wall>& outTouched, std::vector<Wall>& outEnclosed) {
  std::vector<bool> isTouched(all.size(), false), isEnclosed(all.size(), false);
  for (const int i : touched) isTouched[i] = true;
  std::vector<Vec3> places;
  std::vector<std::size_t> owners;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (isTouched[i]) continue;
    for (const Vec3& place : placesOf(i)) places.push_back(place);
    owners.resize(places.size(), i);
  }
  const std::vector<bool> inside = areInside(mesh, places);
  for (std::size_t k = 0; k < places.size(); ++k)
    if (inside[k]) isEnclosed[owners[k]] = true;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (isTouched[i] || isEnclosed[i]) (isTouched[i] ? outTouched : outEnclosed).push_back(all[i]);
}

//! The pieces that hold one of the voxels in `starts`.
std::optional<WallMap> piecesAt(const WallMap& map, const Grid& grid,
                                const std::vector<std::size_t>& starts) {
  if (starts.empty()) return std::nullopt;
  std::vector<bool> left = *map.voxels, flags(left.size(), false);
  for (const std::size_t i : starts) {
    if (!left[i]) continue;
    for (const std::size_t v : takePiece(left, grid, i)) flags[v] = true;
  }
  return WallMap{map.path, {}, std::make_shared<const std::vector<bool>>(std::move(flags)), {}};
}

//! Of a piece only a voxel is kept: there may be very many.
void sortOutVoxels(const Mesh& mesh, const WallMap& map, const Grid& grid,
                   const std::vector<std::size_t>& touched, Occupied& out) {
  std::vector<bool> left = *map.voxels;
  for (const std::size_t i : touched)
    if (left[i]) takePiece(left, grid, i);
  std::vector<std::size_t> starts, enclosed;
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i]) continue;
    takePiece(left, grid, i);
    starts.push_back(i);
    places.push_back(centreOf(grid, i));
  }
  const std::vector<bool> inside = areInside(mesh, places);
  for (std::size_t k = 0; k < starts.size(); ++k)
    if (inside[k]) enclosed.push_back(starts[k]);
  out.touched.map = piecesAt(map, grid, touched);
  out.enclosed.map = piecesAt(map, grid, enclosed);
}

}  // namespace

Occupied findOccupied(const Mesh& mesh, const Walls& walls) {
  const Walls::Touched which = touched(mesh, walls, false);
  const WallList& list = walls.list();
  Occupied out;
  const auto atCentre = [](const auto& all) {
    return [&all](std::size_t i) { return std::array<Vec3, 1>{all[i].centre}; };
  };
  // An object whose surface the mesh does not meet lies in it as any part of its surface does.
  const auto partsOf = [&](std::size_t object) {
    std::vector<Vec3> places;
    for (const WallSurface::Part& part : walls.objects()->parts())
      if (idx(part.object) == object) places.push_back(part.place);
    return places;
  };
  sortOut(mesh, list.balls, which.balls, atCentre(list.balls), out.touched.balls, out.enclosed.balls);
  sortOut(mesh, list.discs, which.discs, atCentre(list.discs), out.touched.discs, out.enclosed.discs);
  sortOut(mesh, list.objects, which.objects, partsOf, out.touched.objects, out.enclosed.objects);
  if (list.map) sortOutVoxels(mesh, *list.map, walls.grid(), which.voxels, out);
  return out;
}

}  // namespace handlebody
