#include "core/evolution/adaptation_rounds.h"

#include <iterator>

#include "core/cancellation.h"
#include "core/evolution/unseen_change.h"
#include "core/indices.h"

namespace handlebody {

namespace {

constexpr int kRounds = 5;

VertexMarks verticesOf(const Mesh& mesh, const std::vector<FacePair>& pairs) {
  VertexMarks marked(idx(mesh.vertexSlots()), 0);
  for (const auto& [f, g] : pairs)
    for (int face : {f, g})
      for (int v : mesh.face(face)) marked[v] = 1;
  return marked;
}

}  // namespace

void AdaptationRounds::run(Mesh& mesh, CollisionDetector& detector, AdaptationSettings settings,
                           double longest, Attempt& a) {
  VertexMarks changed = a.touched;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<FacePair>& pairs = detector.detectMoved(mesh, changed);
    if (pairs.empty()) return;
    giveUpIfCancelled();
    seen_ = mesh;
    changed = verticesOf(mesh, pairs);
    AdaptationResult result = surgery_(mesh, pairs, settings, changed);
    if (!result.events.empty()) settings.topology = result.events.back().after;
    a.events.insert(a.events.end(), std::make_move_iterator(result.events.begin()),
                    std::make_move_iterator(result.events.end()));
    a.touched.resize(mesh.vertexSlots(), 0);
    changed.resize(mesh.vertexSlots(), 0);
    for (std::size_t v = 0; v < changed.size(); ++v) a.touched[v] = a.touched[v] | changed[v];
    if (!result.conflicts.empty()) {
      a.conflicts = std::move(result.conflicts);
      return;
    }
    if (const auto v = unseenChange(seen_, mesh, changed)) {
      a.conflicts.push_back({mesh.position(*v), 2 * longest, FindingKind::unseenChange});
      return;
    }
  }
  for (const auto& [f, g] : detector.detectMoved(mesh, changed)) {
    const Vec3& centre = mesh.position(mesh.face(f)[0]);
    a.conflicts.push_back({centre, 2 * longest, FindingKind::stillIntersects});
  }
}

}  // namespace handlebody
