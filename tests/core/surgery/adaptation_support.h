#pragma once
// Colliding meshes, and adaptation until nothing collides.

#include "core/surgery/topology_adaptation.h"
#include "tests/support/expect_valid.h"
#include "tests/support/mesh_zoo.h"
#include "tests/support/surgery_support.h"

namespace handlebody::testing {

inline std::string text(const TopologyNumbers& n) {
  return std::to_string(n.components) + " components, Euler " + std::to_string(n.euler) + ", genus " +
         std::to_string(n.genus);
}

//! One round, with the topology numbers that it is to be given.
inline AdaptationResult adaptOnce(Mesh& mesh, std::span<const FacePair> pairs, AdaptationSettings settings,
                                  std::vector<unsigned char>& touched) {
  settings.topology = topologyNumbers(mesh);
  return adaptTopology(mesh, pairs, settings, touched);
}

//! Detection and adaptation in rounds, as in a step. Checks that the numbers of the events follow each other
//! and lead to those of the mesh.
inline AdaptationResult adaptFully(Mesh& mesh, const AdaptationSettings& settings = {}) {
  AdaptationResult all;
  for (int round = 0; round < 6 && all.conflicts.empty(); ++round) {
    const auto pairs = intersections(mesh);
    if (pairs.empty()) break;
    std::string now = text(topologyNumbers(mesh));
    std::vector<unsigned char> touched;
    AdaptationResult result = adaptOnce(mesh, pairs, settings, touched);
    for (Event& e : result.events) {
      CAPTURE(eventKindName(e.kind));
      CHECK(text(e.before) == now);
      now = text(e.after);
      all.events.push_back(std::move(e));
    }
    CHECK(text(topologyNumbers(mesh)) == now);
    all.conflicts = std::move(result.conflicts);
  }
  return all;
}

inline const Event* findEvent(const AdaptationResult& result, EventKind kind) {
  for (const Event& e : result.events)
    if (e.kind == kind) return &e;
  return nullptr;
}

//! Nothing intersects, and the mesh is a closed manifold of this topology.
inline void expectAdapted(const Mesh& mesh, int components, int genus) {
  CHECK(intersections(mesh).empty());
  expectValid(mesh);
  expectTopology(mesh, components, genus);
}

//! A closed surface of revolution about z with the profile radius(t), z(t) for t in [0, 1], zero at the ends.
template <typename R, typename Z>
TriangleSoup revolution(int along, int around, R&& radius, Z&& z) {
  TriangleSoup s;
  s.points.emplace_back(0, 0, z(0.0));
  for (int i = 1; i < along; ++i)
    for (int j = 0; j < around; ++j) {
      const double t = static_cast<double>(i) / along,
                   u = 2 * std::numbers::pi * (j + 0.5 * (i % 2)) / around;
      s.points.emplace_back(radius(t) * std::cos(u), radius(t) * std::sin(u), z(t));
    }
  s.points.emplace_back(0, 0, z(1.0));
  const int last = static_cast<int>(s.points.size()) - 1;
  const auto id = [&](int i, int j) { return 1 + (i - 1) * around + (j + around) % around; };
  for (int j = 0; j < around; ++j) {
    s.triangles.push_back({0, id(1, j + 1), id(1, j)});
    s.triangles.push_back({last, id(along - 1, j), id(along - 1, j + 1)});
    for (int i = 1; i + 1 < along; ++i) {
      if (i % 2 == 0) {
        s.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j)});
        s.triangles.push_back({id(i, j + 1), id(i + 1, j + 1), id(i + 1, j)});
      } else {
        s.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
        s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
      }
    }
  }
  return s;
}

//! Two bulbs of radius 0.5 on the z axis, with a neck of the given radius. Negative: one ring of vertices has
//! just run through itself, as the rings of a front that closes do.
inline TriangleSoup peanut(double neck) {
  return revolution(
      24, 12,
      [neck](double t) {
        const double x = 2 * t - 1;  // -1 … 1
        const double bulb = 0.5 * std::sqrt(std::max(0.0, 1 - (2 * std::abs(x) - 1) * (2 * std::abs(x) - 1)));
        const double middle = neck + 8 * x * x;
        return std::min(bulb + (std::abs(x) < 0.5 ? std::max(0.0, neck) : 0.0), middle);
      },
      [](double t) { return 2 * t - 1; });
}

//! A peanut-shaped cavity in a ball of radius 2.
inline TriangleSoup cavityWithNeck(double neck) {
  TriangleSoup cavity = peanut(neck);
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  return zoo::both(zoo::scaled(zoo::sphere(10), 2), cavity);
}

//! A tube with rounded ends, bent to a circle of radius 1; its tips lie `overlap` mm within each other.
inline TriangleSoup bentTube(double overlap) {
  const double r = 0.25, length = 2 * std::numbers::pi + overlap;
  TriangleSoup s = revolution(
      50, 10,
      [&](double t) {
        const double end = std::min(t, 1 - t) * length;
        return end < r ? std::sqrt(std::max(0.0, r * r - (r - end) * (r - end))) : r;
      },
      [&](double t) { return t * length; });
  for (Vec3& p : s.points) {
    const double u = p.z() - overlap / 2;
    // Orientation: (x, y, z) → (radial, up, along) is a right-handed frame when up is -z.
    p = Vec3((1 + p.x()) * std::cos(u), (1 + p.x()) * std::sin(u), -p.y());
  }
  return s;
}

//! Half circles of radius 1 from pole to pole of the z axis, as tubes with round ends that come to within
//! `gap` mm of the axis: fronts that meet in two nodes. Finer by the factor.
inline TriangleSoup meridians(int count, double gap, int finer = 1) {
  const double r = 0.25, length = std::numbers::pi - 2 * gap;
  TriangleSoup all;
  for (int k = 0; k < count; ++k) {
    TriangleSoup s = revolution(
        26 * finer, 10 * finer,
        [&](double t) {
          const double end = std::min(t, 1 - t) * length;
          return end < r ? std::sqrt(std::max(0.0, r * r - (r - end) * (r - end))) : r;
        },
        [&](double t) { return t * length; });
    const double turn = 2 * std::numbers::pi * k / count;
    for (Vec3& p : s.points) {
      const double u = p.z() + gap;
      const double out = (1 + p.x()) * std::sin(u), up = (1 + p.x()) * std::cos(u), side = -p.y();
      p = Vec3(out * std::cos(turn) - side * std::sin(turn), out * std::sin(turn) + side * std::cos(turn),
               up);
    }
    all = k == 0 ? s : zoo::both(all, s);
  }
  return all;
}

//! A ball of radius 1, whose top is dented within `rim` of the z axis: the rim stands out around the dent.
inline TriangleSoup dentedBall(double rim, double depth) {
  TriangleSoup s = zoo::sphere(24);
  for (Vec3& p : s.points) {
    const double t = std::hypot(p.x(), p.y()) / rim;
    if (p.z() > 0 && t < 1) p.z() = std::sqrt(1 - rim * rim) - depth * (1 - t * t);
  }
  return s;
}

//! A plate of 1 × 1 × 0.2 mm whose upper side is dented in the middle and comes out of the lower one.
inline TriangleSoup dentedPlate() {
  TriangleSoup s = zoo::cube(12);
  for (Vec3& p : s.points) {
    const double fromAxis = std::hypot(p.x() - 0.51, p.y() - 0.49);
    const bool onTop = p.z() == 1;
    p.z() *= 0.2;
    if (onTop) p.z() -= std::max(0.0, 0.24 * (1 - fromAxis / 0.35));
  }
  return s;
}

}  // namespace handlebody::testing
