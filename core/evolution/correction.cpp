#include "core/evolution/correction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/evolution/normal_profile.h"
#include "core/evolution/seeds.h"
#include "core/evolution/shown_object.h"
#include "core/mesh/containment.h"
#include "core/mesh/nesting.h"
#include "core/mesh/shapes.h"
#include "core/mesh/topology.h"

namespace handlebody {

namespace {

constexpr int kAround = 3;      // edges from a vertex that disagrees to those that become active with it
constexpr int kMaxPlaces = 64;  // of the surface's inside from which a front may come

std::vector<Vec3> placesOf(const ObjectImage& image, const std::vector<Seed>& clicks, double edgeLength) {
  std::vector<Vec3> places;
  for (const Seed& click : clicks)
    if (!click.background) places.push_back(roomiestNear(image, click.centre, edgeLength));
  return places;
}

int anyVertexOf(const Components& parts, int component) {
  const auto at = std::find(parts.ofVertex.begin(), parts.ofVertex.end(), component);
  return static_cast<int>(at - parts.ofVertex.begin());
}

//! Per component: it, or one within it, has a pinned vertex.
std::vector<bool> keptByPins(const Mesh& mesh, const Components& parts,
                             const std::function<bool(int)>& isPinned) {
  std::vector<bool> kept(parts.count(), false);
  if (!isPinned) return kept;
  const std::vector<int> surrounding = surroundingComponents(mesh, parts);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && isPinned(v))
      for (int c = parts.ofVertex[v]; c >= 0 && !kept[c]; c = surrounding[c]) kept[c] = true;
  return kept;
}

//! Solid components that enclose nothing of the object, and then their cavities, which lie nowhere.
int deleteForeign(Mesh& mesh, const Components& parts, const std::vector<Enclosed>& enclosed,
                  const std::vector<bool>& kept) {
  std::vector<int> foreign;
  for (int c = 0; c < parts.count(); ++c)
    if (parts.volume[c] >= 0 && enclosed[c].common == 0 && !kept[c]) foreign.push_back(anyVertexOf(parts, c));
  if (foreign.empty()) return 0;
  for (const int v : foreign) deleteComponent(mesh, v);
  const Components left = findComponents(mesh);
  std::vector<int> orphans;
  for (int c = 0; c < left.count(); ++c)
    if (left.volume[c] < 0 && isMisplaced(mesh, left, c)) orphans.push_back(anyVertexOf(left, c));
  for (const int v : orphans) deleteComponent(mesh, v);
  return static_cast<int>(foreign.size() + orphans.size());
}

double distanceToVertices(const Mesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) least = std::min(least, (mesh.position(v) - p).squaredNorm());
  return std::sqrt(least);
}

void addSphere(Mesh& mesh, const Seed& ball, double edgeLength) {
  TriangleSoup sphere = seedSphere(ball, edgeLength);
  std::vector<int> slots;
  for (const Vec3& p : sphere.points) slots.push_back(mesh.addVertex(p));
  for (Triangle& t : sphere.triangles)
    for (int& v : t) v = slots[v];
  mesh.addFaces(sphere.triangles);
}

//! Places within the surface from which its fronts come: the clicks there, else some of what it has in
//! common with the object.
std::vector<Vec3> startsOf(const Mesh& mesh, const std::vector<Vec3>& clicks,
                           const std::vector<Enclosed>& enclosed) {
  std::vector<Vec3> starts;
  const Components parts = findComponents(mesh);
  for (const Vec3& p : clicks)
    if (encloses(mesh, parts, p)) starts.push_back(p);
  if (!starts.empty()) return starts;
  for (const Enclosed& e : enclosed) {
    const std::size_t every = e.samples.size() / kMaxPlaces + 1;
    for (std::size_t i = 0; i < e.samples.size(); i += every) starts.push_back(e.samples[i]);
  }
  return starts;
}

//! A ball around every click that the surface neither encloses nor comes to, where there is room for one.
std::vector<Seed> addFronts(Mesh& mesh, const ObjectImage& image, const std::vector<Seed>& clicks,
                            std::vector<Vec3> starts, double edgeLength, double longest) {
  std::vector<Seed> added;
  for (const Seed& click : clicks) {
    if (click.background) continue;
    const Vec3 place = roomiestNear(image, click.centre, edgeLength);
    if (encloses(mesh, findComponents(mesh), place)) continue;
    if (!click.radius && comesAnyway(image, starts, place, edgeLength)) continue;
    // No point of a face is further from its nearest corner than this.
    const double reach = longest / std::sqrt(3.0);
    const auto room = [&](const Vec3& p) { return distanceToVertices(mesh, p) - reach - edgeLength; };
    const std::optional<Seed> ball = fitBall(image, {place, click.radius}, edgeLength, room);
    if (!ball) continue;
    addSphere(mesh, *ball, edgeLength);
    added.push_back(*ball);
    starts.push_back(ball->centre);
  }
  return added;
}

//! What the surface encloses: points in cavities do not count.
double commonPart(const Components& parts, const std::vector<Enclosed>& enclosed) {
  double all = 0, common = 0;
  for (int c = 0; c < parts.count(); ++c) {
    const double sign = parts.volume[c] < 0 ? -1 : 1;
    all += sign * enclosed[c].all;
    common += sign * enclosed[c].common;
  }
  return all > 0 ? std::clamp(common / all, 0.0, 1.0) : 0;
}

}  // namespace

Correction correctComponents(Mesh& mesh, const ObjectImage& image, const std::vector<Seed>& clicks,
                             double edgeLength, double longest, std::vector<Seed>& fronts,
                             const std::function<bool(int)>& isPinned) {
  Correction out;
  const std::vector<Vec3> places = placesOf(image, clicks, edgeLength);
  const ShownObject object(image, places, edgeLength);
  const Components parts = findComponents(mesh);
  const std::vector<Enclosed> enclosed = enclosedBy(mesh, parts, object);
  out.common = commonPart(parts, enclosed);
  out.beganAnew = out.common < kHardlyInCommon;
  if (out.beganAnew) return out;
  out.deleted = deleteForeign(mesh, parts, enclosed, keptByPins(mesh, parts, isPinned));
  fronts = addFronts(mesh, image, clicks, startsOf(mesh, places, enclosed), edgeLength, longest);
  out.fronts = static_cast<int>(fronts.size());
  return out;
}

Disagreement findDisagreement(const Mesh& mesh, const ObjectImage& image, double tolerance) {
  Disagreement out;
  out.vertices.assign(mesh.vertexSlots(), 0);
  std::vector<int> rim;
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    if (!mesh.isVertex(v)) continue;
    const Vec3 off = tolerance * examineRing(mesh, v).normal;
    const bool isOutside = image.inside(mesh.position(v) - off) < 0;
    out.isOutside = out.isOutside || isOutside;
    if (!isOutside && image.inside(mesh.position(v) + off) <= 0) continue;
    out.vertices[v] = 1;
    rim.push_back(v);
  }
  for (int ring = 0; ring < kAround; ++ring) {
    std::vector<int> next;
    for (const int v : rim)
      mesh.forEachNeighbour(v, [&](int w) {
        if (out.vertices[w]) return;
        out.vertices[w] = 1;
        next.push_back(w);
      });
    rim = std::move(next);
  }
  return out;
}

}  // namespace handlebody
