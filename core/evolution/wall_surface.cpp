#include "core/evolution/wall_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/triangle_distance.h"
#include "core/geometry/triangle_intersection.h"
#include "core/indices.h"
#include "core/mesh/nesting.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

constexpr double kMaxCells = 4e6;

}  // namespace

WallSurface::WallSurface(const std::vector<WallObject>& objects, double cell) {
  gather(objects);
  layOut(cell);
  fillCells();
  markInside();
  measureBulges();
}

const Vec3& WallSurface::corner(int triangle, int i) const { return points_[triangles_[triangle][i]]; }

//! All meshes as one: they do not meet, so that together they enclose what any of them does.
void WallSurface::gather(const std::vector<WallObject>& objects) {
  for (std::size_t o = 0; o < objects.size(); ++o) {
    const TriangleSoup& mesh = *objects[o].mesh;
    const int first = static_cast<int>(points_.size()), firstPart = static_cast<int>(parts_.size());
    points_.insert(points_.end(), mesh.points.begin(), mesh.points.end());
    partOf_.resize(points_.size(), -1);
    for (const Triangle& t : mesh.triangles) {
      triangles_.push_back({t[0] + first, t[1] + first, t[2] + first});
      objectOf_.push_back(static_cast<int>(o));
    }
    const Components components = findComponents(Mesh(mesh));
    for (const double extent : components.extent)
      parts_.push_back({static_cast<int>(o), Vec3(0, 0, 0), extent});
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (components.ofVertex[v] < 0) continue;
      const int part = firstPart + components.ofVertex[v];
      partOf_[idx(first) + v] = part;
      parts_[part].place = mesh.points[v];
    }
  }
}

void WallSurface::layOut(double cell) {
  low_ = high_ = points_.at(0);
  for (const Vec3& p : points_) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  const Vec3 sides = (high_ - low_).array() + cell;
  cell_ = std::max(cell, std::cbrt(sides.prod() / kMaxCells));
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    size_[a] = static_cast<int>((high_[axis] - low_[axis]) / cell_) + 1;
  }
}

WallSurface::Range WallSurface::cellsOf(const Vec3& low, const Vec3& high) const {
  Range r{};
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const double last = size_[a] - 1.0;
    if (high[axis] < low_[axis] || low[axis] > high_[axis]) return {{1, 1, 1}, {0, 0, 0}};
    r.low[a] = static_cast<int>(std::clamp(std::floor((low[axis] - low_[axis]) / cell_), 0.0, last));
    r.high[a] = static_cast<int>(std::clamp(std::floor((high[axis] - low_[axis]) / cell_), 0.0, last));
  }
  return r;
}

namespace {

template <typename Range, typename F>
void forEachCell(const Range& r, F&& f) {
  for (int z = r.low[2]; z <= r.high[2]; ++z)
    for (int y = r.low[1]; y <= r.high[1]; ++y)
      for (int x = r.low[0]; x <= r.high[0]; ++x) f(std::array<int, 3>{x, y, z});
}

}  // namespace

void WallSurface::fillCells() {
  const std::size_t count = idx(size_[0]) * idx(size_[1]) * idx(size_[2]);
  first_.assign(count + 1, 0);
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    const Vec3 &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
    rangeOf_.push_back(cellsOf(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)));
    forEachCell(rangeOf_.back(), [&](const Index& i) { ++first_[idx(at(i)) + 1]; });
  }
  for (std::size_t c = 0; c < count; ++c) first_[c + 1] += first_[c];
  held_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
    forEachCell(rangeOf_[t], [&](const Index& i) { held_[next[at(i)]++] = t; });
}

//! A cell without a triangle lies wholly inside or outside: as its neighbour does, or as a ray from its
//! middle says. Each row from its far end, so that the ray meets a cell that is known.
void WallSurface::markInside() {
  cells_.assign(first_.size() - 1, Cell::surface);
  forEachCell(Range{{0, 0, 0}, {0, size_[1] - 1, size_[2] - 1}}, [&](const Index& row) {
    for (int x = size_[0] - 1; x >= 0; --x) {
      const Index c{x, row[1], row[2]};
      if (first_[at(c)] != first_[idx(at(c)) + 1]) continue;
      const Vec3 middle = low_ + cell_ * Vec3(x + 0.5, c[1] + 0.5, c[2] + 0.5);
      cells_[at(c)] = winds(middle, {x + 1, c[1], c[2]}) ? Cell::inside : Cell::outside;
    }
  });
}

//! Follows the ray from p along x from a cell of its row on. What it crosses up to the first cell that holds
//! no triangle lies in the cells up to there; a triangle counts in the first of them that holds it.
bool WallSurface::winds(const Vec3& p, Index cell) const {
  int winding = 0;
  for (const int from = cell[0]; cell[0] < size_[0]; ++cell[0]) {
    const std::size_t c = idx(at(cell));
    if (cells_[c] != Cell::surface) return winding + (cells_[c] == Cell::inside ? 1 : 0) > 0;
    for (int i = first_[c]; i < first_[c + 1]; ++i) {
      const int t = held_[i];
      if (std::max(rangeOf_[t].low[0], from) == cell[0])
        winding += crossing(corner(t, 0), corner(t, 1), corner(t, 2), p);
    }
  }
  return winding > 0;
}

bool WallSurface::encloses(const Vec3& p) const {
  const Range cell = cellsOf(p, p);
  return !cell.isEmpty() && winds(p, cell.low);
}

int WallSurface::objectAt(const Vec3& p) const {
  if (!encloses(p)) return -1;
  std::vector<int> winding(parts_.size(), 0);  // there are no more objects than parts
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
    winding[objectOf_[t]] += crossing(corner(t, 0), corner(t, 1), corner(t, 2), p);
  return static_cast<int>(std::find_if(winding.begin(), winding.end(), [](int w) { return w > 0; }) -
                          winding.begin());
}

template <typename F>
void WallSurface::forEachNear(const Vec3& low, const Vec3& high, F&& f) const {
  const Range range = cellsOf(low, high);
  if (range.isEmpty()) return;
  forEachCell(range, [&](const Index& c) {
    for (int i = first_[at(c)]; i < first_[idx(at(c)) + 1]; ++i) {
      const Index& own = rangeOf_[held_[i]].low;
      const bool isFirst = std::max(own[0], range.low[0]) == c[0] && std::max(own[1], range.low[1]) == c[1] &&
                           std::max(own[2], range.low[2]) == c[2];
      if (isFirst) f(held_[i]);
    }
  });
}

//! Bulges are the mean over the neighbours of a vertex, since a single one tells more of the noise. A single
//! hollow has to be filled whatever it comes from.
void WallSurface::measureBulges() {
  std::vector<Vec3> normals(points_.size(), Vec3::Zero());
  for (const Triangle& t : triangles_) {
    const Vec3 &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    for (const int v : t) normals[v] += (b - a).cross(c - a);
  }
  std::vector<double> own(points_.size(), 0);
  std::vector<int> neighbours(points_.size(), 0);
  bulges_.assign(points_.size(), 0);
  hollows_.assign(points_.size(), 0);
  const auto forEachEdge = [&](auto&& f) {
    for (const Triangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) f(idx(t[i]), idx(t[(i + 1) % 3]));
  };
  forEachEdge([&](std::size_t v, std::size_t w) {
    const Vec3 edge = points_[w] - points_[v];
    const double above = normals[v].stableNormalized().dot(edge) / edge.squaredNorm();
    own[v] = std::max(own[v], -above);
    hollows_[v] = std::max(hollows_[v], above);
  });
  forEachEdge([&](std::size_t v, std::size_t w) {
    bulges_[v] += own[w];
    ++neighbours[v];
  });
  for (std::size_t v = 0; v < bulges_.size(); ++v) bulges_[v] /= std::max(1, neighbours[v]);
}

WallSurface::Nearest WallSurface::nearest(const Vec3& p, double limit) const {
  double squared = limit * limit;
  int nearest = -1;
  forEachNear(p.array() - limit, p.array() + limit, [&](int t) {
    const double here = squaredDistance(p, corner(t, 0), corner(t, 1), corner(t, 2));
    if (here >= squared) return;
    squared = here;
    nearest = t;
  });
  const double away = nearest < 0 ? limit : std::sqrt(squared);
  double bulge = 0;
  if (nearest >= 0)
    for (const int v : triangles_[nearest]) bulge += bulges_[v] / 3;
  return {encloses(p) ? -away : away, bulge};
}

bool WallSurface::meets(const Vec3& a, const Vec3& b, const Vec3& c, std::vector<int>* which) const {
  bool any = false;
  forEachNear(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), [&](int t) {
    if ((any && !which) || !trianglesIntersect(a, b, c, corner(t, 0), corner(t, 1), corner(t, 2))) return;
    any = true;
    if (which) which->push_back(objectOf_[t]);
  });
  return any;
}

bool WallSurface::clears(const Vec3& a, const Vec3& b, const Vec3& c, double clearance) const {
  const Vec3 low = a.cwiseMin(b).cwiseMin(c).array() - clearance;
  const Vec3 high = a.cwiseMax(b).cwiseMax(c).array() + clearance;
  bool clear = true;
  forEachNear(low, high, [&](int t) {
    const Vec3 &u = corner(t, 0), &v = corner(t, 1), &w = corner(t, 2);
    const bool apart = (u.cwiseMin(v).cwiseMin(w).array() > high.array()).any() ||
                       (u.cwiseMax(v).cwiseMax(w).array() < low.array()).any();
    if (!clear || apart) return;
    clear = squaredDistance({a, b, c}, {u, v, w}) > clearance * clearance &&
            !trianglesIntersect(a, b, c, u, v, w);
  });
  return clear;
}

std::vector<Vec3> WallSurface::places(const Vec3& world, double within) const {
  std::vector<int> nearest(parts_.size(), -1);
  forEachNear(world.array() - within, world.array() + within, [&](int t) {
    for (const int v : triangles_[t])
      if ((points_[v] - world).squaredNorm() <= within * within && nearest[partOf_[v]] < 0)
        nearest[partOf_[v]] = v;
  });
  std::vector<Vec3> out;
  for (const int v : nearest)
    if (v >= 0) out.push_back(points_[v]);
  return out;
}

}  // namespace handlebody
