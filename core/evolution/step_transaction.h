#pragma once
// The transaction of a step of the contour: what an attempt at it does to the mesh, and what comes of those
// that fail.

#include <vector>

#include "core/collision/self_intersection.h"
#include "core/evolution/active_vertices.h"
#include "core/evolution/adaptation_rounds.h"
#include "core/evolution/collapsed_components.h"
#include "core/evolution/constraints.h"
#include "core/evolution/motion.h"
#include "core/evolution/object_image.h"
#include "core/evolution/restraints.h"
#include "core/evolution/scratch.h"
#include "core/evolution/transaction.h"
#include "core/evolution/wall_guard.h"
#include "core/mesh/remesh.h"
#include "core/work_budget.h"

namespace handlebody {

//! Of surgery in one step (units of WorkBudget).
inline constexpr std::size_t kStepWork = 120'000'000;

//! What a step is made in. Only the locked regions change while it is made.
struct StepScene {
  const ObjectImage& image;
  const MotionSettings& motion;  //!< its edgeLength is the target of the mesh
  const RemeshLimits& limits;
  const WallGuard& walls;
  const ActiveVertices& active;  //!< of the mesh before the step
  Restraints& locked;
  BroadPhase broadPhase = BroadPhase::sorted;
  TopologyNumbers topology{};  //!< of the mesh before the step
  int iteration = 0;           //!< the step's
  bool mayShrink = false;      //!< parts of the surface may give ground
  bool traces = false;         //!< events are recorded with them

  //! Of edges, in parts of the target.
  double sizeAt(const Vec3& p) const { return motion.sizes ? motion.sizes->at(p) : 1; }
  //! mm, of edges anywhere.
  double longest() const { return (motion.sizes ? SizeField::kLongest : 1) * limits.longest; }
  //! mm, of edges.
  double longestAt(const Vec3& p) const { return sizeAt(p) * limits.longest; }
};

//! What is left of a step besides the mesh.
struct StepOutcome {
  Attempt last;  //!< kept, or not; its events have been taken out
  //! In order: what was rolled back, what the attempt that was kept did, and where it came again too often.
  std::vector<Event> events;
};

//! Owned by the contour. Keeps memory and tables from step to step, which a copy starts without; the
//! components that may collapse are copied. What of it is not Scratch decides.
class StepTransaction {
 public:
  //! Moves what is active, regulates, adapts the topology and deletes what has collapsed, all or nothing.
  //! Places that failed are locked before the next attempt, and if none was kept, everything is. What throws
  //! leaves the mesh as it was, bit for bit, but places may have been locked. Throws Cancelled, and
  //! UsageError (HeldChanges::judge).
  StepOutcome move(Mesh& mesh, const StepScene& scene);
  //! Makes an edit by hand in place of motion. Throws UsageError if it cannot be done, meets a wall, changes
  //! what is pinned, breaks `limits` or leaves what is not certain to be valid, and Cancelled: nothing has
  //! changed then. The attempt that it returns is kept.
  Attempt edit(Mesh& mesh, const MeshEdit& edit, const StepScene& scene, const TopologyLimits& limits);

  //! What the step that was made last started from.
  const Mesh& before() const { return transaction_.before(); }
  //! mm³ enclosed by the mesh that it left.
  double volume() const { return transaction_.volume(); }
  //! What is known of components that may collapse: forgotten after a change of what moves the surface, and
  //! taken back to an earlier copy after a step that was cancelled.
  const CollapsedComponents& collapsed() const { return collapsed_; }
  void forgetCollapsed() { collapsed_.forget(); }
  void takeBack(const CollapsedComponents& before) { collapsed_ = before; }

 private:
  Attempt attempt(Mesh& mesh, const StepScene& scene, bool isFirst);
  static void touchStretched(const Mesh& mesh, const StepScene& scene, Attempt& a);
  void displace(Mesh& mesh, const StepScene& scene, Attempt& a) const;
  void adapt(Mesh& mesh, const StepScene& scene, Attempt& a);
  void deleteCollapsed(Mesh& mesh, const StepScene& scene, Attempt& a);
  void findFaults(const Mesh& mesh, const StepScene& scene, Attempt& a) const;
  std::vector<HeldChange> judge(const Mesh& mesh, const StepScene& scene, const Attempt& a,
                                std::vector<Event>& events) const;
  Attempt attemptEdit(Mesh& mesh, const MeshEdit& edit, const StepScene& scene,
                      const TopologyLimits& limits) const;

  Scratch<Transaction> transaction_;
  Scratch<CollisionDetector> detector_;
  Scratch<AdaptationRounds> rounds_;
  CollapsedComponents collapsed_;
  WorkBudget work_{kStepWork};  // of the step that is being made
};

}  // namespace handlebody
