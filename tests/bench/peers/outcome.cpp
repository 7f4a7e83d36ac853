#include "tests/bench/peers/outcome.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/collision/certify.h"
#include "core/mesh/union_find.h"

namespace handlebody::bench {

namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

//! The mesh without components of less than `least` mm³ (absolute).
TriangleSoup withoutSpecks(const TriangleSoup& mesh, double least) {
  UnionFind parts(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  std::vector<double> volume(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[idx(t[0])], &b = mesh.points[idx(t[1])], &c = mesh.points[idx(t[2])];
    const Vec3& o = mesh.points[idx(parts.find(t[0]))];
    volume[idx(parts.find(t[0]))] += (a - o).dot((b - o).cross(c - o)) / 6;
  }
  TriangleSoup kept;
  kept.points = mesh.points;
  for (const Triangle& t : mesh.triangles)
    if (std::abs(volume[idx(parts.find(t[0]))]) >= least) kept.triangles.push_back(t);
  return kept;
}

double meanDistance(const TriangleSoup& mesh, const Phantom& phantom, const PhantomOptions& options) {
  double sum = 0, count = 0;
  const auto add = [&](const Vec3& p) {
    sum += std::abs(phantomDistance(phantom.name, options, p));
    count += 1;
  };
  for (const Triangle& t : mesh.triangles) {
    for (int v : t) add(mesh.points[idx(v)]);
    add((mesh.points[idx(t[0])] + mesh.points[idx(t[1])] + mesh.points[idx(t[2])]) / 3);
  }
  return count > 0 ? sum / count / phantom.volume.grid.meanSpacing() : 0;
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
