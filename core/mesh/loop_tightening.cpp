#include "core/mesh/loop_tightening.h"

#include <algorithm>
#include <queue>
#include <unordered_map>

#include "core/cancellation.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kRings = 2;   // around the loop, in each round
constexpr int kRounds = 6;  // at most: a loop that still gets shorter has moved to the rim of its band

//! Shortest loops in a band of faces.
class Band {
 public:
  Band(const Mesh& mesh, const LoopClasses& classes, const ClassKey& wanted)
      : mesh_(mesh), classes_(classes), wanted_(wanted) {}

  //! The shortest loop of the class in the band around `loop` that goes through its point `base`; the loop
  //! itself if there is no shorter one.
  SurfaceLoop shortened(const SurfaceLoop& loop, std::size_t base) {
    nodes_.clear();
    points_.clear();
    listFaces(loop);
    for (const int f : faces_) addNodes(f);
    spread(nodeOf(loop.points[base]));
    return best(loop);
  }

 private:
  struct Node {
    double distance = kFar;
    int parent = -1;
    ClassKey key;  // of the path, each place on an edge drawn back to the lower end of it
  };

  void listFaces(const SurfaceLoop& loop) {
    std::vector<int> vertices;
    for (const SurfacePoint& p : loop.points) {
      vertices.push_back(p.from);
      vertices.push_back(p.to);
    }
    for (int ring = 0; ring < kRings; ++ring) {
      sortUnique(vertices);
      faces_.clear();
      for (const int v : vertices)
        mesh_.forEachOutgoing(v, [&](int h) { faces_.push_back(Mesh::faceOf(h)); });
      sortUnique(faces_);
      for (const int f : faces_) vertices.insert(vertices.end(), mesh_.face(f).begin(), mesh_.face(f).end());
    }
  }
  // Nodes are numbered as met: vertex v by (v, v, 0), the places on an edge by its ends, lower first.
  int node(const SurfacePoint& p) {
    const int part = p.from == p.to ? 0 : static_cast<int>(p.at * (kEdgePoints + 1) + 0.5);
    const std::uint64_t name =
        ((static_cast<std::uint64_t>(p.from) << 32) | static_cast<std::uint64_t>(p.to)) * (kEdgePoints + 1) +
        static_cast<std::uint64_t>(part);
    const auto [it, isNew] = names_.try_emplace(name, static_cast<int>(points_.size()));
    if (isNew) {
      points_.push_back(p);
      places_.push_back(positionOf(mesh_, p));
    }
    return it->second;
  }
  int nodeOf(const SurfacePoint& p) { return node(p); }

  void addNodes(int f);
  void spread(int base);
  SurfaceLoop best(const SurfaceLoop& current) const;
  template <typename F>
  void forEachNeighbour(int n, F&& f) const;
  ClassKey keyBetween(int n, int m) const;
  SurfaceLoop loopThrough(int n, int m) const;

  const Mesh& mesh_;
  const LoopClasses& classes_;
  const ClassKey wanted_;
  std::vector<int> faces_;
  std::vector<Node> nodes_;
  std::vector<SurfacePoint> points_;
  std::vector<Vec3> places_;
  std::unordered_map<std::uint64_t, int> names_;
  std::vector<std::vector<int>> nodesOfFace_;  // by place in faces_
  std::vector<std::vector<int>> facesOfNode_;
};

void Band::addNodes(int f) {
  if (f == faces_.front()) {
    names_.clear();
    places_.clear();
    nodesOfFace_.clear();
    facesOfNode_.clear();
  }
  std::vector<int> all;
  const Triangle& t = mesh_.face(f);
  for (std::size_t i = 0; i < 3; ++i) {
    all.push_back(node({t[i], t[i], 0}));
    const int u = std::min(t[i], t[(i + 1) % 3]), v = std::max(t[i], t[(i + 1) % 3]);
    for (int k = 1; k <= kEdgePoints; ++k) all.push_back(node({u, v, k / (kEdgePoints + 1.0)}));
  }
  facesOfNode_.resize(points_.size());
  for (const int n : all) facesOfNode_[n].push_back(static_cast<int>(nodesOfFace_.size()));
  nodesOfFace_.push_back(std::move(all));
}

template <typename F>
void Band::forEachNeighbour(int n, F&& f) const {
  for (const int face : facesOfNode_[n])
    for (const int m : nodesOfFace_[face])
      if (m != n) f(m);
}

ClassKey Band::keyBetween(int n, int m) const {
  const int u = points_[n].from, v = points_[m].from;
  return u == v ? ClassKey{} : classes_.key(mesh_.findHalfedge(u, v));
}

void Band::spread(int base) {
  nodes_.assign(points_.size(), {});
  nodes_[base].distance = 0;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.emplace(0, base);
  while (!queue.empty()) {
    const auto [d, n] = queue.top();
    queue.pop();
    if (d > nodes_[n].distance) continue;
    forEachNeighbour(n, [&, d = d, n = n](int m) {
      const double there = d + (places_[m] - places_[n]).norm();
      if (there >= nodes_[m].distance) return;
      nodes_[m] = {there, n, nodes_[n].key};
      nodes_[m].key += keyBetween(n, m);
      queue.emplace(there, m);
    });
  }
}

SurfaceLoop Band::best(const SurfaceLoop& current) const {
  double length = current.length * (1 - 1e-9);
  int from = -1, to = -1;
  for (int n = 0; n < static_cast<int>(points_.size()); ++n) {
    if (2 * nodes_[n].distance > length) continue;
    forEachNeighbour(n, [&](int m) {
      const double there = nodes_[n].distance + (places_[m] - places_[n]).norm() + nodes_[m].distance;
      if (there >= length || nodes_[m].parent == n || nodes_[n].parent == m) return;
      ClassKey key = nodes_[n].key;
      key += keyBetween(n, m);
      key -= nodes_[m].key;
      if (!(key == wanted_)) return;
      length = there;
      from = n;
      to = m;
    });
  }
  return from < 0 ? current : loopThrough(from, to);
}

SurfaceLoop Band::loopThrough(int n, int m) const {
  const std::vector<int> there = loopOfPaths(n, m, [&](int v) { return nodes_[v].parent; });
  SurfaceLoop out;
  for (std::size_t i = 0; i < there.size(); ++i) {
    out.points.push_back(points_[there[i]]);
    out.length += (places_[there[(i + 1) % there.size()]] - places_[there[i]]).norm();
  }
  return out;
}

}  // namespace

Vec3 positionOf(const Mesh& mesh, const SurfacePoint& p) {
  return (1 - p.at) * mesh.position(p.from) + p.at * mesh.position(p.to);
}

SurfaceLoop tightened(const Mesh& mesh, const LoopClasses& classes, const EdgeLoop& loop) {
  SurfaceLoop out;
  out.length = loop.length;
  for (const int v : loop.vertices) out.points.push_back({v, v, 0});
  Band band(mesh, classes, loop.key);
  for (int round = 0; round < kRounds; ++round) {
    giveUpIfCancelled();
    const double before = out.length;
    out = band.shortened(out, 0);
    out = band.shortened(out, out.points.size() / 2);
    if (out.length > 0.997 * before) break;
  }
  return out;
}

}  // namespace handlebody
