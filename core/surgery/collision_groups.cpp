#include "core/surgery/collision_groups.h"

#include <algorithm>
#include <map>

#include "core/mesh/union_find.h"

namespace handlebody {

namespace {

std::vector<int> collidingVertices(const Mesh& mesh, std::span<const FacePair> pairs) {
  std::vector<int> vertices;
  for (const auto& [f, g] : pairs) {
    vertices.insert(vertices.end(), mesh.face(f).begin(), mesh.face(f).end());
    vertices.insert(vertices.end(), mesh.face(g).begin(), mesh.face(g).end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

//! Vertices that join through common neighbours but have no path within the set: those neighbours, so that
//! every set is connected.
std::vector<int> missingLinks(const Mesh& mesh, const std::vector<int>& vertices) {
  const auto slot = [&](int v) {
    const auto it = std::lower_bound(vertices.begin(), vertices.end(), v);
    return it != vertices.end() && *it == v ? static_cast<int>(it - vertices.begin()) : -1;
  };
  UnionFind parts(vertices.size());
  std::vector<int> ring;
  for (int v : vertices)
    mesh.forEachNeighbour(v, [&](int w) {
      if (slot(w) >= 0)
        parts.join(slot(v), slot(w));
      else
        ring.push_back(w);
    });
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  std::vector<int> links;
  for (int w : ring) {
    int first = -1;
    bool joins = false;
    mesh.forEachNeighbour(w, [&](int v) {
      if (slot(v) < 0) return;
      if (first < 0) first = slot(v);
      joins = joins || parts.find(first) != parts.find(slot(v));
      parts.join(first, slot(v));
    });
    if (joins) links.push_back(w);
  }
  return links;
}

//! The colliding vertices and what links them; a link may bring two sets within reach of each other, so again
//! until nothing is missing.
std::vector<int> connectedVertices(const Mesh& mesh, std::span<const FacePair> pairs) {
  std::vector<int> vertices = collidingVertices(mesh, pairs);
  for (std::vector<int> links = missingLinks(mesh, vertices); !links.empty();
       links = missingLinks(mesh, vertices)) {
    vertices.insert(vertices.end(), links.begin(), links.end());
    std::sort(vertices.begin(), vertices.end());
  }
  return vertices;
}

}  // namespace

std::vector<CollisionGroup> groupCollisions(const Mesh& mesh, std::span<const FacePair> pairs) {
  const std::vector<int> vertices = connectedVertices(mesh, pairs);
  UnionFind sets(static_cast<std::size_t>(mesh.vertexSlots()));
  // Joining every colliding vertex with its neighbours joins those at distance 1 and 2, and no others.
  for (int v : vertices) mesh.forEachNeighbour(v, [&](int w) { sets.join(v, w); });
  UnionFind groups(static_cast<std::size_t>(mesh.vertexSlots()));
  for (const auto& [f, g] : pairs) groups.join(sets.find(mesh.face(f)[0]), sets.find(mesh.face(g)[0]));

  std::vector<CollisionGroup> out;
  std::map<int, std::size_t> groupOf, setOf;  // by representative
  for (int v : vertices) {
    const int set = sets.find(v);
    const auto [group, newGroup] = groupOf.try_emplace(groups.find(set), out.size());
    if (newGroup) out.emplace_back();
    auto& lambda = out[group->second].lambda;
    const auto [slot, newSet] = setOf.try_emplace(set, lambda.size());
    if (newSet) lambda.emplace_back();
    lambda[slot->second].push_back(v);
  }
  for (const FacePair& p : pairs)
    out[groupOf.at(groups.find(sets.find(mesh.face(p.first)[0])))].pairs.push_back(p);
  return out;
}

}  // namespace handlebody
