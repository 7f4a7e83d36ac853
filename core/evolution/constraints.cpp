#include "core/evolution/constraints.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/evolution/edit_step.h"
#include "core/mesh/mesh.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

using K = FindingKind;

[[noreturn]] void refuse(const Finding& finding) { throw Told<UsageError>(finding); }
[[noreturn]] void refuseAt(const Vec3& place, K kind) { refuse({kind, {{"place", placeValue(place)}}}); }

bool hasBall(const Vec3& centre, double radius) {
  return radius > 0 && std::isfinite(radius) && centre.allFinite();
}

//! mm from the volume, whose border voxels count whole; 0 within.
double outside(const Grid& grid, const Vec3& p) {
  const Vec3 index = grid.toIndex(p);
  Vec3 nearest;
  for (int a = 0; a < 3; ++a) nearest[a] = std::clamp(index[a], -0.5, grid.size[a] - 0.5);
  if (nearest == index) return 0;  // there and back again would be off by rounding where the axes are oblique
  return (grid.toWorld(nearest) - p).norm();
}

void requireSensible(const Pin& pin, const Grid& grid) {
  if (!hasBall(pin.centre, pin.radius)) refuseAt(pin.centre, K::pinWithoutRadius);
  if (pin.iteration < 0) refuseAt(pin.centre, K::pinIterationNegative);
  if (outside(grid, pin.centre) >= pin.radius) refuseAt(pin.centre, K::pinOutside);
}

void requireSensible(const WallList& walls, const Grid& grid) {
  for (const WallBall& w : walls.balls) {
    if (!hasBall(w.centre, w.radius)) refuseAt(w.centre, K::wallWithoutRadius);
    if (outside(grid, w.centre) >= w.radius) refuseAt(w.centre, K::wallOutside);
  }
  for (const WallDisc& w : walls.discs) {
    if (!hasBall(w.centre, w.radius)) refuseAt(w.centre, K::wallDiscWithoutRadius);
    if (!(w.normal.norm() > 0) || !std::isfinite(w.normal.norm()))
      refuseAt(w.centre, K::wallDiscWithoutNormal);
    if (outside(grid, w.centre) >= w.radius) refuseAt(w.centre, K::wallDiscOutside);
  }
  for (const WallObject& object : walls.objects)
    if (!object.mesh || object.mesh->triangles.empty()) refuse({K::objectNoWall, {{"object", object.name}}});
  if (!walls.map) return;
  if (!walls.map->voxels) refuse(K::wallMapNotRead);
  if (walls.map->voxels->size() != grid.voxelCount()) refuse(K::wallMapOtherSize);
}

//! What is answered to the limits needs one, and lies in the volume.
void requireSensiblePlaces(const TopologyLimits& limits, const Grid& grid) {
  const bool isAny = limits.components || limits.genus;
  if (!isAny && !limits.allowed.empty()) refuse(K::nothingToAllow);
  if (!isAny && !limits.kept.empty()) refuse(K::nothingToHold);
  if (!isAny && limits.asks) refuse(K::nothingToAsk);
  for (const auto& [places, kind] :
       {std::pair(&limits.allowed, K::allowedOutside), std::pair(&limits.kept, K::heldOutside)})
    for (const Vec3& p : *places)
      if (!p.allFinite() || outside(grid, p) > 0) refuseAt(p, kind);
}

void requireSensible(const StartSurface& start, const Grid& grid) {
  if (!start.mesh || start.mesh->triangles.empty()) refuse({K::startNotRead, {{"file", start.path}}});
  if (outside(grid, start.inside) > 0) refuse({K::startOutside, {{"file", start.path}}});
}

//! A step is one edit, and nothing else happens in it.
void requireSensibleEdits(const Constraints& c) {
  std::vector<int> taken;
  for (const MeshEdit& e : c.edits) {
    if (e.iteration < 1 || !e.place.allFinite()) refuse(K::editWithoutPlace);
    if (const Finding fault = faultOf(e); fault.any()) refuse(fault);
    if (std::find(taken.begin(), taken.end(), e.iteration) != taken.end())
      refuse({K::editTwice, {{"iteration", e.iteration}}});
    taken.push_back(e.iteration);
  }
  for (const Veto& v : c.vetoes)
    if (std::find(taken.begin(), taken.end(), v.iteration) != taken.end())
      refuse({K::vetoOfEdit, {{"iteration", v.iteration}}});
}

}  // namespace

std::string written(const Vec3& p) {
  std::ostringstream text;
  text << p.x() << "," << p.y() << "," << p.z();
  return text.str();
}

std::string written(const WallDisc& d) {
  std::ostringstream text;
  text.precision(12);
  for (const Vec3& v : {d.centre, d.normal}) text << v.x() << ',' << v.y() << ',' << v.z() << ',';
  text << d.radius;
  return text.str();
}

std::string written(const Pin& p) {
  std::ostringstream text;
  text.precision(12);
  text << p.centre.x() << ',' << p.centre.y() << ',' << p.centre.z() << ',' << p.radius << '@' << p.iteration;
  return text.str();
}

bool StartSurface::operator==(const StartSurface& other) const {
  if (isDone != other.isDone) return false;
  if (mesh && other.mesh)
    return mesh == other.mesh ||
           (mesh->points == other.mesh->points && mesh->triangles == other.mesh->triangles);
  return path == other.path && sha256 == other.sha256 && label == other.label && among == other.among &&
         shape == other.shape;
}

bool WallMap::operator==(const WallMap& other) const {
  if (voxels == other.voxels && voxels) return true;
  if (voxels && other.voxels) return *voxels == *other.voxels;
  return path == other.path && sha256 == other.sha256;
}

void requireSensible(const Constraints& constraints, const Grid& grid) {
  requireSensible(constraints.walls, grid);
  if (constraints.start) requireSensible(*constraints.start, grid);
  for (const Pin& p : constraints.pins) requireSensible(p, grid);
  for (const Veto& v : constraints.vetoes)
    if (v.iteration < 1 || !v.place.allFinite()) refuse(K::vetoWithoutPlace);
  requireSensibleEdits(constraints);
  if (constraints.topology.components.value_or(1) < 1) refuse(K::componentsTooFew);
  if (constraints.topology.genus.value_or(0) < 0) refuse(K::genusNegative);
  requireSensiblePlaces(constraints.topology, grid);
}

}  // namespace handlebody
