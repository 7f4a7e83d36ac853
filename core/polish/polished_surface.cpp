#include "core/polish/polished_surface.h"

#include <algorithm>
#include <map>

#include "core/collision/face_pair.h"
#include "core/geometry/triangle_intersection.h"
#include "core/indices.h"

namespace handlebody {

namespace {

Corners corners(std::span<const Vec3> points, const Triangle& t) {
  return {points[t[0]], points[t[1]], points[t[2]]};
}

//! The same face, whichever corner comes first.
Triangle fromLowest(const Triangle& t) {
  const auto lowest = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  return {t[lowest], t[(lowest + 1) % 3], t[(lowest + 2) % 3]};
}

void addUnique(std::vector<int>& list, int v) {
  if (std::find(list.begin(), list.end(), v) == list.end()) list.push_back(v);
}

}  // namespace

//! What a patch makes of the mesh.
struct PolishedSurface::Change {
  std::vector<int> removed;                 // faces
  std::vector<Triangle> added;              // of vertices, those that are new behind all others
  std::vector<Corners> was, is;             // of them
  std::vector<std::pair<int, Vec3>> moved;  // vertices, and where they go
  std::vector<Vec3> made;                   // vertices
};

PolishedSurface::PolishedSurface(const TriangleSoup& mesh, const PolishBounds& bounds)
    : first_(mesh),
      bounds_(bounds),
      points_(mesh.points),
      faces_(mesh.triangles),
      facesAt_(mesh.points.size()) {
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (const int v : faces_[f]) facesAt_[v].push_back(static_cast<int>(f));
}

void PolishedSurface::prepare() {
  for (std::size_t f = 0; f < faces_.size(); ++f)
    grid_.add(static_cast<int>(f), boxAround(cornersOf(faces_[f])));
  firstGrid_ = grid_;
  for (const TriangleSoup* other : bounds_.obstacles) {
    const int first = static_cast<int>(obstacle_.points.size());
    obstacle_.points.insert(obstacle_.points.end(), other->points.begin(), other->points.end());
    for (const Triangle& t : other->triangles) {
      obstacle_.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      obstacleGrid_.add(static_cast<int>(obstacle_.triangles.size()) - 1,
                        boxAround(corners(obstacle_.points, obstacle_.triangles.back())));
    }
  }
}

Corners PolishedSurface::cornersOf(const Triangle& t) const { return corners(points_, t); }

void PolishedSurface::put(int face) {
  const Triangle& t = faces_[face];
  for (const int v : t) facesAt_[v].push_back(face);
  grid_.add(face, boxAround(cornersOf(t)));
}

void PolishedSurface::take(int face) {
  Triangle& t = faces_[face];
  for (const int v : t) std::erase(facesAt_[v], face);
  grid_.remove(face, boxAround(cornersOf(t)));
  t = {-1, -1, -1};
}

int PolishedSurface::faceAt(int from, int to) const {
  for (const int f : facesAt_[from]) {
    const Triangle& t = faces_[f];
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == from && t[(i + 1) % 3] == to) return f;
  }
  return -1;
}

int PolishedSurface::apex(int from, int to) const {
  const int f = faceAt(from, to);
  if (f < 0) return -1;
  const Triangle& t = faces_[f];
  return t[0] + t[1] + t[2] - from - to;
}

PolishedSurface::Part PolishedSurface::around(std::span<const int> vertices) const {
  std::vector<int> inner(vertices.begin(), vertices.end());
  for (const int v : vertices)
    for (const int f : facesAt_[v])
      for (const int w : faces_[f]) addUnique(inner, w);
  Part part;
  for (const int v : inner) part.faces.insert(part.faces.end(), facesAt_[v].begin(), facesAt_[v].end());
  sortUnique(part.faces);
  PolishPatch& patch = part.patch;
  std::map<int, int> place;  // of a vertex in the patch
  const auto pointOf = [&](int v) {
    const auto [at, isNew] = place.emplace(v, static_cast<int>(patch.points.size()));
    if (isNew) {
      patch.points.push_back(points_[v]);
      patch.vertex.push_back(v);
    }
    return at->second;
  };
  for (const int f : part.faces) {
    const Triangle& t = faces_[f];
    patch.faces.push_back({pointOf(t[0]), pointOf(t[1]), pointOf(t[2])});
  }
  const auto isHere = [&](int f) { return std::binary_search(part.faces.begin(), part.faces.end(), f); };
  for (std::size_t p = 0; p < patch.points.size(); ++p) {
    int outside = 0;
    for (const int f : facesAt_[patch.vertex[p]]) {
      if (isHere(f)) continue;
      ++outside;
      const Triangle& t = faces_[f];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto a = place.find(t[i]), b = place.find(t[(i + 1) % 3]);
        if (a == place.end() || b == place.end()) continue;
        patch.outer.emplace_back(std::min(a->second, b->second), std::max(a->second, b->second));
        if (a->second == static_cast<int>(p) && patch.apex(b->second, a->second) >= 0)
          patch.border.push_back({b->second, a->second, points_[t[(i + 2) % 3]]});
      }
    }
    patch.outerFaces.push_back(outside);
    patch.isFree.push_back(outside == 0 && !isHeld(patch.vertex[p]) ? 1 : 0);
  }
  return part;
}

std::vector<Corners> PolishedSurface::cornersNear(const FaceGrid& grid, const TriangleSoup& mesh,
                                                  const Box& box) const {
  std::vector<int> found;
  grid.findNear(box, found);
  std::vector<Corners> near;
  for (const int f : found) {
    const Corners c = corners(mesh.points, mesh.triangles[f]);
    if (boxAround(c).overlaps(box)) near.push_back(c);
  }
  return near;
}

std::vector<Corners> PolishedSurface::firstNear(const PolishPatch& patch) const {
  return cornersNear(firstGrid_, first_, boxAround(patch.points, bounds_.distance));
}

PolishedSurface::Change PolishedSurface::changeOf(const Part& before, const PolishPatch& after) const {
  const PolishPatch& old = before.patch;
  Change change;
  std::vector<int> vertex = after.vertex;
  std::vector<char> isMoved(after.points.size(), 0);
  for (std::size_t p = 0; p < after.points.size(); ++p) {
    if (p >= old.points.size()) {
      vertex[p] = static_cast<int>(points_.size() + change.made.size());
      change.made.push_back(after.points[p]);
      isMoved[p] = 1;
    } else if (after.points[p] != old.points[p]) {
      change.moved.emplace_back(vertex[p], after.points[p]);
      isMoved[p] = 1;
    }
  }
  std::map<Triangle, int> kept;
  for (std::size_t i = 0; i < old.faces.size(); ++i) kept.emplace(fromLowest(old.faces[i]), before.faces[i]);
  for (const Triangle& t : after.faces) {
    const bool isNew = isMoved[t[0]] || isMoved[t[1]] || isMoved[t[2]];
    if (!isNew && kept.erase(fromLowest(t)) > 0) continue;
    change.added.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
    change.is.push_back(corners(after.points, t));
  }
  for (const auto& [t, face] : kept) {
    change.removed.push_back(face);
    change.was.push_back(cornersOf(faces_[face]));
  }
  return change;
}

bool PolishedSurface::breaksHeld(const Change& change) const {
  return std::any_of(change.removed.begin(), change.removed.end(), [this](int f) {
    const Triangle& t = faces_[f];
    return isHeld(t[0]) && isHeld(t[1]) && isHeld(t[2]);
  });
}

bool PolishedSurface::isNear(const Change& change) const {
  if (change.is.empty() || change.was.empty()) return false;
  std::vector<Vec3> isPoints, wasPoints;
  for (const Corners& c : change.is) isPoints.insert(isPoints.end(), c.begin(), c.end());
  for (const Corners& c : change.was) wasPoints.insert(wasPoints.end(), c.begin(), c.end());
  const std::vector<Corners> first = cornersNear(firstGrid_, first_, boxAround(isPoints, bounds_.distance));
  for (const Corners& c : change.is)
    if (!isCovered(c, first, bounds_.distance)) return false;
  std::vector<Corners> now = change.is;
  std::vector<int> found;
  grid_.findNear(boxAround(wasPoints, 2 * bounds_.distance), found);
  for (const int f : found)
    if (std::find(change.removed.begin(), change.removed.end(), f) == change.removed.end())
      now.push_back(cornersOf(faces_[f]));
  for (const Corners& c : cornersNear(firstGrid_, first_, boxAround(wasPoints, bounds_.distance)))
    if (!isCovered(c, change.was, now, bounds_.distance)) return false;
  return true;
}

//! Precondition: the vertices are where the change puts them.
bool PolishedSurface::isFree(const Change& change) const {
  std::vector<int> found;
  for (std::size_t i = 0; i < change.added.size(); ++i) {
    const Triangle& t = change.added[i];
    const Corners& c = change.is[i];
    for (std::size_t j = 0; j < i; ++j)
      if (facesIntersect(points_, t, change.added[j])) return false;
    grid_.findNear(boxAround(c), found);
    for (const int f : found)
      if (std::find(change.removed.begin(), change.removed.end(), f) == change.removed.end() &&
          facesIntersect(points_, t, faces_[f]))
        return false;
    if (bounds_.forbids && bounds_.forbids(c[0], c[1], c[2])) return false;
    for (const Corners& o : cornersNear(obstacleGrid_, obstacle_, boxAround(c)))
      if (trianglesIntersect(c[0], c[1], c[2], o[0], o[1], o[2])) return false;
  }
  return true;
}

bool PolishedSurface::accept(const Part& before, const PolishPatch& after) {
  const Change change = changeOf(before, after);
  if (breaksHeld(change) || !isNear(change)) return false;
  std::vector<std::pair<int, Vec3>> were;
  const std::size_t count = points_.size();
  for (const auto& [v, to] : change.moved) {
    were.emplace_back(v, points_[v]);
    points_[v] = to;
  }
  points_.insert(points_.end(), change.made.begin(), change.made.end());
  const bool isGood = isFree(change);
  for (const auto& [v, back] : were) points_[v] = back;  // what goes is found where it was
  if (!isGood) {
    points_.resize(count);
    return false;
  }
  for (const int f : change.removed) take(f);
  for (const auto& [v, to] : change.moved) points_[v] = to;
  facesAt_.resize(points_.size());
  for (const Triangle& t : change.added) {
    faces_.push_back(t);
    put(static_cast<int>(faces_.size()) - 1);
  }
  return true;
}

TriangleSoup PolishedSurface::compact() const {
  TriangleSoup out;
  std::vector<int> renamed(points_.size(), -1);
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (facesAt_[v].empty()) continue;
    renamed[v] = static_cast<int>(out.points.size());
    out.points.push_back(points_[v]);
  }
  for (const Triangle& t : faces_)
    if (t[0] >= 0) out.triangles.push_back({renamed[t[0]], renamed[t[1]], renamed[t[2]]});
  return out;
}

int PolishedSurface::changedFaces() const {
  return static_cast<int>(std::count_if(faces_.begin() + static_cast<std::ptrdiff_t>(first_.triangles.size()),
                                        faces_.end(), [](const Triangle& t) { return t[0] >= 0; }));
}

double PolishedSurface::farthest() const {
  double farthest = 0;
  std::vector<int> found;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const bool isOld = f < first_.triangles.size();
    if (isOld == (faces_[f][0] >= 0)) continue;  // still there, or made and gone
    const Corners c = isOld ? corners(first_.points, first_.triangles[f]) : cornersOf(faces_[f]);
    std::vector<Corners> others;
    if (!isOld) {
      others = cornersNear(firstGrid_, first_, boxAround(c, 2 * bounds_.distance));
    } else {
      grid_.findNear(boxAround(c, 2 * bounds_.distance), found);
      for (const int g : found) others.push_back(cornersOf(faces_[g]));
    }
    farthest = std::max(farthest, farthestFrom(c, others));
  }
  return farthest;
}

}  // namespace handlebody
