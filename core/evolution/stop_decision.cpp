#include "core/evolution/stop_decision.h"

#include <algorithm>

#include "core/evolution/converged_vertices.h"

namespace handlebody {

namespace {

//! Steps from here come to an edit that waits.
bool leadsToEdit(const StopFacts& f) {
  return f.nextEdit && f.faces > 0 && (f.iteration < f.maxIterations || *f.nextEdit == f.iteration + 1);
}

}  // namespace

void StopDecision::applyGivenAndEdit(const StopFacts& facts) {
  if (facts.isGiven) reason_ = StopReason::given;
  if (leadsToEdit(facts)) reason_ = StopReason::running;
}

void StopDecision::begin(const StopFacts& facts) {
  if (facts.maxIterations == 0) reason_ = StopReason::maxIterations;
  applyGivenAndEdit(facts);
}

void StopDecision::change(const StopFacts& facts, bool activates) {
  if (reason_ == StopReason::maxIterations || (activates && facts.faces > 0)) reason_ = StopReason::running;
  if (reason_ == StopReason::running && facts.iteration >= facts.maxIterations)
    reason_ = StopReason::maxIterations;
  applyGivenAndEdit(facts);
}

void StopDecision::afterStep(const StopFacts& facts, const StepStir& stir,
                             const std::function<StopReason()>& whyAtRest) {
  // What was at rest before an edit is so after it: nothing that it made stirs.
  if (!stir.isEdit) convergence_.count(stir.isUneventful, stir.movedVertices, facts.vertices);
  if (facts.faces == 0)
    reason_ = StopReason::empty;
  else if (leadsToEdit(facts))
    reason_ = StopReason::running;
  else if (facts.isGiven)
    reason_ = StopReason::given;
  else if (convergence_.isReached())
    reason_ = whyAtRest();
  else if (facts.iteration >= facts.maxIterations)
    reason_ = StopReason::maxIterations;
}

StopReason reasonOfRest(const Mesh& mesh, const ObjectImage& image, const MotionSettings& motion,
                        const LockedRegions& lockedRegions, int iteration) {
  std::vector<int> locked;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && lockedRegions.isLocked(mesh.position(v), iteration)) locked.push_back(v);
  const std::vector<Vec3> moves = computeMotion(mesh, image, motion, locked);
  const bool wouldMove = std::any_of(moves.begin(), moves.end(),
                                     [&](const Vec3& m) { return m.norm() >= kUnmoved * motion.edgeLength; });
  if (!wouldMove) return StopReason::converged;
  return static_cast<int>(locked.size()) == mesh.vertexCount() ? StopReason::stuck : StopReason::frozen;
}

}  // namespace handlebody
