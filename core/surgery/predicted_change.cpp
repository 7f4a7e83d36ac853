#include "core/surgery/predicted_change.h"

#include <algorithm>

namespace handlebody {

namespace {

TopologyNumbers numbers(int components, int euler) {
  return {components, euler, (2 * components - euler) / 2};
}

//! Taking discs out of a closed surface leaves as many components as it had.
bool takesDiscs(const Opening& o) { return o.loops.size() == 1 && eulerNumberOf(o) == 1; }

}  // namespace

int eulerNumberOf(const Opening& opening) {
  int boundary = 0;
  for (const auto& loop : opening.loops) boundary += static_cast<int>(loop.size());
  const int faces = static_cast<int>(opening.faces.size());
  const int innerEdges = (3 * faces - boundary) / 2;  // two faces have each, one each edge of the boundary
  return static_cast<int>(opening.lambda.size()) - innerEdges + faces;
}

int eulerChange(const Plan& plan) {
  const int joined = static_cast<int>(plan.joined.size());
  int change = joined > 0 ? 2 - joined : 0;
  for (const Opening& o : plan.openings) change += static_cast<int>(o.loops.size()) - eulerNumberOf(o);
  return change - joined;  // of the polygons, these have no cap
}

TopologyNumbers predictChange(const TopologyNumbers& before, const Mesh& opened, const Plan& plan) {
  const bool onlyDiscs = std::all_of(plan.openings.begin(), plan.openings.end(), takesDiscs);
  const bool joinsNothing = plan.joined.empty() || before.components == 1;
  return numbers(onlyDiscs && joinsNothing ? before.components : countComponents(opened, plan.joined),
                 before.euler + eulerChange(plan));
}

TopologyNumbers predictDeletion(const TopologyNumbers& before, const Components& parts, int component) {
  const auto c = static_cast<std::size_t>(component);
  return numbers(before.components - 1, before.euler - (parts.vertices[c] - parts.faces[c] / 2));
}

}  // namespace handlebody
