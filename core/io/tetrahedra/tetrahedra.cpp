#include "core/io/tetrahedra/tetrahedra.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/collision/closest_point.h"
#include "core/errors.h"
#include "core/io/tetrahedra/mesher_process.h"
#include "core/mesh/containment.h"
#include "core/mesh/pieces.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

//! Of the volume: what rounding may make of it. A lost or added cell is far more in any mesh that can be
//! meshed at all.
constexpr double kSameVolume = 1e-6;

//! A point in front of the largest face of a component, with no other face between: in a cavity, inside of
//! it.
Vec3 pointBefore(const TriangleSoup& mesh, const std::vector<int>& component, int wanted,
                 const ClosestPoint& nearest) {
  double largest = -1;
  Vec3 centre = Vec3::Zero(), normal = Vec3::Zero();
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (component[f] != wanted) continue;
    const Triangle& t = mesh.triangles[f];
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vec3 n = (b - a).cross(c - a);
    if (!(n.norm() > largest)) continue;
    largest = n.norm();
    centre = (a + b + c) / 3;
    normal = n.normalized();
  }
  double away = std::sqrt(largest) / 2;
  for (int halvings = 0; halvings < 40 && nearest.distance(centre + away * normal) < 0.5 * away; ++halvings)
    away /= 2;
  return centre + away * normal;
}

MesherInput inputOf(const TriangleSoup& surface) {
  MesherInput in;
  in.mesh = withoutLoosePoints(surface);
  const Mesh structure(in.mesh);
  const Components parts = findComponents(structure);
  for (const Triangle& t : in.mesh.triangles) in.component.push_back(parts.ofVertex[t[0]]);
  const std::vector<int> bodyOf = bodyOfComponents(parts, surroundingComponents(structure, parts));
  const ClosestPoint nearest(in.mesh);
  for (int c = 0; c < parts.count(); ++c) {
    if (bodyOf[c] == c) {
      in.bodies.push_back({c});
      for (int d = 0; d < parts.count(); ++d)
        if (d != c && bodyOf[d] == c) in.bodies.back().push_back(d);
    } else {
      in.holes.push_back(pointBefore(in.mesh, in.component, c, nearest));
    }
  }
  return in;
}

double volumeOf(const std::vector<Vec3>& p, const std::array<int, 4>& c) {
  return (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]).dot(p[c[3]] - p[c[0]]) / 6;
}

//! Turns cells that are left-handed. Empty if they fill the object.
std::string faultOf(MesherOutput& made, const std::string& program, double volume) {
  if (!made.fault.empty()) return made.fault;
  double filled = 0;
  for (auto& cell : made.cells) {
    const double v = volumeOf(made.points, cell);
    if (v < 0) std::swap(cell[2], cell[3]);
    if (v == 0) return program + " made a tetrahedron without volume";
    filled += std::abs(v);
  }
  if (std::abs(filled - volume) <= kSameVolume * volume) return {};
  return program + " made tetrahedra that do not fill it (" + std::to_string(filled) + " of " +
         std::to_string(volume) + " mm3)";
}

MesherOutput fill(const ExportedObject& object, double seconds) {
  const MesherInput input = inputOf(object.mesh);
  const double volume = signedVolume(Mesh(input.mesh));
  std::string faults;
  using Run = MesherOutput (*)(const std::string&, const MesherInput&, double);
  const std::array<std::tuple<const char*, const char*, Run>, 2> programs{
      std::tuple{"gmsh", "gmsh", &runGmsh}, std::tuple{"tetgen", "TetGen", &runTetgen}};
  for (const auto& [file, name, run] : programs) {
    const auto program = findProgram(file);
    if (!program) continue;
    MesherOutput made = run(*program, input, seconds);
    const std::string fault = faultOf(made, name, volume);
    if (fault.empty()) return made;
    faults += (faults.empty() ? "" : "; ") + fault;
  }
  const Finding cause =
      faults.empty() ? Finding(FindingKind::noMesher) : Finding(FindingKind::other, {{"text", faults}});
  throw Told<OutputError>(Finding(FindingKind::noTetrahedra, {{"object", object.label.name}}, cause));
}

}  // namespace

std::string tetrahedraFault() {
  if (findProgram("gmsh") || findProgram("tetgen")) return {};
  return sentence(FindingKind::noMesher);
}

Tetrahedra fillWithTetrahedra(const std::vector<ExportedObject>& objects, double mesherSeconds) {
  Tetrahedra all;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const MesherOutput made = fill(objects[i], mesherSeconds);
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), made.points.begin(), made.points.end());
    for (std::array<int, 4> cell : made.cells) {
      for (int& v : cell) v += first;
      all.cells.push_back(cell);
      all.object.push_back(static_cast<int>(i));
    }
  }
  return all;
}

}  // namespace handlebody
