#include "core/measure/section_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace handlebody {

namespace {

using Vec2 = Eigen::Vector2d;

//! A triangle's part of the section, with the body to its left; known by the edges that it joins.
struct Piece {
  std::uint64_t from, to;
  Vec2 start;
};

//! A closed line. Outlines have a positive area, those of holes a negative one.
struct Loop {
  std::vector<Vec2> points;
  double area = 0;

  bool surrounds(const Vec2& p) const {
    bool inside = false;
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
      const Vec2 &a = points[j], &b = points[i];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x()) inside = !inside;
    }
    return inside;
  }
};

//! The plane with two axes in it and p as its origin.
class Plane {
 public:
  Plane(const Vec3& p, const Vec3& normal)
      : p_(p), normal_(normal), u_(normal.unitOrthogonal()), v_(normal.cross(u_)) {}
  double height(const Vec3& q) const { return normal_.dot(q - p_); }
  Vec2 flat(const Vec3& q) const { return {u_.dot(q - p_), v_.dot(q - p_)}; }

 private:
  Vec3 p_, normal_, u_, v_;
};

std::uint64_t edgeKey(int a, int b) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 |
         static_cast<std::uint32_t>(std::max(a, b));
}

//! A vertex on the plane counts as above it, so that every edge is crossed or not for both of its faces.
std::vector<Piece> cut(const TriangleSoup& mesh, const Plane& plane) {
  std::vector<double> height(mesh.points.size());
  for (std::size_t i = 0; i < height.size(); ++i) height[i] = plane.height(mesh.points[i]);
  const auto above = [&](int v) { return height[v] >= 0; };
  std::vector<Piece> pieces;
  for (const Triangle& t : mesh.triangles) {
    if (above(t[0]) == above(t[1]) && above(t[1]) == above(t[2])) continue;
    Piece piece{};
    for (std::size_t c = 0; c < 3; ++c) {
      const int v = t[c], w = t[(c + 1) % 3];
      if (above(v) == above(w)) continue;
      if (!above(v)) {
        piece.to = edgeKey(v, w);
        continue;
      }
      piece.from = edgeKey(v, w);
      const double hv = height[v], hw = height[w];
      piece.start = plane.flat(mesh.points[w] + hw / (hw - hv) * (mesh.points[v] - mesh.points[w]));
    }
    pieces.push_back(piece);
  }
  return pieces;
}

std::vector<Loop> chain(std::vector<Piece> pieces) {
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
  std::vector<char> used(pieces.size(), 0);
  std::vector<Loop> loops;
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    Loop loop;
    for (std::size_t i = first; i < pieces.size() && !used[i];) {
      used[i] = 1;
      loop.points.push_back(pieces[i].start);
      const std::uint64_t next = pieces[i].to;
      i = static_cast<std::size_t>(
          std::lower_bound(pieces.begin(), pieces.end(), next,
                           [](const Piece& a, std::uint64_t key) { return a.from < key; }) -
          pieces.begin());
    }
    if (loop.points.empty()) continue;
    for (std::size_t i = 0, j = loop.points.size() - 1; i < loop.points.size(); j = i++) {
      const Vec2 &a = loop.points[j], &b = loop.points[i];
      loop.area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

std::optional<double> sectionArea(const TriangleSoup& mesh, const Vec3& p, const Vec3& normal) {
  const std::vector<Loop> loops = chain(cut(mesh, Plane(p, normal)));
  const Loop* outline = nullptr;
  for (const Loop& loop : loops)
    if (loop.surrounds(Vec2::Zero()) && (!outline || std::abs(loop.area) < std::abs(outline->area)))
      outline = &loop;
  if (!outline || outline->area <= 0) return std::nullopt;
  // What lies in the outline: holes of it, and in these further parts of the body with their own holes.
  std::vector<const Loop*> within, parts;
  for (const Loop& loop : loops)
    if (&loop != outline && std::abs(loop.area) < outline->area && outline->surrounds(loop.points[0])) {
      within.push_back(&loop);
      if (loop.area > 0) parts.push_back(&loop);
    }
  double area = outline->area;
  for (const Loop* loop : within) {
    const bool isOwn = loop->area < 0 && std::none_of(parts.begin(), parts.end(), [&](const Loop* part) {
                         return part->area > -loop->area && part->surrounds(loop->points[0]);
                       });
    if (isOwn) area += loop->area;
  }
  return area;
}

}  // namespace handlebody
