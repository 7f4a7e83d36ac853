#include "core/evolution/converged_vertices.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

namespace {

constexpr double kActivating =
    0.1;  // edge lengths: a vertex that moves more than this makes its neighbours active

}  // namespace

void countUnmoved(const Mesh& mesh, const StepMotion& a, double edgeLength,
                  std::vector<unsigned char>& unmovedSteps) {
  const std::size_t known = unmovedSteps.size();
  unmovedSteps.resize(mesh.vertexSlots(), 0);
  // Vertices that surgery made, moved or gave new faces are active.
  std::vector<unsigned char> wasMoved(unmovedSteps.size(), 0);
  for (int v : a.moving) wasMoved[v] = 1;
  for (std::size_t v = 0; v < unmovedSteps.size(); ++v)
    if (v >= known || (a.touched[v] != 0 && wasMoved[v] == 0)) unmovedSteps[v] = 0;
  for (std::size_t i = 0; i < a.moving.size(); ++i) {
    unsigned char& q = unmovedSteps[a.moving[i]];
    if (idx(a.moving[i]) >= known || !mesh.isVertex(a.moving[i])) continue;
    q = a.distances[i] < kUnmoved * edgeLength ? static_cast<unsigned char>(std::min(q + 1, kStepsToConverge))
                                               : static_cast<unsigned char>(0);
  }
  // Those that move far make their neighbours active. Face by face, in the order of memory: far quicker than
  // a walk from neighbour to neighbour.
  std::fill(wasMoved.begin(), wasMoved.end(), static_cast<unsigned char>(0));
  for (std::size_t i = 0; i < a.moving.size(); ++i)
    wasMoved[a.moving[i]] = a.distances[i] > kActivating * edgeLength;
  for (const Triangle& t : mesh.faces())
    if (t[0] >= 0 && (wasMoved[t[0]] | wasMoved[t[1]] | wasMoved[t[2]]) != 0)
      for (const int v : t) unmovedSteps[v] = 0;
}

}  // namespace handlebody
