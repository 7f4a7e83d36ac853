#include "core/mesh/remesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/indices.h"

namespace handlebody {

namespace {

Vec3 normal(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).normalized(); }

class Regulator {
 public:
  Regulator(Mesh& mesh, const RemeshLimits& limits, VertexStates& active)
      : mesh_(mesh), limits_(limits), active_(active) {
    active_.resize(mesh.vertexSlots(), 0);
    if (limits.size) sizes_.assign(mesh.vertexSlots(), kUnknown);
  }

  void run() {
    listActiveFaces();
    splitLongEdges();
    collapseShortEdges();
    flipForValence();
  }

 private:
  // Each pass halves the longest edges: enough for any that are less than 2^16 times too long.
  static constexpr int kMaxSplitPasses = 16;
  // Beside an edge of length L that is not split, the other two of a thin face are split in turn: what was d
  // long becomes L - d/2, which tends to 2L/3. Above the limit that never ends, and every pass halves the
  // altitude.
  static constexpr double kFarTooLong = 1.5;
  // Where it may not be split, the other two are left as soon as they are a little above that 2L/3.
  static constexpr double kBesideFixed = 0.75;
  static constexpr double kUnknown = -1;

  bool isActive(int v) const { return active_[v] == kActive; }
  bool isActiveFace(int face) const {
    const Triangle& t = mesh_.face(face);
    return t[0] >= 0 && (isActive(t[0]) || isActive(t[1]) || isActive(t[2]));
  }
  double squaredLength(int h) const {
    return (mesh_.position(mesh_.target(h)) - mesh_.position(mesh_.origin(h))).squaredNorm();
  }
  //! What squared limits are multiplied by between two vertices.
  double squaredSize(int a, int b) const {
    if (!limits_.size) return 1;
    const double s = std::min(sizeAt(a), sizeAt(b));
    return s * s;
  }
  double squaredSizeOf(int h) const { return squaredSize(mesh_.origin(h), mesh_.target(h)); }
  double sizeAt(int v) const {
    double& s = sizes_[v];
    if (s == kUnknown) s = limits_.size(mesh_.position(v));
    return s;
  }
  //! The vertex is new, or was put elsewhere.
  void forgetSize(int v) {
    if (!limits_.size) return;
    if (idx(v) >= sizes_.size()) sizes_.resize(idx(v) + 1, kUnknown);
    sizes_[v] = kUnknown;
  }
  using SquaredLengths = std::array<double, 3>;
  SquaredLengths squaredLengths(int face) const {
    const Triangle& t = mesh_.face(face);
    const Vec3 &a = mesh_.position(t[0]), &b = mesh_.position(t[1]), &c = mesh_.position(t[2]);
    return {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
  }
  //! Collapses and flips bring no active vertex into a face that had none: only splits add faces.
  void listActiveFaces() {
    for (int face = 0; face < mesh_.faceSlots(); ++face) {
      if (isActiveFace(face)) faces_.push_back(face);
    }
  }
  //! Calls f(h) for one of the two half-edges of each edge beside an active vertex, in those of the listed
  //! faces that are candidates when their turn comes.
  template <typename IsCandidate, typename F>
  void forEachActiveEdge(const std::vector<int>& faces, IsCandidate&& isCandidate, F&& f) {
    for (const int face : faces) {
      if (!mesh_.isFace(face) || !isCandidate(face)) continue;
      for (int h = 3 * face; h < 3 * face + 3; ++h)
        if (mesh_.isFace(face) && h < mesh_.opposite(h) &&
            (isActive(mesh_.origin(h)) || isActive(mesh_.target(h))))
          f(h);
    }
  }

  //! Calls f(h) once for each edge between two inactive vertices whose squared length is above the limit, in
  //! those of the listed faces that hold an active vertex.
  template <typename F>
  void forEachInactiveEdge(const std::vector<int>& faces, double limit, F&& f) {
    for (const int face : faces) {
      if (!mesh_.isFace(face) || !anyLonger(face, limit) || !isActiveFace(face)) continue;
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        const int g = mesh_.opposite(h);
        if (!isActive(mesh_.origin(h)) && !isActive(mesh_.target(h)) &&
            squaredLength(h) > limit * squaredSizeOf(h) && (h < g || !isActiveFace(Mesh::faceOf(g))) &&
            !isFixed(h))
          f(h);
      }
    }
  }

  //! True if the edge lies in a face that may not be divided.
  bool isFixed(int h) const {
    const Forbidden& forbidden = limits_.forbidden;
    return forbidden.isPinned(mesh_.origin(h)) && forbidden.isPinned(mesh_.target(h)) &&
           (forbidden.isPinned(mesh_.apex(h)) || forbidden.isPinned(mesh_.apex(mesh_.opposite(h))));
  }

  //! True if a face of the edge has another edge that may not be split, and is much longer: see kFarTooLong.
  bool isBesideFixed(int h) const {
    if (!limits_.forbidden.pinned) return false;
    const double length = squaredLength(h);
    for (const int side : {h, mesh_.opposite(h)})
      for (const int e : {Mesh::next(side), Mesh::prev(side)})
        if (length < kBesideFixed * kBesideFixed * squaredLength(e) && isFixed(e)) return true;
    return false;
  }

  //! An edge that is still too long after a pass lies in a face with one of its new vertices: it is one of
  //! theirs, or the split of another edge of its face has renamed it.
  void splitLongEdges() {
    std::vector<int> faces = splitLongEdges(faces_), added;
    for (int pass = 1; pass < kMaxSplitPasses && !faces.empty(); ++pass) {
      added.insert(added.end(), faces.begin(), faces.end());
      faces = splitLongEdges(faces);
    }
    added.insert(added.end(), faces.begin(), faces.end());
    addFaces(added);
  }

  //! Adds some to the listed faces, which stay in ascending order. Most of them are there already.
  void addFaces(std::vector<int>& added) {
    std::sort(added.begin(), added.end());
    std::vector<int> all;
    all.reserve(faces_.size() + added.size());
    std::merge(faces_.begin(), faces_.end(), added.begin(), added.end(), std::back_inserter(all));
    all.erase(std::unique(all.begin(), all.end()), all.end());
    faces_ = std::move(all);
  }

  //! One pass; returns the faces at the new vertices, and beside them. Edges between inactive vertices that
  //! are far too long are split with the others: see kFarTooLong.
  std::vector<int> splitLongEdges(const std::vector<int>& faces) {
    const double limit = limits_.longest * limits_.longest;
    std::vector<std::pair<double, int>> edges;
    const auto isCandidate = [&](int face) { return anyLonger(face, limit); };
    forEachActiveEdge(faces, isCandidate, [&](int h) {
      if (isTooLong(h) && !isBesideFixed(h)) edges.emplace_back(-squaredLength(h), h);
    });
    forEachInactiveEdge(faces, kFarTooLong * kFarTooLong * limit,
                        [&](int h) { edges.emplace_back(-squaredLength(h), h); });
    // Longest first: that is what keeps the triangles well shaped.
    std::sort(edges.begin(), edges.end());
    std::vector<int> fresh;
    for (const auto& [length, h] : edges) {
      if (!isTooLong(h) || isBesideFixed(h)) continue;
      const int m =
          mesh_.splitEdge(h, (mesh_.position(mesh_.origin(h)) + mesh_.position(mesh_.target(h))) / 2);
      if (idx(m) >= active_.size()) active_.resize(idx(m) + 1, 0);
      active_[m] = kActive;
      forgetSize(m);
      fresh.push_back(m);
    }
    return facesAround(fresh);
  }

  bool isTooLong(int h) const {
    return squaredLength(h) > limits_.longest * limits_.longest * squaredSizeOf(h);
  }

  //! The faces at these vertices, and those across an edge of one: one of the two holds the half-edge of
  //! lower number.
  std::vector<int> facesAround(const std::vector<int>& vertices) const {
    std::vector<int> faces;
    for (const int v : vertices)
      mesh_.forEachOutgoing(v, [&](int h) {
        faces.push_back(Mesh::faceOf(h));
        const int across = mesh_.opposite(Mesh::next(h));
        if (across >= 0) faces.push_back(Mesh::faceOf(across));
      });
    sortUnique(faces);
    return faces;
  }

  //! Whether an edge of the face is shorter than the root of `limit`, or longer: few faces hold one, and the
  //! others are done with quickly.
  bool anyShorter(int face, double limit) const {
    const SquaredLengths l = squaredLengths(face);
    const SquaredLengths s = squaredSizes(face);
    return !(l[0] >= limit * s[0] && l[1] >= limit * s[1] && l[2] >= limit * s[2]);
  }
  bool anyLonger(int face, double limit) const {
    const SquaredLengths l = squaredLengths(face);
    const SquaredLengths s = squaredSizes(face);
    return l[0] > limit * s[0] || l[1] > limit * s[1] || l[2] > limit * s[2];
  }
  SquaredLengths squaredSizes(int face) const {
    if (!limits_.size) return {1, 1, 1};
    const Triangle& t = mesh_.face(face);
    return {squaredSize(t[0], t[1]), squaredSize(t[1], t[2]), squaredSize(t[2], t[0])};
  }

  void collapseShortEdges() {
    const double limit = limits_.shortest * limits_.shortest;
    const auto isCandidate = [&](int face) { return anyShorter(face, limit); };
    forEachActiveEdge(faces_, isCandidate, [&](int h) {
      if (squaredLength(h) >= limit * squaredSizeOf(h)) return;
      const int a = mesh_.origin(h), b = mesh_.target(h);
      if (isActive(a) && isActive(b)) {
        const Vec3 middle = (mesh_.position(a) + mesh_.position(b)) / 2;
        if (!collapseAllowed(h, middle)) return;
        mesh_.collapseEdge(h, middle);
        forgetSize(a);
        return;
      }
      // The inactive vertex stays where it is; but its faces are new ones.
      const int e = isActive(b) ? h : mesh_.opposite(h);
      const int inactive = mesh_.origin(e);
      if (!collapseAllowed(e, mesh_.position(inactive))) return;
      mesh_.collapseEdge(e, mesh_.position(inactive));
      forgetSize(inactive);
      active_[inactive] = kTouched;
    });
  }

  bool collapseAllowed(int h, const Vec3& p) const {
    return mesh_.canCollapse(h) && starStaysFlat(mesh_.origin(h), mesh_.target(h), p) &&
           starStaysFlat(mesh_.target(h), mesh_.origin(h), p);
  }

  //! True if the faces around v that do not hold `other` keep their normals, and no edge gets too long, when
  //! v goes to p.
  bool starStaysFlat(int v, int other, const Vec3& p) const {
    bool ok = true;
    const double size = limits_.size ? limits_.size(p) : 1;
    const auto staysShort = [&](int b) {
      const double s = limits_.size ? std::min(size, sizeAt(b)) : 1;
      return (mesh_.position(b) - p).squaredNorm() < limits_.longest * limits_.longest * (s * s);
    };
    mesh_.forEachOutgoing(v, [&](int h) {
      const int b = mesh_.target(h), c = mesh_.apex(h);
      if (!ok || b == other || c == other) return;
      const Vec3 before = normal(mesh_.position(v), mesh_.position(b), mesh_.position(c));
      const Vec3 after = normal(p, mesh_.position(b), mesh_.position(c));
      ok = before.dot(after) > kFlatEnough && staysShort(b) && staysShort(c) &&
           allows(p, mesh_.position(b), mesh_.position(c));
    });
    return ok;
  }

  //! Notes for each half-edge of the face whether the angle that faces it is obtuse.
  void findObtuse(int face) {
    const Triangle& t = mesh_.face(face);
    const Vec3 &a = mesh_.position(t[0]), &b = mesh_.position(t[1]), &c = mesh_.position(t[2]);
    unsigned char* obtuse = &obtuse_[3 * idx(face)];
    obtuse[0] = !((a - c).dot(b - c) >= 0);
    obtuse[1] = !((b - a).dot(c - a) >= 0);
    obtuse[2] = !((c - b).dot(a - b) >= 0);
  }

  //! Only an edge that an obtuse angle faces is ever turned (see flipImproves), and few do.
  void flipForValence() {
    obtuse_.resize(3 * idx(mesh_.faceSlots()));
    for (const int face : faces_)
      if (mesh_.isFace(face)) findObtuse(face);
    for (const int face : faces_)
      for (int h = 3 * face; mesh_.isFace(face) && h < 3 * face + 3; ++h) {
        const int g = mesh_.opposite(h);
        if (h >= g || (obtuse_[h] | obtuse_[g]) == 0) continue;
        if (!isActive(mesh_.origin(h)) || !isActive(mesh_.target(h)) || !flipImproves(h) || !mesh_.canFlip(h))
          continue;
        mesh_.flipEdge(h);
        findObtuse(face);
        findObtuse(Mesh::faceOf(g));
      }
  }

  bool flipImproves(int h) const {
    const int a = mesh_.origin(h), b = mesh_.target(h), c = mesh_.apex(h), d = mesh_.apex(mesh_.opposite(h));
    const Vec3 &pa = mesh_.position(a), &pb = mesh_.position(b), &pc = mesh_.position(c),
               &pd = mesh_.position(d);
    // Delaunay: turn the edge when the angles that face it add up to more than a straight one (with a margin,
    // so that no edge is turned to and fro). Two acute angles, the rule, do not.
    const auto cosine = [](const Vec3& apex, const Vec3& p, const Vec3& q) {
      return (p - apex).dot(q - apex) / std::sqrt((p - apex).squaredNorm() * (q - apex).squaredNorm());
    };
    const double sum = cosine(pc, pa, pb) + cosine(pd, pa, pb);
    if (!(sum < -0.1)) return false;
    if ((pc - pd).squaredNorm() > limits_.longest * limits_.longest * squaredSize(c, d)) return false;
    const Vec3 n0 = normal(pa, pb, pc), n1 = normal(pb, pa, pd);
    const Vec3 m0 = normal(pd, pc, pa), m1 = normal(pc, pd, pb);
    return n0.dot(n1) > kFlatEnough && m0.dot(m1) > kFlatEnough && m0.dot(n0) > kFlatEnough &&
           allows(pd, pc, pa) && allows(pc, pd, pb);
  }

  bool allows(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return !limits_.forbidden.holds || !limits_.forbidden.holds(a, b, c);
  }

  Mesh& mesh_;
  const RemeshLimits& limits_;
  VertexStates& active_;
  std::vector<int> faces_;             // that hold an active vertex, ascending
  std::vector<unsigned char> obtuse_;  // per half-edge: the angle that faces it
  mutable std::vector<double> sizes_;  // per vertex, kUnknown until asked for; with limits_.size
};

}  // namespace

void regulate(Mesh& mesh, const RemeshLimits& limits, VertexStates& active) {
  Regulator(mesh, limits, active).run();
}

}  // namespace handlebody
