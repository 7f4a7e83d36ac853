#include "core/mesh/tunnels.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/indices.h"
#include "core/mesh/pieces.h"
#include "core/mesh/topology.h"
#include "core/phase.h"
#include "core/threads.h"

namespace handlebody {

namespace {

constexpr int kFirstBases = 6, kMaxBases = 60;  // spread over the surface
constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kBasesPerLoop = 6;
constexpr double kMaxTimes = 8;     // as long as its partner, for a loop to be searched for there again
constexpr int kRounds = 3;          // of searches from the loops found so far
constexpr double kProgress = 0.98;  // of the total length, below which another round follows

//! One component as a mesh of its own.
struct Part {
  Mesh mesh;
  std::vector<int> slots;  // of its vertices in the whole mesh
};

Part partOf(const Mesh& mesh, const Components& parts, int component) {
  Part out;
  TriangleSoup soup;
  std::vector<int> number(mesh.vertexSlots(), -1);
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (parts.ofVertex[v] != component) continue;
    number[v] = static_cast<int>(out.slots.size());
    out.slots.push_back(v);
    soup.points.push_back(mesh.position(v));
  }
  for (const Triangle& t : mesh.faces())
    if (t[0] >= 0 && number[t[0]] >= 0) soup.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  out.mesh = Mesh(soup);
  return out;
}

//! Which tunnel loop each handle loop is paired with: one that it meets an odd number of times. There is
//! always such a matching of all, since the intersection form is not singular modulo 2 (Kuhn's method).
class Pairing {
 public:
  Pairing(const Mesh& mesh, const LoopClasses& classes, const std::vector<EdgeLoop>& handles,
          const std::vector<EdgeLoop>& tunnels)
      : choices_(handles.size()), ofTunnel_(tunnels.size(), -1) {
    for (std::size_t h = 0; h < handles.size(); ++h) {
      std::vector<std::pair<double, int>> near;  // those met once and close by first
      for (std::size_t t = 0; t < tunnels.size(); ++t) {
        const auto n = classes.intersections(handles[h].coordinates, tunnels[t].coordinates);
        if (n % 2 != 0)
          near.emplace_back(static_cast<double>(n - 1) * 1e6 + gap(mesh, handles[h], tunnels[t]),
                            static_cast<int>(t));
      }
      std::sort(near.begin(), near.end());
      for (const auto& [cost, t] : near) choices_[h].push_back(t);
    }
    for (std::size_t h = 0; h < handles.size(); ++h) {
      tried_.assign(tunnels.size(), 0);
      place(static_cast<int>(h));
    }
  }
  //! Per tunnel loop its handle loop, or -1.
  const std::vector<int>& ofTunnel() const { return ofTunnel_; }

 private:
  static Vec3 middle(const Mesh& mesh, const EdgeLoop& loop) {
    Vec3 sum(0, 0, 0);
    for (const int v : loop.vertices) sum += mesh.position(v);
    return sum / static_cast<double>(loop.vertices.size());
  }
  static double gap(const Mesh& mesh, const EdgeLoop& a, const EdgeLoop& b) {
    return (middle(mesh, a) - middle(mesh, b)).norm();
  }
  bool place(int h) {
    for (const int t : choices_[h]) {
      if (tried_[t] != 0) continue;
      tried_[t] = 1;
      if (ofTunnel_[t] >= 0 && !place(ofTunnel_[t])) continue;
      ofTunnel_[t] = h;
      return true;
    }
    return false;
  }

  std::vector<std::vector<int>> choices_;
  std::vector<int> ofTunnel_;
  std::vector<unsigned char> tried_;
};

//! The search for short loops of both kinds on one component.
class ShortLoops {
 public:
  ShortLoops(const Mesh& mesh, const LoopClasses& classes, int threads)
      : mesh_(mesh), classes_(classes), threads_(threads), search_(mesh, classes) {}

  void run() {
    searchAllOver();
    for (int round = 0; round < kRounds; ++round) {
      const double before = total();
      searchFromLoops();
      take();
      if (total() > kProgress * before) break;
    }
    if (!complete()) searchOthers();
  }
  std::vector<EdgeLoop> handles, tunnels;
  std::vector<EdgeLoop> others;  // of neither kind; none if there are enough of both

 private:
  bool complete() const {
    return 2 * handles.size() == idx(classes_.rank()) && 2 * tunnels.size() == idx(classes_.rank());
  }
  void take() {
    handles = search_.basis(LoopKind::handle);
    tunnels = search_.basis(LoopKind::tunnel);
  }
  double total() const {
    double sum = 0;
    for (const auto* loops : {&handles, &tunnels})
      for (const EdgeLoop& loop : *loops) sum += loop.length;
    return sum;
  }
  //! Each base as far as possible from those before.
  void searchAllOver() {
    std::vector<double> nearest(mesh_.vertexSlots(), std::numeric_limits<double>::infinity());
    int base = 0;
    for (int n = 1; n <= std::min(kMaxBases, mesh_.vertexSlots()); ++n) {
      search_.searchFrom({base});
      for (std::size_t v = 0; v < nearest.size(); ++v)
        nearest[v] = std::min(nearest[v], search_.distances()[v]);
      base = static_cast<int>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
      if (n < kFirstBases || n % kFirstBases != 0) continue;
      take();
      if (complete()) return;
    }
    take();
  }
  //! A shorter loop of a pair crosses the other one.
  void searchFromLoops() {
    const Pairing pairing(mesh_, classes_, handles, tunnels);
    std::vector<LoopBase> bases;
    for (std::size_t t = 0; t < tunnels.size(); ++t) {
      if (pairing.ofTunnel()[t] < 0) continue;
      const EdgeLoop& handle = handles[pairing.ofTunnel()[t]];
      addBases(tunnels[t], handle.length, bases);
      addBases(handle, std::min(tunnels[t].length, kMaxTimes * handle.length), bases);
    }
    search_.searchFrom(bases, threads_);
  }
  //! Whatever meets a loop that has no partner passes through one of its vertices.
  void searchOthers() {
    search_.keepOthers();
    const Pairing pairing(mesh_, classes_, handles, tunnels);
    std::vector<LoopBase> bases;
    for (std::size_t t = 0; t < tunnels.size(); ++t)
      if (pairing.ofTunnel()[t] < 0) addBases(tunnels[t], kFar, bases);
    for (std::size_t h = 0; h < handles.size(); ++h)
      if (std::find(pairing.ofTunnel().begin(), pairing.ofTunnel().end(), static_cast<int>(h)) ==
          pairing.ofTunnel().end())
        addBases(handles[h], kFar, bases);
    search_.searchFrom(bases, threads_);
    take();
    std::vector<EdgeLoop> given = handles;
    given.insert(given.end(), tunnels.begin(), tunnels.end());
    others = search_.others(given);
  }
  //! Along the loop, for loops up to `other` long (mm).
  static void addBases(const EdgeLoop& loop, double other, std::vector<LoopBase>& bases) {
    const int step = std::max(1, static_cast<int>(loop.vertices.size()) / kBasesPerLoop);
    for (std::size_t i = 0; i < loop.vertices.size(); i += idx(step))
      bases.push_back({loop.vertices[i], other / 2});
  }

  const Mesh& mesh_;
  const LoopClasses& classes_;
  int threads_;
  LoopSearch search_;
};

Vec3 middleOf(const Mesh& mesh, const SurfaceLoop& loop) {
  Vec3 sum(0, 0, 0);
  double length = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Vec3 a = positionOf(mesh, loop.points[i]),
               b = positionOf(mesh, loop.points[(i + 1) % loop.points.size()]);
    sum += (b - a).norm() * (a + b) / 2;
    length += (b - a).norm();
  }
  return sum / length;
}

//! Tightened, with its vertices as slots of the whole mesh.
SurfaceLoop finished(const Part& part, const LoopClasses& classes, const EdgeLoop& loop) {
  SurfaceLoop out = tightened(part.mesh, classes, loop);
  for (SurfacePoint& p : out.points) {
    p.from = part.slots[p.from];
    p.to = part.slots[p.to];
  }
  return out;
}

//! Makes pairs of loops.
class PairLister {
 public:
  PairLister(const Mesh& mesh, const LoopClasses& classes) : mesh_(mesh), classes_(classes) {}

  //! Those of each that find no partner stay in them.
  void pairUp(std::vector<EdgeLoop>& handles, std::vector<EdgeLoop>& tunnels) {
    const Pairing pairing(mesh_, classes_, handles, tunnels);
    std::vector<EdgeLoop> handlesLeft, tunnelsLeft;
    std::vector<unsigned char> paired(handles.size(), 0);
    for (std::size_t t = 0; t < tunnels.size(); ++t) {
      const int h = pairing.ofTunnel()[t];
      if (h >= 0) {
        pairs_.emplace_back(std::move(handles[h]), std::move(tunnels[t]));
        paired[h] = 1;
      } else {
        tunnelsLeft.push_back(std::move(tunnels[t]));
      }
    }
    for (std::size_t h = 0; h < handles.size(); ++h)
      if (paired[h] == 0) handlesLeft.push_back(std::move(handles[h]));
    handles = std::move(handlesLeft);
    tunnels = std::move(tunnelsLeft);
  }

  const std::vector<std::pair<EdgeLoop, EdgeLoop>>& pairs() const { return pairs_; }

 private:
  const Mesh& mesh_;
  const LoopClasses& classes_;
  std::vector<std::pair<EdgeLoop, EdgeLoop>> pairs_;
};

Tunnel tunnelOf(const Mesh& mesh, const Part& part, const LoopClasses& classes, const EdgeLoop& handle,
                const EdgeLoop& tunnel) {
  Tunnel out;
  out.handle = finished(part, classes, handle);
  out.tunnel = finished(part, classes, tunnel);
  out.handleBounds = handle.kind == LoopKind::handle;
  out.tunnelBounds = tunnel.kind == LoopKind::tunnel;
  out.position = middleOf(mesh, out.shorter());
  return out;
}

void addTunnels(const Mesh& mesh, const Part& part, int component, int threads, TunnelList& list) {
  const auto classes = LoopClasses::of(part.mesh);
  if (!classes) return;
  ShortLoops loops(part.mesh, *classes, threads);
  loops.run();
  PairLister lister(part.mesh, *classes);
  lister.pairUp(loops.handles, loops.tunnels);
  lister.pairUp(loops.handles, loops.others);
  lister.pairUp(loops.others, loops.tunnels);
  std::vector<Tunnel> found(lister.pairs().size());
  forEachOnThreads(found.size(), threads, [&](std::size_t i) {
    const auto& [handle, tunnel] = lister.pairs()[i];
    found[i] = tunnelOf(mesh, part, *classes, handle, tunnel);
    found[i].component = component;
  });
  list.tunnels.insert(list.tunnels.end(), std::make_move_iterator(found.begin()),
                      std::make_move_iterator(found.end()));
}

constexpr int kPlacesBeside = 12;      // around the other loop
constexpr double kMaxLengthRatio = 2;  // to the shortest

//! The key of a loop, with each of its places drawn back to the lower end of its edge.
ClassKey keyOf(const Mesh& mesh, const LoopClasses& classes, const SurfaceLoop& loop) {
  ClassKey out;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const int u = loop.points[i].from, v = loop.points[(i + 1) % loop.points.size()].from;
    if (u != v) out += classes.key(mesh.findHalfedge(u, v));
  }
  return out;
}

//! The place of a slot of the whole mesh in the part, or -1.
int numberIn(const Part& part, int slot) {
  const auto it = std::lower_bound(part.slots.begin(), part.slots.end(), slot);
  return it != part.slots.end() && *it == slot ? static_cast<int>(it - part.slots.begin()) : -1;
}

}  // namespace

std::vector<SurfaceLoop> loopsBeside(const Mesh& mesh, const Tunnel& tunnel, LoopKind kind) {
  SurfaceLoop loop = kind == LoopKind::handle ? tunnel.handle : tunnel.tunnel;
  const SurfaceLoop& other = kind == LoopKind::handle ? tunnel.tunnel : tunnel.handle;
  // Cuts made since the tunnels were listed may have put the components in another order.
  const Components parts = findComponents(mesh);
  const Part part = partOf(mesh, parts, parts.ofVertex[loop.points[0].from]);
  const auto classes = LoopClasses::of(part.mesh);
  if (!classes) return {};
  for (SurfacePoint& p : loop.points) {
    p.from = numberIn(part, p.from);
    p.to = numberIn(part, p.to);
  }
  const ClassKey key = keyOf(part.mesh, *classes, loop);
  LoopSearch search(part.mesh, *classes);
  const Vec3 middle = middleOf(part.mesh, loop);
  std::vector<std::pair<double, SurfaceLoop>> found;
  const std::size_t n = other.points.size();
  for (std::size_t i = 0; i < kPlacesBeside; ++i) {
    const int base = numberIn(part, other.points[i * n / kPlacesBeside].from);
    if (base < 0) continue;
    const EdgeLoop beside = search.loopThrough({base, kMaxLengthRatio * loop.length / 2}, key);
    SurfaceLoop out;
    out.length = beside.length;
    for (const int v : beside.vertices) out.points.push_back({part.slots[v], part.slots[v], 0});
    if (!out.points.empty()) found.emplace_back((middleOf(mesh, out) - middle).norm(), std::move(out));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<SurfaceLoop> out;
  for (auto& [distance, beside] : found) out.push_back(std::move(beside));
  return out;
}

TunnelList findTunnels(const Mesh& mesh, int threads) {
  TunnelList out;
  const Components parts = findComponents(mesh);
  int total = 0;
  for (int c = 0; c < parts.count(); ++c) {
    const int genus = 1 - (parts.vertices[c] - parts.faces[c] / 2) / 2;
    if (genus <= 0) continue;
    total += genus;
    if (genus <= kMaxListed) addTunnels(mesh, partOf(mesh, parts, c), c, threadCount(threads), out);
  }
  out.unlisted = total - static_cast<int>(out.tunnels.size());
  std::stable_sort(out.tunnels.begin(), out.tunnels.end(),
                   [](const Tunnel& a, const Tunnel& b) { return a.shorter().length < b.shorter().length; });
  return out;
}

std::optional<TunnelList> findTunnelsQuickly(const TriangleSoup& mesh, const Certificate& certificate,
                                             int threads) {
  const int genus = std::accumulate(certificate.genus.begin(), certificate.genus.end(), 0);
  if (!certificate.passes()) return std::nullopt;
  if (genus == 0) return TunnelList{};
  if (genus > kQuickGenus || certificate.vertices > kQuickVertices) return std::nullopt;
  const Phase phase("tunnels");
  return findTunnels(Mesh(withoutLoosePoints(mesh)), threads);
}

}  // namespace handlebody
