#include "core/solid/guarded_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/cancellation.h"
#include "core/collision/near_points.h"
#include "core/geometry/triangle_angles.h"
#include "core/indices.h"
#include "core/mesh/nesting.h"
#include "core/mesh/structure.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

constexpr int kRoundsAlone = 3;  // in which a vertex goes back without its neighbours
constexpr int kMaxRounds = 40;
constexpr int kMaxAttempts = 6;
constexpr double kSurroundings = 2;  // longest edges

//! Relative to a point of each component, so that far from the origin no digits are lost.
std::vector<GuardedMesh::Measure> measuresOf(const Mesh& mesh, const std::vector<int>& component,
                                             std::size_t count) {
  std::vector<GuardedMesh::Measure> measures(count);
  std::vector<int> origin(count, -1);
  for (const Triangle& t : mesh.faces()) {
    if (t[0] < 0) continue;
    const auto c = idx(component[t[0]]);
    if (origin[c] < 0) origin[c] = t[0];
    const Vec3& o = mesh.position(origin[c]);
    const Vec3 a = mesh.position(t[0]) - o, b = mesh.position(t[1]) - o, d = mesh.position(t[2]) - o;
    measures[c].volume += a.dot(b.cross(d)) / 6;
    measures[c].area += (b - a).cross(d - a).norm() / 2;
  }
  return measures;
}

//! Cosine between the normals of the two faces at an edge: -1 where they are folded together.
double bend(const Mesh& mesh, int h) {
  const Vec3 a = mesh.areaVector(Mesh::faceOf(h)), b = mesh.areaVector(Mesh::faceOf(mesh.opposite(h)));
  const double size = a.norm() * b.norm();
  return size > 0 ? a.dot(b) / size : 1;
}

//! f(h) once for each edge.
template <typename F>
void forEachEdge(const Mesh& mesh, F&& f) {
  for (int h = 0; h < 3 * mesh.faceSlots(); ++h)
    if (mesh.isFace(Mesh::faceOf(h)) && h < mesh.opposite(h)) f(h);
}

}  // namespace

GuardedMesh::GuardedMesh(Mesh mesh)
    : mesh_(std::move(mesh)), sharpest_(-std::cos(kSharpest * std::numbers::pi / 180)) {
  forEachEdge(mesh_, [&](int h) { sharpest_ = std::min(sharpest_, bend(mesh_, h)); });
  Components parts = findComponents(mesh_);
  component_ = std::move(parts.ofVertex);
  for (const Measure& m : measuresOf(mesh_, component_, parts.vertices.size())) volume_.push_back(m.volume);
}

std::vector<GuardedMesh::Measure> GuardedMesh::measures() const {
  return measuresOf(mesh_, component_, volume_.size());
}

GuardedMesh::Faults GuardedMesh::faultsOf(const Mesh& mesh, const std::vector<int>& component,
                                          const std::vector<FacePair>& pairs) {
  Faults faults;
  faults.component.assign(volume_.size(), 0);
  for (const auto& [f, g] : pairs)
    for (const int face : {f, g})
      for (const int v : mesh.face(face)) faults.vertices.push_back(v);
  if (pairs.empty()) addFolds(mesh, faults);
  faults.any = !faults.vertices.empty();
  if (faults.any) return faults;  // the rest is for a mesh without intersections
  const std::vector<Measure> now = measuresOf(mesh, component, volume_.size());
  for (std::size_t c = 0; c < now.size(); ++c)
    if (!(now[c].volume / volume_[c] >= kMinVolume)) faults.component[c] = 1;
  if (volume_.size() > 1) {
    const Components parts = findComponents(mesh);
    for (const int c : misplacedComponents(labelled(mesh, parts)))
      for (std::size_t v = 0; v < component.size(); ++v)
        if (parts.ofVertex[v] == c) faults.component[component[v]] = 1;
  }
  faults.any = std::find(faults.component.begin(), faults.component.end(), 1) != faults.component.end();
  return faults;
}

void GuardedMesh::addFolds(const Mesh& mesh, Faults& faults) const {
  forEachEdge(mesh, [&](int h) {
    if (bend(mesh, h) >= sharpest_) return;
    for (const int v : {mesh.origin(h), mesh.target(h), mesh.apex(h), mesh.apex(mesh.opposite(h))})
      faults.vertices.push_back(v);
  });
}

void GuardedMesh::move(std::span<const Vec3> targets) {
  const std::vector<Vec3> before(mesh_.positions().begin(), mesh_.positions().end());
  moved_.assign(before.size(), 0);
  for (int v = 0; v < mesh_.vertexSlots(); ++v)
    if (mesh_.isVertex(v) && targets[v] != before[v]) {
      mesh_.setPosition(v, targets[v]);
      moved_[v] = 1;
    }
  for (int round = 0; round < kMaxRounds; ++round) {
    giveUpIfCancelled();
    Faults faults = faultsOf(mesh_, component_, detector_.detectMoved(mesh_, moved_));
    addThinned(before, faults);
    if (!faults.any) return;
    putBack(faults, before, round >= kRoundsAlone);
  }
  for (int v = 0; v < mesh_.vertexSlots(); ++v)
    if (moved_[v] != 0) mesh_.setPosition(v, before[v]);
}

void GuardedMesh::addThinned(std::span<const Vec3> before, Faults& faults) const {
  for (const Triangle& t : mesh_.faces()) {
    if (t[0] < 0 || (moved_[t[0]] | moved_[t[1]] | moved_[t[2]]) == 0) continue;
    const double now = leastAngle(mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]));
    if (now >= kThinnest || now >= leastAngle(before[t[0]], before[t[1]], before[t[2]])) continue;
    faults.vertices.insert(faults.vertices.end(), t.begin(), t.end());
    faults.any = true;
  }
}

void GuardedMesh::putBack(const Faults& faults, std::span<const Vec3> before, bool withRing) {
  const auto back = [&](int v) {
    mesh_.setPosition(v, before[v]);
    moved_[v] = 0;
  };
  for (const int v : faults.vertices) {
    back(v);
    if (withRing) mesh_.forEachNeighbour(v, back);
  }
  for (int v = 0; v < mesh_.vertexSlots(); ++v)
    if (moved_[v] != 0 && faults.component[component_[v]] != 0) back(v);
}

bool GuardedMesh::regulate(const RemeshLimits& limits, const std::function<bool(const Vec3&)>& mayLie) {
  std::vector<int> faces(volume_.size(), 0);
  for (const Triangle& t : mesh_.faces()) ++faces[component_[t[0]]];
  VertexStates allowed(idx(mesh_.vertexSlots()));
  for (std::size_t v = 0; v < allowed.size(); ++v)
    allowed[v] = faces[component_[v]] < kFewestFaces ? kAtRest : kActive;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    giveUpIfCancelled();
    Mesh changed = mesh_;
    VertexStates active = allowed;
    handlebody::regulate(changed, limits, active);
    if (findStructureFault(changed)) return false;
    const auto component = componentsOf(changed);
    Faults faults = faultsOf(changed, component, detector_.detectAll(changed.positions(), changed.faces()));
    for (int v = 0; v < changed.vertexSlots(); ++v)
      if (changed.isVertex(v) && !mayLie(changed.position(v))) faults.vertices.push_back(v);
    faults.any = faults.any || !faults.vertices.empty();
    if (!faults.any) {
      component_ = component;
      take(changed);
      return true;
    }
    allowed = restOf(faults, changed, kSurroundings * (attempt + 1) * limits.longest, std::move(allowed));
  }
  return false;
}

VertexStates GuardedMesh::restOf(const Faults& faults, const Mesh& changed, double reach,
                                 VertexStates allowed) const {
  NearPoints near;
  if (!faults.vertices.empty()) near.build(changed.positions(), faults.vertices, reach);
  for (int v = 0; v < mesh_.vertexSlots(); ++v)
    if (faults.component[component_[v]] != 0 ||
        (!faults.vertices.empty() && near.mayBeNear(mesh_.position(v))))
      allowed[v] = kAtRest;
  return allowed;
}

//! Per vertex of a mesh that was regulated: splits come before collapses there, so that a slot that was in
//! use before still has a vertex of the same component, or none.
std::vector<int> GuardedMesh::componentsOf(const Mesh& changed) const {
  const Components parts = findComponents(changed);
  std::vector<int> number(parts.vertices.size(), -1), component(parts.ofVertex.size(), -1);
  for (std::size_t v = 0; v < component_.size(); ++v)
    if (parts.ofVertex[v] >= 0) number[parts.ofVertex[v]] = component_[v];
  for (std::size_t v = 0; v < component.size(); ++v)
    if (parts.ofVertex[v] >= 0) component[v] = number[parts.ofVertex[v]];
  return component;
}

//! Without free slots.
void GuardedMesh::take(const Mesh& changed) {
  std::vector<int> renamed;
  mesh_ = Mesh(changed.compact(&renamed));
  std::vector<int> component(mesh_.vertexSlots());
  for (std::size_t v = 0; v < renamed.size(); ++v)
    if (renamed[v] >= 0) component[renamed[v]] = component_[v];
  component_ = std::move(component);
}

}  // namespace handlebody
