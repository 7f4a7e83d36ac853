#include "core/evolution/collapsed_components.h"

#include "core/surgery/nesting.h"
#include "core/surgery/topology_adaptation.h"

namespace handlebody {

namespace {

Event deleteWithEvent(Mesh& mesh, int v, int iteration) {
  Event event;
  event.kind = EventKind::componentDeleted;
  event.iteration = iteration;
  event.location = mesh.position(v);
  event.before = topologyNumbers(mesh);
  deleteComponent(mesh, v);
  event.after = topologyNumbers(mesh);
  return event;
}

}  // namespace

std::vector<Event> deleteCollapsedComponents(Mesh& mesh, const Components& parts,
                                             const CollapseSettings& settings) {
  std::vector<Event> events;
  std::vector<int> first(parts.vertices.size(), -1);
  for (int v = mesh.vertexSlots() - 1; v >= 0; --v)
    if (mesh.isVertex(v)) first[static_cast<std::size_t>(parts.ofVertex[static_cast<std::size_t>(v)])] = v;
  for (std::size_t c = 0; c < first.size(); ++c) {
    const bool isTurned = settings.mayHaveTurned && isMisplaced(mesh, parts, static_cast<int>(c));
    if (parts.extent[c] >= settings.smallest && !isTurned) continue;
    if (!settings.isKept(mesh.position(first[c])))
      events.push_back(deleteWithEvent(mesh, first[c], settings.iteration));
  }
  return events;
}

}  // namespace handlebody
