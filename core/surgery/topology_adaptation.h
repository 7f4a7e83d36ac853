#pragma once
// Topology adaptation (paper, section 4): the colliding parts of the mesh are opened, and closed again by a
// handle, by caps, or by a smoother patch.

#include <functional>
#include <span>
#include <vector>

#include "core/collision/self_intersection.h"
#include "core/mesh/forbidden.h"
#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"
#include "core/surgery/event.h"
#include "core/work_budget.h"

namespace handlebody {

struct AdaptationSettings {
  //! Only changes that fill outside space: fronts that meet through the inside of the object are left alone.
  bool outwardOnly = true;
  bool recordTraces = false;
  int iteration = 0;         //!< for the events
  TopologyNumbers topology;  //!< of the mesh as it is handed over
  //! True where folds have been smoothed before and came back: there a cut is tried first. None: nowhere.
  std::function<bool(const Vec3&)> cameBack{};
  //! Where no patch may lie, what it may not swallow, and which vertices are pinned.
  Forbidden forbidden{};
  //! Of the step: places for which nothing is left wait. None: no bound.
  WorkBudget* work = nullptr;
};

//! A place where nothing fitted: the caller rolls it back.
struct Conflict {
  Vec3 centre{0, 0, 0};  //!< mm
  double radius = 0;     //!< mm; holds all colliding vertices and the patches that were tried
  Finding reason{};
  bool waits = false;             //!< nothing is wrong there: others have spent the work of the step
  bool atPin = false;             //!< nothing is wrong there: a front has met pinned vertices
  std::vector<Triangle> faces{};  //!< that collide
};

struct AdaptationResult {
  std::vector<Event> events;
  std::vector<Conflict> conflicts;
};

//! Handles every group of colliding faces once. `touched` grows with the mesh; touched[v] = 1 for the
//! vertices of every face that is new or was moved. Places listed as conflicts are unchanged but for
//! refinement, and still collide.
AdaptationResult adaptTopology(Mesh& mesh, std::span<const FacePair> pairs,
                               const AdaptationSettings& settings, VertexMarks& touched);

}  // namespace handlebody
