#include "core/surgery/pulling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "core/geometry/triangle_distance.h"
#include "core/indices.h"
#include "core/mesh/remesh.h"

namespace handlebody {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
// Edge lengths at the place.
constexpr double kSnap = 0.3;  // from the point to a vertex that stands for it
constexpr double kLongest = 1.4;
constexpr double kShortest = 0.55;
constexpr double kResolved = 3;   // edges over the radius, at least
constexpr int kRefinements = 12;  // passes
constexpr std::array<int, 4> kPulls{1, 2, 4, 8};

Vec3 nearestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0;
  return a + t * (b - a);
}

int nearestFace(const Mesh& mesh, const Vec3& p) {
  int best = -1;
  double least = kFar;
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const Triangle& t = mesh.face(f);
    const double d = squaredDistance(p, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    if (d < least) {
      least = d;
      best = f;
    }
  }
  return best;
}

//! The vertex that stands for the point of the surface nearest to p: one that is near, or a new one on the
//! nearest edge, or in the face.
int handleAt(Mesh& mesh, const Vec3& p) {
  const int face = nearestFace(mesh, p);
  const Triangle t = mesh.face(face);
  const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const Vec3 flat = p - (p - a).dot(normal) * normal;
  const bool isWithin = (b - a).cross(flat - a).dot(normal) > 0 && (c - b).cross(flat - b).dot(normal) > 0 &&
                        (a - c).cross(flat - c).dot(normal) > 0;
  const double edge = ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
  double nearestEdge = kFar;
  int h = -1;
  Vec3 onEdge = a;
  for (int side = 3 * face; side < 3 * face + 3; ++side) {
    const Vec3 q = nearestOnSegment(p, mesh.position(mesh.origin(side)), mesh.position(mesh.target(side)));
    if ((q - p).norm() < nearestEdge) {
      nearestEdge = (q - p).norm();
      h = side;
      onEdge = q;
    }
  }
  const Vec3 point = isWithin ? flat : onEdge;
  int nearest = t[0];
  for (const int v : t)
    if ((mesh.position(v) - point).norm() < (mesh.position(nearest) - point).norm()) nearest = v;
  if ((mesh.position(nearest) - point).norm() < kSnap * edge) return nearest;
  if ((onEdge - point).norm() < kSnap * edge) return mesh.splitEdge(h, onEdge);
  mesh.removeFaces(std::array{face});
  const int m = mesh.addVertex(point);
  mesh.addFaces(std::array{Triangle{t[0], t[1], m}, Triangle{t[1], t[2], m}, Triangle{t[2], t[0], m}});
  return m;
}

//! Length of the straight way between the apexes of the two faces at an edge, laid flat; infinite if it
//! does not cross the edge.
double acrossEdge(const Mesh& mesh, int h) {
  const Vec3 &a = mesh.position(mesh.origin(h)), &b = mesh.position(mesh.target(h));
  const Vec3 &c = mesh.position(mesh.apex(h)), &d = mesh.position(mesh.apex(mesh.opposite(h)));
  const double length = (b - a).norm();
  if (!(length > 0)) return kFar;
  const Vec3 along = (b - a) / length;
  const double cx = (c - a).dot(along), dx = (d - a).dot(along);
  const double cy = (c - a - cx * along).norm(), dy = (d - a - dx * along).norm();
  if (!(cy + dy > 0)) return kFar;
  const double crossing = (cx * dy + dx * cy) / (cy + dy);
  if (crossing < 0 || crossing > length) return kFar;
  return std::hypot(cx - dx, cy + dy);
}

//! Distance of the vertices from one of them along edges and across pairs of faces, up to `reach`; infinite
//! beyond.
std::vector<double> distancesFrom(const Mesh& mesh, int start, double reach) {
  std::vector<double> distance(mesh.vertexSlots(), kFar);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto offer = [&](int v, double d) {
    if (d > reach || !(d < distance[v])) return;
    distance[v] = d;
    open.emplace(d, v);
  };
  offer(start, 0);
  while (!open.empty()) {
    const auto [d, v] = open.top();
    open.pop();
    if (d > distance[v]) continue;
    mesh.forEachOutgoing(v, [&, d = d, v = v](int h) {
      offer(mesh.target(h), d + (mesh.position(mesh.target(h)) - mesh.position(v)).norm());
      const int across = Mesh::next(h);
      offer(mesh.apex(mesh.opposite(across)), d + acrossEdge(mesh, across));
    });
  }
  return distance;
}

//! One pull of a mesh by a vertex of it.
class Pull {
 public:
  Pull(Mesh& mesh, int handle, const Vec3& by, double radius)
      : mesh_(mesh), handle_(handle), by_(by), radius_(radius) {
    distance_ = distancesFrom(mesh, handle, radius);
    edge_ = std::min(meanEdge(), radius / kResolved);
  }
  void run() {
    for (int pass = 0; pass < kRefinements && refine(); ++pass) {
    }
    VertexStates moved(idx(mesh_.vertexSlots()), kAtRest);
    for (int v = 0; v < mesh_.vertexSlots(); ++v) {
      if (!mesh_.isVertex(v) || !(weight(v) > 0)) continue;
      mesh_.setPosition(v, placeOf(v));
      moved[v] = v == handle_ ? kAtRest : kActive;
    }
    regulate(mesh_, {kLongest * edge_, kShortest * edge_, {}}, moved);
  }

 private:
  double weight(int v) const {
    const double t = distance_[v] / radius_;
    return t < 1 ? (1 - t * t) * (1 - t * t) : 0;
  }
  Vec3 placeOf(int v) const { return mesh_.position(v) + weight(v) * by_; }
  double meanEdge() const {
    double sum = 0, n = 0;
    for (int v = 0; v < mesh_.vertexSlots(); ++v)
      if (mesh_.isVertex(v) && distance_[v] < kFar)
        mesh_.forEachNeighbour(v, [&](int w) {
          sum += (mesh_.position(v) - mesh_.position(w)).norm();
          n += 1;
        });
    return sum / n;
  }
  //! Splits edges that are about to be drawn out, where they are: the surface does not move.
  bool refine() {
    const double limit = kLongest * edge_;
    std::vector<std::pair<double, int>> edges;
    for (int h = 0; h < 3 * mesh_.faceSlots(); ++h) {
      if (!mesh_.isFace(Mesh::faceOf(h)) || h > mesh_.opposite(h)) continue;
      if (const double length = drawnOut(h); length > limit) edges.emplace_back(-length, h);
    }
    std::sort(edges.begin(), edges.end());
    bool any = false;
    for (const auto& [length, h] : edges) {
      if (drawnOut(h) <= limit) continue;
      const int u = mesh_.origin(h), w = mesh_.target(h);
      const double between = (distance_[u] + distance_[w]) / 2;
      const double apart = (mesh_.position(u) - mesh_.position(w)).norm();
      const double least = std::min(distance_[u], distance_[w]) + apart / 2;
      const int m = mesh_.splitEdge(h, (mesh_.position(u) + mesh_.position(w)) / 2);
      if (idx(m) >= distance_.size()) distance_.resize(idx(m) + 1, kFar);
      distance_[m] = std::min(between, least);
      any = true;
    }
    return any;
  }
  //! Length of the edge after the pull; 0 for one that it leaves as it is.
  double drawnOut(int h) const {
    const int u = mesh_.origin(h), w = mesh_.target(h);
    if (!(distance_[u] < kFar) && !(distance_[w] < kFar)) return 0;
    return (placeOf(u) - placeOf(w)).norm();
  }

  Mesh& mesh_;
  int handle_;
  Vec3 by_;
  double radius_;
  std::vector<double> distance_;  // per vertex slot, mm
  double edge_ = 0;               // mm
};

}  // namespace

TouchedMesh pulled(const Mesh& mesh, const Vec3& from, const Vec3& to, double radius) {
  Mesh start = mesh;
  const int handle = handleAt(start, from);
  const Vec3 by = to - start.position(handle);
  if (by.norm() > kFurthestPull * radius) return refused(mesh, FindingKind::pullTooFar);
  TouchedMesh out;
  for (const int pulls : kPulls) {
    Mesh some = start;
    for (int i = 0; i < pulls; ++i) {
      const Vec3 here = some.position(handle);
      Pull(some, handle, i + 1 < pulls ? Vec3(by / pulls) : Vec3(to - here), radius).run();
    }
    some.setPosition(handle, to);
    out = certifiedEdit(mesh, std::move(some));
    if (out.isDone()) return out;
  }
  return out;
}

}  // namespace handlebody
