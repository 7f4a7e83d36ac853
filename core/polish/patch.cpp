#include "core/polish/patch.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

namespace {

bool holds(const Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

}  // namespace

int PolishPatch::apex(int from, int to) const {
  for (const Triangle& t : faces)
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == from && t[(i + 1) % 3] == to) return t[(i + 2) % 3];
  return -1;
}

bool PolishPatch::hasEdge(int a, int b) const {
  return apex(a, b) >= 0 || apex(b, a) >= 0 ||
         std::find(outer.begin(), outer.end(), std::pair(std::min(a, b), std::max(a, b))) != outer.end();
}

std::vector<int> PolishPatch::neighbours(int v) const {
  std::vector<int> all;
  for (const Triangle& t : faces)
    if (holds(t, v))
      for (const int w : t)
        if (w != v) all.push_back(w);
  sortUnique(all);
  return all;
}

int PolishPatch::valence(int v) const {
  return outerFaces[v] + static_cast<int>(std::count_if(faces.begin(), faces.end(),
                                                        [v](const Triangle& t) { return holds(t, v); }));
}

bool PolishPatch::isUsed(int v) const {
  return std::any_of(faces.begin(), faces.end(), [v](const Triangle& t) { return holds(t, v); });
}

bool PolishPatch::flip(int a, int b) {
  const int c = apex(a, b), d = apex(b, a);
  if (c < 0 || d < 0 || c == d || hasEdge(c, d) || valence(a) <= 3 || valence(b) <= 3) return false;
  for (Triangle& t : faces) {
    if (holds(t, a) && holds(t, b) && holds(t, c))
      t = {c, d, b};
    else if (holds(t, a) && holds(t, b) && holds(t, d))
      t = {d, c, a};
  }
  return true;
}

// The link condition: a and b have no common neighbours but the two apexes.
bool PolishPatch::collapse(int a, int b, const Vec3& place) {
  const int c = apex(a, b), d = apex(b, a);
  if (c < 0 || d < 0 || c == d || !isFree[a]) return false;
  if (!isFree[b] && place != points[b]) return false;
  if (valence(c) <= 3 || valence(d) <= 3) return false;
  for (const int w : neighbours(a))
    if (w != b && w != c && w != d && hasEdge(w, b)) return false;
  std::erase_if(faces, [&](const Triangle& t) { return holds(t, a) && holds(t, b); });
  for (Triangle& t : faces)
    for (int& v : t)
      if (v == a) v = b;
  points[b] = place;
  return true;
}

int PolishPatch::split(int a, int b, const Vec3& place) {
  const int c = apex(a, b), d = apex(b, a);
  if (c < 0 || d < 0) return -1;
  const int m = static_cast<int>(points.size());
  points.push_back(place);
  vertex.push_back(-1);
  isFree.push_back(1);
  outerFaces.push_back(0);
  std::erase_if(faces, [&](const Triangle& t) { return holds(t, a) && holds(t, b); });
  faces.insert(faces.end(), {{a, m, c}, {m, b, c}, {m, a, d}, {b, m, d}});
  return m;
}

//! Edges of one face: each is met once, from the side that runs from its lower point, but for the border's.
void PolishPatch::addEdges(const Triangle& t, int onlyAt, std::vector<Shape>& shapes) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const int p = t[i], q = t[(i + 1) % 3], c = t[(i + 2) % 3];
    if (onlyAt < 0 && p > q) continue;
    const int d = apex(q, p);
    // Seen from the faces at one point, the edges across from it have their other side elsewhere.
    if (d < 0 || (onlyAt >= 0 && holds({p, q, d}, onlyAt) && p > q)) continue;
    shapes.push_back({p, q, c, d, nullptr});
  }
}

std::vector<PolishPatch::Shape> PolishPatch::shapes() const {
  std::vector<Shape> all;
  for (const Triangle& t : faces) {
    all.push_back({t[0], t[1], t[2], -1, nullptr});
    addEdges(t, -1, all);
  }
  for (const BorderEdge& e : border)
    if (const int c = apex(e.from, e.to); c >= 0) all.push_back({e.from, e.to, c, -1, &e.beyond});
  return all;
}

std::vector<PolishPatch::Shape> PolishPatch::shapesAt(int v) const {
  std::vector<Shape> all;
  for (const Triangle& t : faces) {
    if (!holds(t, v)) continue;
    all.push_back({t[0], t[1], t[2], -1, nullptr});
    addEdges(t, v, all);
  }
  for (const BorderEdge& e : border)
    if (const int c = apex(e.from, e.to); c == v) all.push_back({e.from, e.to, c, -1, &e.beyond});
  return all;
}

Badness PolishPatch::badnessOf(std::span<const Shape> shapes, const WantedShape& wanted) const {
  Badness sum;
  for (const Shape& s : shapes) {
    const Vec3 &p = points[s.p], &q = points[s.q], &c = points[s.c];
    if (s.beyond)
      sum.add(wanted.ofEdge(p, q, c, *s.beyond));
    else
      sum.add(s.d < 0 ? wanted.ofFace(p, q, c) : wanted.ofEdge(p, q, c, points[s.d]));
  }
  return sum;
}

}  // namespace handlebody
