#include "tests/bench/peers/outcome.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/collision/certify.h"
#include "core/mesh/union_find.h"

namespace handlebody::bench {

namespace {

//! The mesh without components of less than `least` mm³ (absolute).
TriangleSoup withoutSpecks(const TriangleSoup& mesh, double least) {
  UnionFind parts(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  std::vector<double> volume(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vec3& o = mesh.points[parts.find(t[0])];
    volume[parts.find(t[0])] += (a - o).dot((b - o).cross(c - o)) / 6;
  }
  TriangleSoup kept;
  kept.points = mesh.points;
  for (const Triangle& t : mesh.triangles)
    if (std::abs(volume[parts.find(t[0])]) >= least) kept.triangles.push_back(t);
  return kept;
}

//! Over the area of the surface, so that meshes of any fineness compare: each face gives the centres of the
//! sixteen equal ones that it falls into.
double meanDistance(const TriangleSoup& mesh, const Phantom& phantom, const PhantomOptions& options) {
  constexpr int n = 4;
  double sum = 0, weight = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const double area = (b - a).cross(c - a).norm();
    double face = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < 2 * (n - i) - 1; ++j) {
        // Two faces to a cell of the parallelogram: the even ones point like the whole, the odd ones back.
        const double u = (i + (j % 2 == 0 ? 1 : 2) / 3.0) / n, v = (j / 2 + (j % 2 == 0 ? 1 : 2) / 3.0) / n;
        face += std::abs(phantomDistance(phantom.name, options, a + u * (b - a) + v * (c - a)));
      }
    sum += area * face / (n * n);
    weight += area;
  }
  return weight > 0 ? sum / weight / phantom.volume.grid.meanSpacing() : 0;
}

}  // namespace

double dice(const std::vector<unsigned char>& label, const Volume& truth) {
  const auto* expected = truth.data<std::uint8_t>();
  double both = 0, sum = 0;
  for (std::size_t v = 0; v < label.size(); ++v) {
    both += label[v] != 0 && expected[v] != 0;
    sum += (label[v] != 0) + (expected[v] != 0);
  }
  return sum > 0 ? 2 * both / sum : 0;
}

void judge(Outcome& outcome, const TriangleSoup& mesh, const Phantom& phantom,
           const PhantomOptions& options) {
  const TriangleSoup kept = withoutSpecks(mesh, kSpeck * phantom.volume.grid.voxelVolume());
  Certificate c = certify(kept);
  outcome.distance = meanDistance(kept, phantom, options);
  outcome.vertices = c.vertices;
  outcome.components = c.components;
  outcome.genus = std::accumulate(c.genus.begin(), c.genus.end(), 0);
  outcome.selfIntersections = c.selfIntersections;
  std::vector<int> expected = phantom.genus;
  std::sort(expected.begin(), expected.end());
  std::sort(c.genus.begin(), c.genus.end());
  outcome.rightTopology = c.genus == expected;
}

}  // namespace handlebody::bench
