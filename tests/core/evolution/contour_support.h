#pragma once
// Small volumes, and evolution with a look at every step.

#include <Eigen/Geometry>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/collision/certify.h"
#include "core/evolution/active_contour.h"
#include "core/surgery/topology_adaptation.h"
#include "tests/support/catch.h"
#include "tests/support/surgery_support.h"
#include "tests/support/test_volume.h"

namespace handlebody::testing {

inline const Vec3 kMiddle(20, 20, 20);  // of a grid of 41³ voxels
constexpr double kTorusR = 11.5, kTorusr = 6;
inline const double kBallVolume = 4.0 / 3 * M_PI * 1000;
inline const double kTorusVolume = 2 * M_PI * M_PI * kTorusR * kTorusr * kTorusr;

inline double ballDistance(const Vec3& p) { return (p - kMiddle).norm() - 10; }
inline double torusDistance(const Vec3& p) {
  const Vec3 q = p - kMiddle;
  return std::hypot(std::hypot(q.x(), q.y()) - kTorusR, q.z()) - kTorusr;
}

//! A dark object (20) in a bright background (200) whose edge lies at the half-way level 110. No two voxels
//! have quite the same value, so that the background is not taken for padding.
template <typename F>
Volume darkObject(const Grid& grid, F&& distance) {
  return volumeByIndex(grid, [&](int i, int j, int k) {
    const double t = std::clamp(distance(grid.toWorld(Vec3(i, j, k))) + 0.5, 0.0, 1.0);
    return 20 + 180 * t + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  });
}

//! A ball of radius 10 mm.
inline Volume ballVolume() { return darkObject(cubicGrid(41), ballDistance); }
//! A torus round the z axis.
inline Volume torusVolume() { return darkObject(cubicGrid(41), torusDistance); }

//! Mean distance of the middles of the faces from a surface, weighted with their areas.
template <typename F>
double meanDistance(const Mesh& mesh, F&& distance) {
  double sum = 0, area = 0;
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    const Triangle& t = mesh.face(f);
    const Vec3 middle = (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
    const double weight = mesh.areaVector(f).norm();
    sum += weight * std::abs(distance(middle));
    area += weight;
  }
  return sum / area;
}

inline double furthestFrom(const Mesh& mesh, double (*distance)(const Vec3&)) {
  double furthest = 0;
  for (const Vec3& p : mesh.compact().points) furthest = std::max(furthest, std::abs(distance(p)));
  return furthest;
}

//! Bit for bit: slots, free slots and their order too, since they decide how the mesh goes on.
inline bool isSame(const Mesh& a, const Mesh& b) {
  if (a.vertexSlots() != b.vertexSlots() || a.faceSlots() != b.faceSlots()) return false;
  for (int v = 0; v < a.vertexSlots(); ++v)
    if (a.isVertex(v) != b.isVertex(v) || a.outgoing(v) != b.outgoing(v) || a.position(v) != b.position(v))
      return false;
  for (int f = 0; f < a.faceSlots(); ++f)
    if (a.face(f) != b.face(f)) return false;
  return true;
}

//! Numbers of a mesh, from its triangles alone.
struct PlainCount {
  int vertices = 0, components = 0, euler = 0;
  double volume = 0;  //!< mm³
};

//! Counted anew, without anything of the engine: edges in a list, components by joining labels, and the
//! volume below every face (the engine sums tetrahedra).
inline PlainCount countPlainly(const TriangleSoup& soup) {
  std::vector<int> label(soup.points.size());
  std::iota(label.begin(), label.end(), 0);
  const auto root = [&](int v) {
    while (label[v] != v) v = label[v] = label[label[v]];
    return v;
  };
  std::vector<std::pair<int, int>> edges;
  std::vector<unsigned char> used(soup.points.size(), 0);
  PlainCount n;
  for (const Triangle& t : soup.triangles) {
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    const double shadow = ((b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y())) / 2;
    n.volume += shadow * (a.z() + b.z() + c.z()) / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const int v = t[i], w = t[(i + 1) % 3];
      used[v] = 1;
      edges.emplace_back(std::min(v, w), std::max(v, w));
      label[root(v)] = root(w);
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto distinct = std::unique(edges.begin(), edges.end()) - edges.begin();
  for (int v = 0; v < static_cast<int>(soup.points.size()); ++v) {
    n.vertices += used[v];
    n.components += used[v] && root(v) == v;
  }
  n.euler = n.vertices - static_cast<int>(distinct) + static_cast<int>(soup.triangles.size());
  return n;
}

//! What the report of a step says of the mesh that it left is what is counted there.
inline void expectReported(const StepReport& report, const PlainCount& before, const PlainCount& now) {
  // Both sum some thousand terms of a size like the volume's: 1e-16 each, with room for ten thousand.
  CHECK(report.volume == Approx(now.volume).epsilon(1e-11).margin(1e-9));
  CHECK(report.unmovedVertices == std::max(0, now.vertices - report.movedVertices));
  CHECK(report.movedVertices <= before.vertices);
  CHECK((report.movedVertices == 0 || report.largestMove > 0));
}

//! Runs to the end. After every step the mesh must pass the certificate and agree with the report, by numbers
//! that are counted without the engine.
inline std::vector<StepReport> runCertified(ActiveContour& contour) {
  std::vector<StepReport> reports;
  PlainCount counted = countPlainly(contour.mesh().compact());
  while (contour.stopReason() == StopReason::running) {
    reports.push_back(contour.step());
    const StepReport& r = reports.back();
    REQUIRE(reports.size() < 5000);
    const TriangleSoup mesh = contour.mesh().compact();
    const Certificate c = certify(mesh);
    CAPTURE(r.iteration, c.closed, c.manifold, c.oriented, c.selfIntersections);
    if (!c.passes()) FAIL("a step left an invalid mesh");
    const PlainCount before = std::exchange(counted, countPlainly(mesh));
    expectReported(r, before, counted);
    TopologyNumbers now{before.components, before.euler, 0};
    for (const Event& e : r.events) {
      CAPTURE(eventKindName(e.kind));
      if (e.before.euler != now.euler || e.before.components != now.components)
        FAIL_CHECK("the event's Euler number " << e.before.euler << " and " << e.before.components
                                               << " components are not the mesh's " << now.euler << ", "
                                               << now.components);
      now = e.after;
    }
    if (counted.euler != now.euler || counted.components != now.components)
      FAIL_CHECK("Euler number " << counted.euler << " and " << counted.components
                                 << " components, the events say " << now.euler << ", " << now.components);
    if (c.euler != counted.euler || c.components != counted.components || c.vertices != counted.vertices)
      FAIL_CHECK("the certificate counts otherwise");
  }
  return reports;
}

inline int countEvents(const std::vector<StepReport>& reports, EventKind kind) {
  int n = 0;
  for (const StepReport& r : reports)
    for (const Event& e : r.events) n += e.kind == kind;
  return n;
}

//! What is thrown, in words; empty: nothing.
inline std::string messageOf(const std::function<void()>& f) {
  try {
    f();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace handlebody::testing
