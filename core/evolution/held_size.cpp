#include "core/evolution/held_size.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "core/mesh/topology.h"

namespace handlebody {

namespace {

// Longest edges about the place within which its fronts are looked for: the nearest that shows two.
constexpr double kAround[] = {0.75, 1.0, 1.5, 2.0};
constexpr double kFar = 1e300;

std::vector<int> verticesWithin(const Mesh& mesh, const Vec3& place, double radius) {
  std::vector<int> out;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && (mesh.position(v) - place).norm() < radius) out.push_back(v);
  return out;
}

//! Those that hang together with the one nearest to the place, and the others: two fronts.
std::pair<std::vector<int>, std::vector<int>> frontsAt(const Mesh& mesh, const Vec3& place, double radius) {
  const std::vector<int> near = verticesWithin(mesh, place, radius);
  if (near.empty()) return {};
  const auto distance = [&](int v) { return (mesh.position(v) - place).squaredNorm(); };
  const int first =
      *std::min_element(near.begin(), near.end(), [&](int a, int b) { return distance(a) < distance(b); });
  std::vector<bool> isNear(mesh.vertexSlots()), isReached(isNear.size());
  for (const int v : near) isNear[v] = true;
  std::vector<int> one{first};
  isReached[first] = true;
  for (std::size_t i = 0; i < one.size(); ++i)
    mesh.forEachNeighbour(one[i], [&](int w) {
      if (!isNear[w] || isReached[w]) return;
      isReached[w] = true;
      one.push_back(w);
    });
  std::vector<int> other;
  for (const int v : near)
    if (!isReached[v]) other.push_back(v);
  return {one, other};
}

//! Along edges from the vertices of one front to the nearest of the other, and straight back; 0: there is no
//! way.
double loopThrough(const Mesh& mesh, const std::vector<int>& one, const std::vector<int>& other) {
  std::vector<double> length(mesh.vertexSlots(), kFar);
  std::vector<bool> isGoal(length.size());
  for (const int v : other) isGoal[v] = true;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.emplace(0, one.front());
  length[one.front()] = 0;
  while (!queue.empty()) {
    const auto [way, v] = queue.top();
    queue.pop();
    if (way > length[v]) continue;
    if (isGoal[v]) return way + (mesh.position(v) - mesh.position(one.front())).norm();
    mesh.forEachNeighbour(v, [&](int w) {
      const double longer = way + (mesh.position(w) - mesh.position(v)).norm();
      if (longer >= length[w]) return;
      length[w] = longer;
      queue.emplace(longer, w);
    });
  }
  return 0;
}

double tunnelAt(const Mesh& mesh, const Vec3& place, double longest) {
  for (const double around : kAround) {
    const auto [one, other] = frontsAt(mesh, place, around * longest);
    if (other.empty()) continue;
    if (const double loop = loopThrough(mesh, one, other); loop > 0) return loop;
  }
  return 0;
}

//! Of the components at the place the one that encloses least.
HeldSize partAt(const Mesh& mesh, const Vec3& place, double longest) {
  const Components parts = findComponents(mesh);
  HeldSize size;
  for (const int v : verticesWithin(mesh, place, kAround[3] * longest)) {
    const double volume = parts.volume[parts.ofVertex[v]];
    if (size.part > 0 && std::abs(volume) >= size.part) continue;
    size.part = std::abs(volume);
    size.isCavity = volume < 0;
  }
  return size;
}

}  // namespace

HeldSize heldSize(const Event& event, const Mesh& before, const Mesh& after, double longest) {
  if (event.after.components > event.before.components) return partAt(after, event.location, longest);
  if (event.after.genus > event.before.genus) return {tunnelAt(before, event.location, longest), 0, false};
  return {};
}

}  // namespace handlebody
