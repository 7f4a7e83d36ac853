#include "core/surgery/smooth_cap.h"

#include <algorithm>
#include <cmath>

namespace handlebody {

namespace {

constexpr double kLongest = 1.5;  // edge, in mean sides of the polygon
constexpr int kPasses = 12;       // of splitting: an edge may be 2^12 times too long
constexpr int kRelaxations = 12;  // after each pass
constexpr int kLastRelaxations = 60;
constexpr int kMaxVertices = 50000;

//! A disc with the first `rim` vertices on its boundary, in order, made a sphere by a pole that is joined to
//! all of them: the mesh's operations are for closed surfaces. The pole comes next, then the vertices within.
class Membrane {
 public:
  Membrane(const TriangleSoup& soup, int rim) : mesh_(soup), rim_(rim) {
    double sum = 0;
    for (int i = 0; i < rim; ++i) sum += (mesh_.position(i) - mesh_.position((i + 1) % rim)).norm();
    longest_ = kLongest * sum / rim;
  }

  void refine() {
    for (int pass = 0; pass < kPasses; ++pass) {
      const bool any = splitLongEdges();
      flip();
      relax(kRelaxations);
      if (!any || mesh_.vertexSlots() > kMaxVertices) break;
    }
    flip();
    relax(kLastRelaxations);
  }
  const Mesh& mesh() const { return mesh_; }

 private:
  double length(int h) const {
    return (mesh_.position(mesh_.target(h)) - mesh_.position(mesh_.origin(h))).norm();
  }

  bool splitLongEdges() {
    std::vector<std::pair<double, int>> edges;
    for (int h = 0; h < 3 * mesh_.faceSlots(); ++h)
      if (isWithin(h) && (length(h) > longest_ || joinsRim(h))) edges.emplace_back(-length(h), h);
    std::sort(edges.begin(), edges.end());
    bool any = false;
    for (const auto& [l, h] : edges) {
      // A split before may have halved it. An edge across the disc leaves no room for a smooth membrane.
      if (length(h) <= longest_ && !joinsRim(h)) continue;
      mesh_.splitEdge(h, (mesh_.position(mesh_.origin(h)) + mesh_.position(mesh_.target(h))) / 2);
      any = true;
    }
    return any;
  }
  //! One half-edge of each edge between faces of the disc.
  bool isWithin(int h) const {
    const int g = mesh_.opposite(h);
    return h < g && mesh_.origin(h) != rim_ && mesh_.target(h) != rim_ && mesh_.apex(h) != rim_ &&
           mesh_.apex(g) != rim_;
  }
  bool joinsRim(int h) const { return mesh_.origin(h) < rim_ && mesh_.target(h) < rim_; }

  //! Delaunay flips until there is none, or a few times.
  void flip() {
    for (int round = 0; round < 4; ++round) {
      bool any = false;
      for (int h = 0; h < 3 * mesh_.faceSlots(); ++h)
        if (isWithin(h) && flipImproves(h) && mesh_.canFlip(h)) {
          mesh_.flipEdge(h);
          any = true;
        }
      if (!any) return;
    }
  }
  bool flipImproves(int h) const {
    const int c = mesh_.apex(h), d = mesh_.apex(mesh_.opposite(h));
    if (c < rim_ && d < rim_) return false;
    const auto angle = [&](int apex) {
      const Vec3 p = mesh_.position(mesh_.origin(h)) - mesh_.position(apex);
      const Vec3 q = mesh_.position(mesh_.target(h)) - mesh_.position(apex);
      return p.dot(q) / std::max(p.norm() * q.norm(), 1e-300);
    };
    return angle(c) + angle(d) < -0.1;
  }

  //! Every vertex within goes to the middle of its neighbours.
  void relax(int times) {
    for (int i = 0; i < times; ++i)
      for (int v = rim_ + 1; v < mesh_.vertexSlots(); ++v) {
        Vec3 sum(0, 0, 0);
        int n = 0;
        mesh_.forEachNeighbour(v, [&](int w) {
          sum += mesh_.position(w);
          ++n;
        });
        mesh_.setPosition(v, sum / n);
      }
  }

  Mesh mesh_;
  int rim_;
  double longest_ = 0;
};

}  // namespace

std::optional<Patch> smoothCap(const Mesh& mesh, const Opening& opening, const std::vector<int>& loop) {
  const std::optional<Patch> flat = leastAreaCap(mesh, opening, loop);
  if (!flat) return std::nullopt;
  TriangleSoup soup;
  std::vector<std::pair<int, int>> number;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    soup.points.push_back(mesh.position(loop[i]));
    number.emplace_back(loop[i], static_cast<int>(i));
  }
  std::sort(number.begin(), number.end());
  for (Triangle t : flat->faces) {
    for (int& v : t) v = std::lower_bound(number.begin(), number.end(), std::pair(v, -1))->second;
    soup.triangles.push_back(t);
  }
  const int rim = static_cast<int>(loop.size());
  soup.points.push_back(soup.points[0]);
  for (int i = 0; i < rim; ++i) soup.triangles.push_back({(i + 1) % rim, i, rim});
  Membrane membrane(soup, rim);
  membrane.refine();
  Patch out;
  out.firstNew = mesh.vertexSlots();
  for (int v = rim + 1; v < membrane.mesh().vertexSlots(); ++v)
    out.points.push_back(membrane.mesh().position(v));
  for (Triangle t : membrane.mesh().faces()) {
    if (t[0] == rim || t[1] == rim || t[2] == rim) continue;
    for (int& v : t) v = v < rim ? loop[v] : out.firstNew + v - rim - 1;
    out.faces.push_back(t);
  }
  return out;
}

}  // namespace handlebody
