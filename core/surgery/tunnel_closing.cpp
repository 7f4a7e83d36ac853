#include "core/surgery/tunnel_closing.h"

#include <algorithm>
#include <map>

#include "core/cancellation.h"
#include "core/collision/self_intersection.h"
#include "core/indices.h"
#include "core/mesh/nesting.h"
#include "core/mesh/structure.h"
#include "core/surgery/predicted_change.h"
#include "core/surgery/smooth_cap.h"

namespace handlebody {

namespace {

constexpr std::size_t kLongestLoop = 2000;  // vertices: the least-area cap takes its cube
constexpr std::size_t kLongestFan = 24;
constexpr std::size_t kLongestSmooth = 1000;

//! Splits the edges that the loop crosses; the loop as vertices, each joined to the next by an edge. None if
//! it is no such loop.
std::optional<std::vector<int>> embed(Mesh& mesh, const SurfaceLoop& loop) {
  std::map<std::pair<int, int>, std::map<double, int>> onEdge;  // vertices on an edge, by their place
  std::vector<int> out;
  for (const SurfacePoint& p : loop.points) {
    if (p.from == p.to) {
      out.push_back(p.from);
      continue;
    }
    const Vec3 place = positionOf(mesh, p);
    auto& stops =
        onEdge.try_emplace({p.from, p.to}, std::map<double, int>{{0, p.from}, {1, p.to}}).first->second;
    const auto above = stops.lower_bound(p.at);
    if (above == stops.end() || above == stops.begin()) return std::nullopt;
    const int h = mesh.findHalfedge(std::prev(above)->second, above->second);
    if (above->first == p.at || h < 0) return std::nullopt;
    out.push_back(stops[p.at] = mesh.splitEdge(h, place));
  }
  for (std::size_t i = 0; i < out.size(); ++i)
    if (mesh.findHalfedge(out[i], out[(i + 1) % out.size()]) < 0) return std::nullopt;
  std::vector<int> sorted = out;
  sortUnique(sorted);
  if (sorted.size() != out.size() || out.size() < 3) return std::nullopt;
  return out;
}

bool isAnnulus(const Opening& o, std::size_t lambda) {
  return o.loops.size() == 2 && eulerNumberOf(o) == 0 && o.lambda.size() == lambda;
}

//! Splits all edges that leave the loop, so that the stars of its vertices are a regular neighbourhood.
void narrow(Mesh& mesh, const std::vector<int>& loop) {
  std::vector<int> sorted = loop;
  sortUnique(sorted);
  std::map<int, int> next;
  for (std::size_t i = 0; i < loop.size(); ++i) next[loop[i]] = loop[(i + 1) % loop.size()];
  std::vector<std::pair<int, int>> chords, spokes;
  for (const int v : loop)
    mesh.forEachNeighbour(v, [&](int w) {
      if (!std::binary_search(sorted.begin(), sorted.end(), w))
        spokes.emplace_back(v, w);
      else if (v < w && next[v] != w && next[w] != v)
        chords.emplace_back(v, w);
    });
  const auto split = [&](int v, int w) {
    return mesh.splitEdge(mesh.findHalfedge(v, w), (mesh.position(v) + mesh.position(w)) / 2);
  };
  for (const auto& [v, w] : chords) {
    const int m = split(v, w);
    // Its edges to both ends, and to loop vertices across the two faces, are spokes now.
    mesh.forEachNeighbour(m, [&](int u) {
      if (std::binary_search(sorted.begin(), sorted.end(), u)) spokes.emplace_back(u, m);
    });
  }
  sortUnique(spokes);
  for (const auto& [v, w] : spokes)
    if (mesh.findHalfedge(v, w) >= 0) split(v, w);
}

enum class CapStyle { smooth, flat, fan };

std::optional<Patch> capOf(const Mesh& mesh, const Opening& opening, const std::vector<int>& loop,
                           CapStyle style) {
  if (loop.size() > (style == CapStyle::smooth ? kLongestSmooth : kLongestLoop)) return std::nullopt;
  if (style == CapStyle::smooth) return smoothCap(mesh, opening, loop);
  if (style == CapStyle::flat) return leastAreaCap(mesh, opening, loop);
  return fanCap(mesh, loop);
}

std::optional<Plan> planCaps(const Mesh& mesh, const Opening& opening, CapStyle style) {
  Plan plan;
  plan.openings.push_back(opening);
  plan.kind = EventKind::tunnelClosed;
  plan.patch.firstNew = mesh.vertexSlots();
  for (const auto& loop : opening.loops) {
    const auto cap = capOf(mesh, opening, loop, style);
    if (!cap) return std::nullopt;
    plan.patch.append(*cap);
  }
  return plan;
}

class Cutter {
 public:
  explicit Cutter(const Mesh& mesh) : mesh_(mesh), before_(topologyNumbers(mesh)) {}

  //! Tries what fits along the loop.
  std::optional<LoopCut> cut(const SurfaceLoop& loop) const {
    Mesh embedded = mesh_;
    const auto vertices = embed(embedded, loop);
    if (!vertices) return std::nullopt;
    return cutAt(embedded, *vertices);
  }

 private:
  std::optional<LoopCut> cutAt(const Mesh& embedded, const std::vector<int>& loop) const {
    Mesh narrowed = embedded;
    narrow(narrowed, loop);
    for (const CapStyle style : {CapStyle::smooth, CapStyle::flat, CapStyle::fan}) {
      if (style == CapStyle::fan && loop.size() > kLongestFan) break;
      for (const Mesh* mesh : {&embedded, static_cast<const Mesh*>(&narrowed)})
        if (auto done = attempt(*mesh, loop, style)) return done;
    }
    return std::nullopt;
  }

  std::optional<LoopCut> attempt(const Mesh& mesh, const std::vector<int>& loop, CapStyle style) const {
    giveUpIfCancelled();
    std::vector<int> lambda = loop;
    sortUnique(lambda);
    const auto opening = planOpening(mesh, lambda);
    if (!opening || !isAnnulus(*opening, lambda.size())) return std::nullopt;
    const auto plan = planCaps(mesh, *opening, style);
    if (!plan) return std::nullopt;
    LoopCut out{mesh, before_, {}, {}};
    const TopologyNumbers predicted = apply(out, *plan);
    out.after = topologyNumbers(out.mesh);
    const bool asPredicted = out.after == predicted && predicted.components == before_.components &&
                             predicted.genus == before_.genus - 1;
    if (!asPredicted || findStructureFault(out.mesh) || collides(out) || isMisplacedNow(out.mesh))
      return std::nullopt;
    return out;
  }

  TopologyNumbers apply(LoopCut& out, const Plan& plan) const {
    Mesh& mesh = out.mesh;
    const Opening& opening = plan.openings[0];
    for (const int f : opening.faces)
      out.touched.insert(out.touched.end(), mesh.face(f).begin(), mesh.face(f).end());
    mesh.removeFaces(opening.faces);
    for (const int v : opening.lambda) mesh.removeVertex(v);
    const TopologyNumbers predicted = predictChange(before_, mesh, plan);
    std::vector<int> fresh;
    for (const Vec3& p : plan.patch.points) fresh.push_back(mesh.addVertex(p));
    std::vector<Triangle> faces = plan.patch.faces;
    for (Triangle& t : faces)
      for (int& v : t)
        if (v >= plan.patch.firstNew) v = fresh[v - plan.patch.firstNew];
    mesh.addFaces(faces);
    out.touched.insert(out.touched.end(), fresh.begin(), fresh.end());
    sortUnique(out.touched);
    return predicted;
  }

  //! Whether a face that is new, or beside one, meets another.
  static bool collides(const LoopCut& out) {
    VertexMarks moved(idx(out.mesh.vertexSlots()), 0);
    for (const int v : out.touched)
      if (idx(v) < moved.size()) moved[v] = 1;
    CollisionDetector detector;
    return !detector.detectMoved(out.mesh, moved).empty();
  }

  bool isMisplacedNow(const Mesh& mesh) const {
    if (before_.components == 1) return false;
    const auto count = [](const Mesh& m) {
      const Components parts = findComponents(m);
      return misplacedComponents(labelled(m, parts)).size();
    };
    return count(mesh) > count(mesh_);
  }

  const Mesh& mesh_;
  TopologyNumbers before_;
};

}  // namespace

std::optional<LoopCut> cutAlong(const Mesh& mesh, const SurfaceLoop& loop) { return Cutter(mesh).cut(loop); }

std::optional<LoopCut> closeTunnel(const Mesh& mesh, const Tunnel& tunnel, LoopKind kind) {
  const Cutter cutter(mesh);
  if (auto done = cutter.cut(kind == LoopKind::handle ? tunnel.handle : tunnel.tunnel)) return done;
  for (const SurfaceLoop& loop : loopsBeside(mesh, tunnel, kind))
    if (auto done = cutter.cut(loop)) return done;
  return std::nullopt;
}

}  // namespace handlebody
