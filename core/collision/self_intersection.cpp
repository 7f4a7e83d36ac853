#include "core/collision/self_intersection.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/collision/box_tree.h"
#include "core/collision/face_pair.h"
#include "core/collision/marked_cells.h"
#include "core/collision/near_faces.h"
#include "core/collision/near_points.h"
#include "core/collision/star_test.h"
#include "core/collision/vertex_levels.h"
#include "core/collision/vertex_pairs.h"
#include "core/collision/vertex_stars.h"
#include "core/indices.h"

namespace handlebody {
namespace {

// Room for rounding in distances that only reject: their relative errors are below 2^-48.
constexpr double kRounding = 1 + 0x1p-40;
// A star is measured as larger than its longest edge by no more than this (StarSize, squared).
constexpr double kMeasured = 1 + 0x1p-8;

Box boxOf(std::span<const Vec3> points, const Triangle& t) {
  const Vec3& a = points[idx(t[0])];
  const Vec3& b = points[idx(t[1])];
  const Vec3& c = points[idx(t[2])];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

//! What rejects a face T at its corner: both other vertices are behind, or one is P.
struct SkipBits {
  bool behind, same;
};
constexpr std::size_t kSkipBits = 31;

//! Bit i: corner i is not skipped. Without branches, for nobody could foretell them. In a cycle prev of a
//! corner is next of the following one.
template <typename Skip>
unsigned notSkipped(std::span<const Corner> corners, bool inOrder, Skip&& skip) {
  unsigned behind = 0, same = 0;
  const auto add = [&](int r, std::size_t bit) {
    const SkipBits s = skip(r);
    behind |= static_cast<unsigned>(s.behind) << bit;
    same |= static_cast<unsigned>(s.same) << bit;
  };
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) add(corners[i].next, i);
  if (inOrder) {
    add(corners[n - 1].prev, n);
    behind &= behind >> 1;
    same |= same >> 1;
  } else {
    unsigned prevBehind = 0;
    std::swap(behind, prevBehind);
    for (std::size_t i = 0; i < n; ++i) add(corners[i].prev, i);
    behind &= prevBehind;
  }
  return ~(behind | same) & ((1u << n) - 1);
}

}  // namespace

struct CollisionDetector::Tables {
  std::span<const Vec3> points;
  std::span<const Triangle> faces;
  bool all = true;                       //!< else only pairs with a face in `movedFace`
  std::vector<unsigned char> movedFace;  //!< per face
  std::vector<unsigned char> active;     //!< per vertex: it belongs to a moved face
  std::vector<int> movedFaces;           //!< by slot
  //! Those that are looked at: all that belong to a face; or the active ones, and then those near to them.
  std::vector<int> vertices;
  std::vector<StarSize> sizes;  //!< per vertex in `vertices`
  double longestSquared = 0;    //!< of all edges that may meet one of `vertices`
  std::vector<FacePair> pairs;
  VertexStars stars;
  StarTest starTest;
  VertexPairs nearPairs;
  LevelPairs levelPairs;           //!< instead, where the sizes of the stars differ much
  std::vector<double> starSizes;   //!< squared, of `vertices`: see sizeSquared
  std::vector<double> mostAround;  //!< per vertex: squared longest edge of its faces, opposite ones included
  NearPoints near;
  NearLevels nearLevels;
  BoxTree tree;
  MarkedCells cells;
  std::vector<Box> boxes;
  std::vector<int> boxFaces;

  bool wanted(int f, int g) const { return all || movedFace[idx(f)] != 0 || movedFace[idx(g)] != 0; }
  void test(int f, int g) {
    if (facesIntersect(points, faces[idx(f)], faces[idx(g)]))
      pairs.emplace_back(std::min(f, g), std::max(f, g));
  }
  void runAll();
  void runMoved(std::span<const unsigned char> moved);
  void listActive(std::span<const unsigned char> moved);
  void listMovedFaces(std::span<const unsigned char> moved);
  void listFacesOfMoved(std::span<const unsigned char> moved);
  void addNear();
  void addNearOfLevels();
  void addResting(int v);
  bool areLevelsWorth();
  double reach() const { return std::sqrt(longestSquared * VertexLevels::kReachSquared) * kRounding; }
  void sortPairs();
  void testStar(int v);
  void testStarPairs(int v);
  void testSeparate();
  //! How near (mm², squared) the vertex u of a face T must be to the vertex v = P; see testSeparate.
  double reachSquared(int u, int v) const {
    return (sizes[idx(u)].circle + sizes[idx(v)].spoke * 0.25) * kRounding;
  }
  //! A size s of a star such that its spokes are not longer than s and its circles not larger than s/√3.
  double sizeSquared(int v) const { return std::max(sizes[idx(v)].spoke, 3 * sizes[idx(v)].circle); }
  bool testPairs();
  void testPair(int u, int v, double distanceSquared);
  void testNear(int u, int v, double distanceSquared);
  bool isFirstNear(int u, const Triangle& t, int v) const;
  void testFan(int f, int v);
  void markCells();
  void testSeparateByTree();
};

void CollisionDetector::Tables::sortPairs() { sortUnique(pairs); }

void CollisionDetector::Tables::runAll() {
  all = true;
  pairs.clear();
  vertices.clear();
  sizes.resize(points.size());
  longestSquared = 0;
  for (int v = 0; v < stars.vertexCount(); ++v) {
    if (stars.corners(v).empty()) continue;
    vertices.push_back(v);
    testStar(v);
    longestSquared = std::max(longestSquared, sizes[idx(v)].spoke);
  }
  testSeparate();
  sortPairs();
}

void CollisionDetector::Tables::runMoved(std::span<const unsigned char> moved) {
  all = false;
  pairs.clear();
  sizes.resize(points.size());
  listActive(moved);
  for (const int v : vertices) testStar(v);
  addNear();
  testSeparate();
  for (const int f : movedFaces) movedFace[idx(f)] = 0;
  for (const int v : vertices) active[idx(v)] = 0;
  sortPairs();
}

//! The faces that moved and their vertices. The flags are all 0 before.
void CollisionDetector::Tables::listActive(std::span<const unsigned char> moved) {
  movedFace.resize(faces.size(), 0);
  active.resize(points.size(), 0);
  movedFaces.clear();
  vertices.clear();
  const auto some = std::count_if(moved.begin(), moved.end(), [](unsigned char m) { return m != 0; });
  // Where many have moved, a look at all faces is quicker than one at each vertex's.
  const bool many = idx(static_cast<int>(some)) > points.size() / 8;
  if (many)
    listMovedFaces(moved);
  else if (some > 0)
    listFacesOfMoved(moved);
  for (const int f : movedFaces)
    for (const int v : faces[idx(f)]) {
      if (active[idx(v)] != 0) continue;
      active[idx(v)] = 1;
      if (!many) vertices.push_back(v);
    }
  for (int v = 0; many && v < static_cast<int>(active.size()); ++v)
    if (active[idx(v)] != 0) vertices.push_back(v);
  for (const int v : vertices) stars.need(v);
}

void CollisionDetector::Tables::listMovedFaces(std::span<const unsigned char> moved) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Triangle& t = faces[f];
    if (t[0] < 0 || (moved[idx(t[0])] | moved[idx(t[1])] | moved[idx(t[2])]) == 0) continue;
    movedFace[f] = 1;
    movedFaces.push_back(static_cast<int>(f));
  }
}

void CollisionDetector::Tables::listFacesOfMoved(std::span<const unsigned char> moved) {
  for (int v = 0; v < static_cast<int>(moved.size()); ++v) {
    if (moved[idx(v)] == 0) continue;
    stars.need(v);
    for (const Corner& c : stars.corners(v)) {
      if (movedFace[idx(c.face)] != 0) continue;
      movedFace[idx(c.face)] = 1;
      movedFaces.push_back(c.face);
    }
  }
}

//! Adds the vertices at rest that an active one can reach.
void CollisionDetector::Tables::addNear() {
  if (vertices.empty()) return;
  longestSquared = 0;
  for (const Triangle& t : faces) {
    if (t[0] < 0) continue;
    const Vec3 &a = points[idx(t[0])], &b = points[idx(t[1])], &c = points[idx(t[2])];
    longestSquared =
        std::max({longestSquared, (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  }
  // Where nearly all are active, looking which of the others are near costs more than it saves.
  const bool nearlyAll = vertices.size() > points.size() / 4 * 3;
  if (!nearlyAll && areLevelsWorth()) return addNearOfLevels();
  if (!nearlyAll) near.build(points, vertices, reach());
  for (int v = 0; v < static_cast<int>(points.size()); ++v)
    if (active[idx(v)] == 0 && (nearlyAll || near.mayBeNear(points[idx(v)]))) addResting(v);
}

void CollisionDetector::Tables::addResting(int v) {
  stars.need(v);
  if (stars.corners(v).empty()) return;  // free, or without a face
  sizes[idx(v)] = measureStar(points, v, stars.corners(v));
  vertices.push_back(v);
}

//! By the sizes of the stars listed so far.
bool CollisionDetector::Tables::areLevelsWorth() {
  starSizes.clear();
  for (const int v : vertices) {
    starSizes.push_back(sizeSquared(v));
    longestSquared = std::max(longestSquared, starSizes.back());
  }
  return VertexLevels::areWorth(starSizes, longestSquared);
}

//! Each of the others by its own size, as its faces tell it.
void CollisionDetector::Tables::addNearOfLevels() {
  mostAround.assign(points.size(), 0);
  for (const Triangle& t : faces) {
    if (t[0] < 0) continue;
    const Vec3 &a = points[idx(t[0])], &b = points[idx(t[1])], &c = points[idx(t[2])];
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    for (const int v : t) mostAround[idx(v)] = std::max(mostAround[idx(v)], longest);
  }
  nearLevels.build(points, vertices, starSizes, longestSquared * kMeasured);
  for (int v = 0; v < static_cast<int>(points.size()); ++v)
    if (active[idx(v)] == 0 && mostAround[idx(v)] > 0 &&
        nearLevels.mayBeNear(points[idx(v)], mostAround[idx(v)] * kMeasured))
      addResting(v);
}

void CollisionDetector::Tables::testStar(int v) {
  if (stars.isCycle(v)) {
    if (!starTest.isEmbedded(points, v, stars.corners(v), sizes[idx(v)])) testStarPairs(v);
  } else {
    sizes[idx(v)] = measureStar(points, v, stars.corners(v));
    testStarPairs(v);
  }
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
//! of T, and let C be the centre of the smallest circle that holds T, r its radius. Then
//!   Σ λi |P-Ti|² = |P-Q|² + Σ λi |Q-Ti|² ≤ |P-Q|² + Σ λi |C-Ti|² ≤ |PP'|²/4 + r²
//! and r² ≤ t²/3 with the longest edge t of T (Jung). So some Ti is that near to P. With the longest edge s
//! of the mesh for PP' and t, this proves Theorem 4 for sqrt(7/12)·s, which is sharp, instead of sqrt(2/3)·s.
//! It says more, too: P is within |PP'|/2 of T, which hardly any neighbour is. So what is looked for are
//! pairs of a vertex P and a triangle T.
//! No edge of the mesh but those of the two triangles is in the proof, so it holds for graded meshes place by
//! place: with a size s(v) of each star, not below its edges at v and √3 times its circles,
//!   |P-Ti|² ≤ s(P)²/4 + s(Ti)²/3 ≤ 7/12 · max(s(P), s(Ti))²
//! and levels of vertices by the octave of s(v) find all such pairs (vertex_levels.h).
void CollisionDetector::Tables::testSeparate() {
  if (vertices.empty()) return;  // nothing moved
  if (!testPairs()) testSeparateByTree();
}

//! False if the vertices are too crowded.
bool CollisionDetector::Tables::testPairs() {
  const auto test = [this](int u, int v, double distanceSquared) { testPair(u, v, distanceSquared); };
  if (areLevelsWorth()) {
    if (!levelPairs.build(points, vertices, starSizes, longestSquared)) return false;
    levelPairs.forEachPair(test);
  } else {
    if (!nearPairs.build(points, vertices, reach())) return false;
    nearPairs.forEachPair(test);
  }
  return true;
}

void CollisionDetector::Tables::testPair(int u, int v, double distanceSquared) {
  if (!all && (active[idx(u)] | active[idx(v)]) == 0) return;
  if (distanceSquared <= reachSquared(u, v)) testNear(u, v, distanceSquared);
  if (distanceSquared <= reachSquared(v, u)) testNear(v, u, distanceSquared);
}

//! The faces T at u against the faces at P = v.
void CollisionDetector::Tables::testNear(int u, int v, double distanceSquared) {
  const double nearSquared = sizes[idx(v)].spoke * (0.25 * kRounding);
  const Vec3& pu = points[idx(u)];
  const Vec3 w = points[idx(v)] - pu;
  // First a cheap rejection: a face whose corners stay behind `end` along w is too far from v.
  const double end = std::max(0.0, distanceSquared - std::sqrt(distanceSquared * nearSquared) -
                                       (kRounding - 1) * (distanceSquared + sizes[idx(u)].spoke));
  const auto skip = [&](int r) { return SkipBits{end > 0 && w.dot(points[idx(r)] - pu) < end, r == v}; };
  const std::span<const Corner> corners = stars.corners(u);
  for (std::size_t first = 0; first < corners.size(); first += kSkipBits) {
    const auto some = corners.subspan(first, std::min(kSkipBits, corners.size() - first));
    for (unsigned left = notSkipped(some, stars.isCycle(u), skip); left != 0; left &= left - 1) {
      const Corner& c = some[static_cast<std::size_t>(std::countr_zero(left))];
      if (!all && (active[idx(v)] | movedFace[idx(c.face)]) == 0) continue;
      if (isFarFrom(points[idx(v)], pu, points[idx(c.next)], points[idx(c.prev)], nearSquared)) continue;
      if (isFirstNear(u, faces[idx(c.face)], v)) testFan(c.face, v);
    }
  }
}

//! False if an earlier vertex of T is as near to v as u is: then T has its turn there.
bool CollisionDetector::Tables::isFirstNear(int u, const Triangle& t, int v) const {
  for (std::size_t i = 0; t[i] != u; ++i) {
    if ((points[idx(t[i])] - points[idx(v)]).squaredNorm() <= reachSquared(t[i], v)) return false;
  }
  return true;
}

//! Face f against the faces at v.
void CollisionDetector::Tables::testFan(int f, int v) {
  const Triangle& t = faces[idx(f)];
  const Box box = boxOf(points, t);
  for (const Corner& c : stars.corners(v)) {
    const Triangle& s = faces[idx(c.face)];
    if (wanted(f, c.face) && boxOf(points, s).overlaps(box) && !shareVertex(s, t)) test(f, c.face);
  }
}

//! Where the moved faces are: only what lies there goes into the tree.
void CollisionDetector::Tables::markCells() {
  double sum = 0;
  for (const int f : movedFaces) {
    const Box box = boxOf(points, faces[idx(f)]);
    sum += (box.high - box.low).maxCoeff();
  }
  cells.clear(movedFaces.empty() ? 1 : 2 * sum / static_cast<double>(movedFaces.size()));
  for (const int f : movedFaces) cells.mark(boxOf(points, faces[idx(f)]));
}

void CollisionDetector::Tables::testSeparateByTree() {
  boxes.clear();
  boxFaces.clear();
  if (!all) markCells();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f][0] < 0) continue;
    const Box box = boxOf(points, faces[f]);
    if (!all && !cells.mayMeet(box)) continue;
    boxes.push_back(box);
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

void CollisionDetector::use(BroadPhase phase) {
  tables_->nearPairs.use(phase);
  tables_->levelPairs.use(phase);
}

const std::vector<FacePair>& CollisionDetector::detectAll(std::span<const Vec3> points,
                                                          std::span<const Triangle> faces) {
  tables_->points = points;
  tables_->faces = faces;
  tables_->stars.build(points.size(), faces);
  tables_->runAll();
  return tables_->pairs;
}

const std::vector<FacePair>& CollisionDetector::detectMoved(std::span<const Vec3> points,
                                                            std::span<const Triangle> faces,
                                                            std::span<const unsigned char> moved) {
  tables_->points = points;
  tables_->faces = faces;
  tables_->stars.build(points.size(), faces);
  tables_->runMoved(moved);
  return tables_->pairs;
}

const std::vector<FacePair>& CollisionDetector::detectMoved(const Mesh& mesh,
                                                            std::span<const unsigned char> moved) {
  tables_->points = mesh.positions();
  tables_->faces = mesh.faces();
  tables_->stars.readFrom(mesh);
  tables_->runMoved(moved);
  return tables_->pairs;
}

std::vector<FacePair> findSelfIntersections(std::span<const Vec3> points, std::span<const Triangle> faces) {
  return CollisionDetector().detectAll(points, faces);
}

}  // namespace handlebody
