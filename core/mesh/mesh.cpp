#include "core/mesh/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

#include "core/indices.h"

namespace handlebody {

namespace {

//! A half-edge under the key of its directed edge, for joining faces to each other.
struct DirectedEdge {
  int from;
  int to;
  int halfedge;
  bool operator<(const DirectedEdge& o) const { return from != o.from ? from < o.from : to < o.to; }
};

//! For each half-edge in the sorted list, the half-edge that runs the other way, or -1.
int findReverse(const std::vector<DirectedEdge>& sorted, const DirectedEdge& e) {
  const auto it = std::lower_bound(sorted.begin(), sorted.end(), DirectedEdge{e.to, e.from, 0});
  return it != sorted.end() && it->from == e.to && it->to == e.from ? it->halfedge : -1;
}

}  // namespace

Mesh::Mesh(const TriangleSoup& soup) : positions_(soup.points), outgoing_(soup.points.size(), kIsolated) {
  addFaces(soup.triangles);
}

Vec3 Mesh::areaVector(int f) const {
  const Triangle& t = face(f);
  return (position(t[1]) - position(t[0])).cross(position(t[2]) - position(t[0]));
}

int Mesh::findHalfedge(int u, int v) const {
  int found = -1;
  forEachOutgoing(u, [&](int h) {
    if (target(h) == v) found = h;
  });
  return found;
}

int Mesh::valence(int v) const {
  int n = 0;
  forEachNeighbour(v, [&](int) { ++n; });
  return n;
}

void Mesh::link(int h, int g) {
  opposite_[h] = g;
  opposite_[g] = h;
}

int Mesh::addVertex(const Vec3& p) {
  if (freeVertices_.empty()) {
    positions_.push_back(p);
    outgoing_.push_back(kIsolated);
    return vertexSlots() - 1;
  }
  const int v = freeVertices_.back();
  freeVertices_.pop_back();
  positions_[v] = p;
  outgoing_[v] = kIsolated;
  return v;
}

int Mesh::newFace(const Triangle& corners) {
  int f = faceSlots();
  if (freeFaces_.empty()) {
    faces_.push_back(corners);
    opposite_.insert(opposite_.end(), 3, -1);
  } else {
    f = freeFaces_.back();
    freeFaces_.pop_back();
    faces_[f] = corners;
    for (int i = 0; i < 3; ++i) opposite_[3 * f + i] = -1;
  }
  return f;
}

void Mesh::deleteFaceSlot(int f) {
  faces_[f] = {-1, -1, -1};
  freeFaces_.push_back(f);
}

void Mesh::addFaces(std::span<const Triangle> faces) {
  std::vector<int> vertices;
  for (const Triangle& t : faces) vertices.insert(vertices.end(), t.begin(), t.end());
  sortUnique(vertices);

  std::vector<DirectedEdge> open;  // boundary half-edges that exist already
  for (int v : vertices)
    forEachOutgoing(v, [&](int h) {
      if (opposite(h) < 0) open.push_back({v, target(h), h});
      if (opposite(prev(h)) < 0) open.push_back({origin(prev(h)), v, prev(h)});
    });
  const std::size_t firstNew = open.size();
  for (const Triangle& t : faces) {
    const int f = newFace(t);
    for (int h = 3 * f; h < 3 * f + 3; ++h) open.push_back({origin(h), target(h), h});
  }
  const std::vector<DirectedEdge> added(open.begin() + static_cast<std::ptrdiff_t>(firstNew), open.end());
  std::sort(open.begin(), open.end());
  for (const DirectedEdge& e : added) {
    const int reverse = findReverse(open, e);
    if (reverse >= 0) link(e.halfedge, reverse);
    outgoing_[e.from] = e.halfedge;
  }
  // A boundary vertex must start at its boundary half-edge, so that `turn` meets all its faces.
  for (const DirectedEdge& e : open)
    if (opposite(e.halfedge) < 0) outgoing_[e.from] = e.halfedge;
}

void Mesh::removeFaces(std::span<const int> faces) {
  std::vector<int> doomed(faces.begin(), faces.end());
  std::sort(doomed.begin(), doomed.end());
  const auto isDoomed = [&](int h) { return std::binary_search(doomed.begin(), doomed.end(), faceOf(h)); };
  std::vector<std::pair<int, int>> fresh;  // vertex, its new outgoing half-edge
  for (int f : doomed)
    for (int v : face(f)) {
      int start = kIsolated;
      forEachOutgoing(v, [&](int h) {
        if (!isDoomed(h) && (opposite(h) < 0 || isDoomed(opposite(h)))) start = h;
      });
      fresh.emplace_back(v, start);
    }
  for (int f : doomed) {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (opposite(h) >= 0) opposite_[opposite(h)] = -1;
    deleteFaceSlot(f);
  }
  for (const auto& [v, h] : fresh) outgoing_[v] = h;
}

void Mesh::removeVertex(int v) {
  assert(outgoing(v) == kIsolated);
  outgoing_[v] = kDeleted;
  freeVertices_.push_back(v);
}

int Mesh::splitEdge(int h, const Vec3& p) {
  const int g = opposite(h);
  assert(g >= 0);
  const int hn = next(h), gp = prev(g);
  const int b = target(h), c = apex(h), d = apex(g);
  const int beyondC = opposite(hn), beyondD = opposite(gp);
  const int m = addVertex(p);
  faces_[faceOf(hn)][hn % 3] = m;
  faces_[faceOf(g)][g % 3] = m;
  const int f2 = newFace({m, b, c});
  const int f3 = newFace({b, m, d});
  link(3 * f2 + 1, beyondC);
  link(3 * f2 + 2, hn);
  link(3 * f3 + 2, beyondD);
  link(3 * f3 + 1, gp);
  link(3 * f2, 3 * f3);
  outgoing_[m] = hn;
  outgoing_[b] = 3 * f2 + 1;
  return m;
}

bool Mesh::canFlip(int h) const {
  const int g = opposite(h);
  if (g < 0) return false;
  const int c = apex(h), d = apex(g);
  if (c == d || findHalfedge(c, d) >= 0 || findHalfedge(d, c) >= 0) return false;
  return valence(origin(h)) > 3 && valence(target(h)) > 3;
}

void Mesh::flipEdge(int h) {
  const int g = opposite(h);
  const int hn = next(h), hp = prev(h), gn = next(g), gp = prev(g);
  const int a = origin(h), b = origin(g), c = apex(h), d = apex(g);
  const int bc = opposite(hn), ca = opposite(hp), ad = opposite(gn), db = opposite(gp);
  const auto setOrigin = [&](int e, int v) { faces_[faceOf(e)][e % 3] = v; };
  setOrigin(h, d);
  setOrigin(hn, c);
  setOrigin(hp, a);
  setOrigin(g, c);
  setOrigin(gn, d);
  setOrigin(gp, b);
  link(hn, ca);
  link(hp, ad);
  link(gn, db);
  link(gp, bc);
  outgoing_[a] = hp;
  outgoing_[b] = gp;
  outgoing_[c] = hn;
  outgoing_[d] = gn;
}

bool Mesh::canCollapse(int h) const {
  const int g = opposite(h);
  if (g < 0) return false;
  const int a = origin(h), b = target(h), c = apex(h), d = apex(g);
  if (c == d || valence(c) <= 3 || valence(d) <= 3) return false;
  bool linkCondition = true;
  forEachNeighbour(a, [&](int w) {
    if (w != c && w != d && w != b && findHalfedge(b, w) >= 0) linkCondition = false;
  });
  return linkCondition;
}

void Mesh::collapseEdge(int h, const Vec3& p) {
  const int g = opposite(h);
  const int a = origin(h), b = target(h), c = apex(h), d = apex(g);
  const int cb = opposite(next(h)), ac = opposite(prev(h)), da = opposite(next(g)), bd = opposite(prev(g));
  forEachOutgoing(b, [&](int e) { faces_[faceOf(e)][e % 3] = a; });
  deleteFaceSlot(faceOf(h));
  deleteFaceSlot(faceOf(g));
  link(cb, ac);
  link(da, bd);
  outgoing_[a] = ac;
  outgoing_[c] = cb;
  outgoing_[d] = da;
  outgoing_[b] = kDeleted;
  freeVertices_.push_back(b);
  positions_[a] = p;
}

void Mesh::reorder(std::span<const int> vertices) {
  std::vector<int> newVertex(positions_.size(), -1), newFace(faces_.size(), -1);
  std::vector<Vec3> positions;
  positions.reserve(vertices.size());
  for (const int v : vertices) {
    newVertex[v] = static_cast<int>(positions.size());
    positions.push_back(position(v));
  }
  std::vector<Triangle> faces;
  faces.reserve(faceCount());
  for (const int v : vertices)
    forEachOutgoing(v, [&](int h) {
      if (newFace[faceOf(h)] >= 0) return;
      newFace[faceOf(h)] = static_cast<int>(faces.size());
      const Triangle& t = face(faceOf(h));
      faces.push_back({newVertex[t[0]], newVertex[t[1]], newVertex[t[2]]});
    });
  const auto newHalfedge = [&](int h) { return h < 0 ? h : 3 * newFace[faceOf(h)] + h % 3; };
  std::vector<int> opposite(3 * faces.size()), outgoing;
  for (int h = 0; h < 3 * faceSlots(); ++h)
    if (isFace(faceOf(h))) opposite[newHalfedge(h)] = newHalfedge(this->opposite(h));
  for (const int v : vertices) outgoing.push_back(newHalfedge(this->outgoing(v)));
  positions_ = std::move(positions);
  faces_ = std::move(faces);
  opposite_ = std::move(opposite);
  outgoing_ = std::move(outgoing);
  freeVertices_.clear();
  freeFaces_.clear();
}

std::size_t Mesh::memory() const {
  return positions_.size() * sizeof(Vec3) + faces_.size() * sizeof(Triangle) +
         (opposite_.size() + outgoing_.size() + freeVertices_.size() + freeFaces_.size()) * sizeof(int);
}

TriangleSoup Mesh::compact(std::vector<int>* vertexMap) const {
  std::vector<int> map(positions_.size(), -1);
  TriangleSoup soup;
  soup.points.reserve(positions_.size());
  for (int v = 0; v < vertexSlots(); ++v)
    if (isVertex(v)) {
      map[v] = static_cast<int>(soup.points.size());
      soup.points.push_back(position(v));
    }
  for (const Triangle& t : faces_)
    if (t[0] >= 0) soup.triangles.push_back({map[t[0]], map[t[1]], map[t[2]]});
  if (vertexMap) *vertexMap = std::move(map);
  return soup;
}

}  // namespace handlebody
