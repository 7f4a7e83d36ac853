#pragma once
// Small volumes, and evolution with a look at every step.

#include <Eigen/Geometry>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>

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

//! Runs to the end. After every step the mesh must pass the certificate and agree with the report.
inline std::vector<StepReport> runCertified(ActiveContour& contour) {
  std::vector<StepReport> reports;
  TopologyNumbers now = topologyNumbers(contour.mesh());
  while (contour.stopReason() == StopReason::running) {
    reports.push_back(contour.step());
    const StepReport& r = reports.back();
    REQUIRE(reports.size() < 5000);
    const Certificate c = certify(contour.mesh().compact());
    CAPTURE(r.iteration, c.closed, c.manifold, c.oriented, c.selfIntersections);
    if (!c.passes()) FAIL("a step left an invalid mesh");
    for (const Event& e : r.events) {
      CAPTURE(eventKindName(e.kind));
      if (e.before.euler != now.euler || e.before.components != now.components)
        FAIL_CHECK("the event's Euler number " << e.before.euler << " and " << e.before.components
                                               << " components are not the mesh's " << now.euler << ", "
                                               << now.components);
      now = e.after;
    }
    if (c.euler != now.euler || c.components != now.components)
      FAIL_CHECK("Euler number " << c.euler << " and " << c.components << " components, the events say "
                                 << now.euler << ", " << now.components);
    now = topologyNumbers(contour.mesh());
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
