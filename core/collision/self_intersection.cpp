#include "core/collision/self_intersection.h"

#include <algorithm>
#include <cmath>

#include "core/collision/box_tree.h"
#include "core/collision/face_pair.h"
#include "core/collision/near_faces.h"
#include "core/collision/spatial_hash.h"
#include "core/collision/star_test.h"
#include "core/collision/vertex_stars.h"

namespace handlebody {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

Box boxOf(std::span<const Vec3> points, const Triangle& t) {
  const Vec3& a = points[idx(t[0])];
  const Vec3& b = points[idx(t[1])];
  const Vec3& c = points[idx(t[2])];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

}  // namespace

struct CollisionDetector::Tables {
  std::span<const Vec3> points;
  std::span<const Triangle> faces;
  bool all = true;                       //!< else only pairs with a face in `movedFace`
  std::vector<unsigned char> movedFace;  //!< per face
  std::vector<unsigned char> active;     //!< per vertex: it belongs to a moved face
  std::vector<double> longestSquared;    //!< per vertex: of its edges
  std::vector<int> vertices;             //!< those that belong to a face
  std::vector<FacePair> pairs;
  VertexStars stars;
  StarTest starTest;
  SpatialHash hash;
  BoxTree tree;
  std::vector<Box> boxes;
  std::vector<int> boxFaces;

  bool wanted(int f, int g) const { return all || movedFace[idx(f)] != 0 || movedFace[idx(g)] != 0; }
  void test(int f, int g) {
    if (facesIntersect(points, faces[idx(f)], faces[idx(g)]))
      pairs.emplace_back(std::min(f, g), std::max(f, g));
  }
  void run();
  void markMoved(std::span<const unsigned char> moved);
  void testStars();
  void testStar(int v);
  void measure(int v);
  void testStarPairs(int v);
  void testSeparate();
  void testNear(int u, int v, double distanceSquared, double reachSquared);
  void testSeparateByTree();
};

void CollisionDetector::Tables::run() {
  pairs.clear();
  stars.build(points.size(), faces);
  testStars();
  testSeparate();
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

void CollisionDetector::Tables::markMoved(std::span<const unsigned char> moved) {
  movedFace.assign(faces.size(), 0);
  active.assign(points.size(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Triangle& t = faces[f];
    if (t[0] < 0 || (moved[idx(t[0])] | moved[idx(t[1])] | moved[idx(t[2])]) == 0) continue;
    movedFace[f] = 1;
    for (const int v : t) active[idx(v)] = 1;
  }
}

//! Faces that share a vertex; on the way, the longest edge at every vertex.
void CollisionDetector::Tables::testStars() {
  vertices.clear();
  longestSquared.assign(points.size(), 0);
  for (int v = 0; v < stars.vertexCount(); ++v) {
    if (stars.corners(v).empty()) continue;
    vertices.push_back(v);
    if (all || active[idx(v)] != 0) {
      testStar(v);
    } else {
      measure(v);
    }
  }
}

void CollisionDetector::Tables::testStar(int v) {
  if (stars.isCycle(v)) {
    if (!starTest.isEmbedded(points, v, stars.corners(v), longestSquared[idx(v)])) testStarPairs(v);
  } else {
    measure(v);
    testStarPairs(v);
  }
}

void CollisionDetector::Tables::measure(int v) {
  double longest = 0;
  for (const Corner& c : stars.corners(v)) {
    longest = std::max(longest, (points[idx(c.next)] - points[idx(v)]).squaredNorm());
    if (!stars.isCycle(v)) longest = std::max(longest, (points[idx(c.prev)] - points[idx(v)]).squaredNorm());
  }
  longestSquared[idx(v)] = longest;
}

void CollisionDetector::Tables::testStarPairs(int v) {
  const auto corners = stars.corners(v);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const int f = corners[i].face;
      const int g = corners[j].face;
      if (f != g && wanted(f, g)) test(f, g);
    }
  }
}

//! Faces without a common vertex. If two such triangles intersect, an edge of one of them, PP', meets the
//! other, T, in a point Q, and P may be chosen such that |PQ| ≤ |PP'|/2. Let Q = Σ λi Ti with the vertices Ti
//! of T. Then
//!   Σ λi |P-Ti|² = |P-Q|² + Σ λi |Q-Ti|² = |P-Q|² + Σi<j λi λj |Ti-Tj|² ≤ |PP'|²/4 + s²/3
//! where s is the longest edge of the mesh, because Σi<j λi λj ≤ 1/3. So some Ti is that near to P. This
//! proves Theorem 4 with sqrt(7/12)·s, which is sharp, instead of sqrt(2/3)·s, and says more: P is within
//! half of its longest edge of T. What is left are pairs of a vertex P and a triangle T.
void CollisionDetector::Tables::testSeparate() {
  double longest = 0;
  for (const double l : longestSquared) longest = std::max(longest, l);
  constexpr double kSlack = 1 + 0x1p-40;  // for rounding: all quantities are good to 2^-50 or so
  const double reachSquared = longest / 3 * kSlack;
  if (!hash.build(points, vertices, std::sqrt(longest * (7.0 / 12.0)) * kSlack)) {
    testSeparateByTree();
    return;
  }
  const auto visit = [&](const SpatialHash::Entry& a, const SpatialHash::Entry& b) {
    const double d = (a.point - b.point).squaredNorm();
    testNear(a.vertex, b.vertex, d, reachSquared);
    testNear(b.vertex, a.vertex, d, reachSquared);
  };
  if (all) {
    hash.forEachPair(visit);
  } else {
    hash.forEachPair(active, visit);
  }
}

//! The faces T at u against the faces at P = v, if u may be the vertex Ti of testSeparate.
void CollisionDetector::Tables::testNear(int u, int v, double distanceSquared, double reachSquared) {
  const double quarter = longestSquared[idx(v)] * (0.25 * (1 + 0x1p-40));
  const double limit = quarter + reachSquared;
  if (distanceSquared > limit) return;
  const Vec3& p = points[idx(v)];
  for (const Corner& c : stars.corners(u)) {
    if (c.next == v || c.prev == v) continue;
    if (isFarFrom(p, points[idx(u)], points[idx(c.next)], points[idx(c.prev)], quarter)) continue;
    const Triangle& t = faces[idx(c.face)];
    // Another vertex of T, earlier in T, may be as near: then T has its turn there.
    bool first = true;
    for (std::size_t i = 0; t[i] != u && first; ++i) {
      first = (points[idx(t[i])] - p).squaredNorm() > limit;
    }
    if (!first) continue;
    const Box box = boxOf(points, t);
    for (const Corner& d : stars.corners(v)) {
      const Triangle& s = faces[idx(d.face)];
      if (wanted(c.face, d.face) && boxOf(points, s).overlaps(box) && !shareVertex(s, t))
        test(c.face, d.face);
    }
  }
}

void CollisionDetector::Tables::testSeparateByTree() {
  boxes.clear();
  boxFaces.clear();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f][0] < 0) continue;
    boxes.push_back(boxOf(points, faces[f]));
    boxFaces.push_back(static_cast<int>(f));
  }
  tree.build(boxes);
  tree.forEachOverlap([&](int i, int j) {
    const int f = boxFaces[idx(i)];
    const int g = boxFaces[idx(j)];
    if (wanted(f, g) && !shareVertex(faces[idx(f)], faces[idx(g)])) test(f, g);
  });
}

CollisionDetector::CollisionDetector() : tables_(std::make_unique<Tables>()) {}
CollisionDetector::~CollisionDetector() = default;
CollisionDetector::CollisionDetector(CollisionDetector&&) noexcept = default;
CollisionDetector& CollisionDetector::operator=(CollisionDetector&&) noexcept = default;

const std::vector<FacePair>& CollisionDetector::detectAll(std::span<const Vec3> points,
                                                          std::span<const Triangle> faces) {
  tables_->points = points;
  tables_->faces = faces;
  tables_->all = true;
  tables_->run();
  return tables_->pairs;
}

const std::vector<FacePair>& CollisionDetector::detectMoved(std::span<const Vec3> points,
                                                            std::span<const Triangle> faces,
                                                            std::span<const unsigned char> moved) {
  tables_->points = points;
  tables_->faces = faces;
  tables_->all = false;
  tables_->markMoved(moved);
  tables_->run();
  return tables_->pairs;
}

std::vector<FacePair> findSelfIntersections(std::span<const Vec3> points, std::span<const Triangle> faces) {
  return CollisionDetector().detectAll(points, faces);
}

}  // namespace handlebody
