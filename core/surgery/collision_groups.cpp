#include "core/surgery/collision_groups.h"

#include <algorithm>
#include <map>

#include "core/indices.h"
#include "core/mesh/union_find.h"
#include "core/surgery/opening.h"

namespace handlebody {

namespace {

std::vector<int> collidingVertices(const Mesh& mesh, std::span<const FacePair> pairs) {
  std::vector<int> vertices;
  for (const auto& [f, g] : pairs) {
    vertices.insert(vertices.end(), mesh.face(f).begin(), mesh.face(f).end());
    vertices.insert(vertices.end(), mesh.face(g).begin(), mesh.face(g).end());
  }
  sortUnique(vertices);
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
  sortUnique(ring);
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

std::vector<std::vector<int>> mostColliding(const Mesh& mesh, const CollisionGroup& group,
                                            std::size_t limit) {
  const std::size_t n = group.lambda.size();
  if (n <= limit) return group.lambda;
  const auto setOf = [&](int f) {
    std::size_t s = 0;
    while (!std::binary_search(group.lambda[s].begin(), group.lambda[s].end(), mesh.face(f)[0])) ++s;
    return s;
  };
  std::vector<int> between(n * n, 0);
  for (const auto& [f, g] : group.pairs) {
    const std::size_t a = setOf(f), b = setOf(g);
    if (a != b) ++between[a * n + b], ++between[b * n + a];
  }
  const auto best = std::max_element(between.begin(), between.end()) - between.begin();
  std::vector<std::size_t> chosen{static_cast<std::size_t>(best) / n, static_cast<std::size_t>(best) % n};
  while (chosen.size() < limit) {
    std::vector<int> with(n, 0);
    for (std::size_t s = 0; s < n; ++s)
      for (const std::size_t c : chosen)
        with[s] = c == s ? -1 : with[s] < 0 ? -1 : with[s] + between[s * n + c];
    chosen.push_back(static_cast<std::size_t>(std::max_element(with.begin(), with.end()) - with.begin()));
  }
  std::vector<std::vector<int>> out;
  for (const std::size_t c : chosen) out.push_back(group.lambda[c]);
  return out;
}

void mergeTouching(const Mesh& mesh, std::vector<std::vector<int>>& sets) {
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t j = i + 1; j < sets.size();) {
      const std::vector<int> ring = enlarge(mesh, sets[i]), other = enlarge(mesh, sets[j]);
      std::vector<int> common;
      std::set_intersection(ring.begin(), ring.end(), other.begin(), other.end(), std::back_inserter(common));
      if (common.empty()) {
        ++j;
        continue;
      }
      sets[i].insert(sets[i].end(), sets[j].begin(), sets[j].end());
      sets[i].insert(sets[i].end(), common.begin(), common.end());
      sortUnique(sets[i]);
      sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
}

}  // namespace handlebody
