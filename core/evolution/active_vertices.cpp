#include "core/evolution/active_vertices.h"

namespace handlebody {

void ActiveVertices::reorder(std::span<const int> order) {
  std::vector<unsigned char> inOrder;
  for (const int v : order) inOrder.push_back(unmovedSteps_[v]);
  unmovedSteps_ = std::move(inOrder);
}

void ActiveVertices::convergeChanged(const Mesh& before, const Mesh& mesh,
                                     std::span<const unsigned char> touched) {
  resize(mesh.vertexSlots());
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (touched[v] != 0 &&
        (v >= before.vertexSlots() || !before.isVertex(v) || before.position(v) != mesh.position(v)))
      unmovedSteps_[v] = kStepsToConverge;
}

std::vector<int> ActiveVertices::list(const Mesh& mesh, const Restraints& locked, int iteration) const {
  std::vector<int> out;
  const bool anyLocked = locked.regions.any(iteration);
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && !isConverged(v) &&
        !(anyLocked && locked.regions.isLocked(mesh.position(v), iteration)) && !locked.isHeld(mesh, v))
      out.push_back(v);
  return out;
}

}  // namespace handlebody
