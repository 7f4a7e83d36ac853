// The ideal surface by marching tetrahedra. Each cell of a grid is cut into six tetrahedra around its main
// diagonal; every vertex lies on its own grid edge, where the signed distance is 0, and every triangle within
// its tetrahedron. So the mesh is closed, manifold and free of self-intersections by construction.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "sample_volumes/phantom.h"
#include "sample_volumes/placement.h"
#include "sample_volumes/shapes.h"

namespace handlebody {
namespace phantoms {
namespace {

constexpr double kCell = 0.8;      // mm
constexpr double kOffset = 0.317;  // cells: keeps grid planes off the flat faces of the shapes
// Vertices keep this part of the edge's length from its ends, so that no two coincide: at most
// 1e-3·sqrt(3)·kCell = 0.0014 mm beside the surface.
constexpr double kEndMargin = 1e-3;

class MarchingTetrahedra {
 public:
  MarchingTetrahedra(const Shape& shape, const Placement& place) : shape_(shape), place_(place) {
    low_ = -shape.objectHalf - Vec3::Constant((2 - kOffset) * kCell);
    for (std::size_t a = 0; a < 3; ++a)
      nodes_[a] = static_cast<int>(-2 * low_[static_cast<int>(a)] / kCell) + 2;
    values_.resize(nodeCount());
    for (std::size_t n = 0; n < values_.size(); ++n) values_[n] = shape.distance(nodePosition(n));
  }

  TriangleSoup run() {
    for (int z = 0; z + 1 < nodes_[2]; ++z)
      for (int y = 0; y + 1 < nodes_[1]; ++y)
        for (int x = 0; x + 1 < nodes_[0]; ++x) cell(nodeIndex(x, y, z));
    return std::move(soup_);
  }

 private:
  using Path = std::array<std::size_t, 4>;  // nodes of a tetrahedron

  std::size_t nodeCount() const { return nodeIndex(0, 0, nodes_[2]); }
  std::size_t nodeIndex(int x, int y, int z) const {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(nodes_[0]) *
               (static_cast<std::size_t>(y) +
                static_cast<std::size_t>(nodes_[1]) * static_cast<std::size_t>(z));
  }
  Vec3 nodePosition(std::size_t n) const {
    const std::size_t nx = static_cast<std::size_t>(nodes_[0]), ny = static_cast<std::size_t>(nodes_[1]);
    return low_ + kCell * Vec3(static_cast<double>(n % nx), static_cast<double>(n / nx % ny),
                               static_cast<double>(n / (nx * ny)));
  }
  bool inside(std::size_t n) const { return values_[n] < 0; }

  void cell(std::size_t n) {
    const std::array<std::size_t, 3> step{1, nodeIndex(0, 1, 0), nodeIndex(0, 0, 1)};
    const std::size_t last = n + step[0] + step[1] + step[2];
    int count = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
      count +=
          inside(n + (corner & 1U ? step[0] : 0) + (corner & 2U ? step[1] : 0) + (corner & 4U ? step[2] : 0));
    if (count == 0 || count == 8) return;
    for (std::size_t a = 0; a < 3; ++a) {
      // Even permutations of the axes give positively oriented tetrahedra, odd ones are turned.
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      tetrahedron({n, n + step[a], n + step[a] + step[b], last});
      tetrahedron({n, n + step[a], last, n + step[a] + step[c]});
    }
  }

  // Precondition: positively oriented.
  void tetrahedron(Path t) {
    const auto count = std::count_if(t.begin(), t.end(), [&](std::size_t n) { return inside(n); });
    if (count == 0 || count == 4) return;
    // The lonely vertex first, or the two inside ones; an odd permutation is mended by swapping the last two.
    const bool first = count != 3;
    bool odd = false;
    std::size_t placed = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (inside(t[i]) != first) continue;
      if (i != placed) {
        std::swap(t[i], t[placed]);
        odd = !odd;
      }
      ++placed;
    }
    if (odd) std::swap(t[2], t[3]);
    if (count == 2) {
      const std::array<int, 4> q{vertex(t[0], t[2]), vertex(t[0], t[3]), vertex(t[1], t[3]),
                                 vertex(t[1], t[2])};
      soup_.triangles.push_back({q[0], q[1], q[2]});
      soup_.triangles.push_back({q[0], q[2], q[3]});
      return;
    }
    Triangle cut{vertex(t[0], t[1]), vertex(t[0], t[2]), vertex(t[0], t[3])};
    if (count == 3) std::swap(cut[1], cut[2]);
    soup_.triangles.push_back(cut);
  }

  // The vertex on the edge between two nodes of different sign.
  int vertex(std::size_t a, std::size_t b) {
    if (a > b) std::swap(a, b);
    const auto [found, isNew] = vertices_.try_emplace(static_cast<std::uint64_t>(a) * nodeCount() + b,
                                                      static_cast<int>(soup_.points.size()));
    if (isNew) soup_.points.push_back(place_.toWorld(crossing(a, b)));
    return found->second;
  }

  // Regula falsi (Illinois) to 1e-7 mm; the signed distance is nearly linear along so short an edge.
  Vec3 crossing(std::size_t a, std::size_t b) const {
    const Vec3 from = nodePosition(a), along = nodePosition(b) - from;
    double low = 0, high = 1, atLow = values_[a], atHigh = values_[b];
    double t = 0.5;
    for (int turn = 0, side = 0; turn < 50; ++turn) {
      t = (low * atHigh - high * atLow) / (atHigh - atLow);
      const double value = shape_.distance(from + t * along);
      if (std::abs(value) < 1e-7) break;
      if ((value < 0) == (atLow < 0)) {
        low = t;
        atLow = value;
        if (side == -1) atHigh /= 2;
        side = -1;
      } else {
        high = t;
        atHigh = value;
        if (side == 1) atLow /= 2;
        side = 1;
      }
    }
    return from + std::clamp(t, kEndMargin, 1 - kEndMargin) * along;
  }

  const Shape& shape_;
  const Placement& place_;
  Vec3 low_{0, 0, 0};
  std::array<int, 3> nodes_{0, 0, 0};
  std::vector<double> values_;
  std::unordered_map<std::uint64_t, int> vertices_;
  TriangleSoup soup_;
};

}  // namespace
}  // namespace phantoms

TriangleSoup phantomSurface(const std::string& name, const PhantomOptions& options) {
  const phantoms::Shape& shape = phantoms::findShape(name);
  return phantoms::MarchingTetrahedra(shape, phantoms::placeShape(shape, options)).run();
}

}  // namespace handlebody
