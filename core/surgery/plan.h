#pragma once
// How colliding parts of the mesh are to be opened and closed: nothing but refinement is done to the mesh
// here.

#include <optional>
#include <span>
#include <vector>

#include "core/mesh/marks.h"
#include "core/mesh/mesh.h"
#include "core/surgery/closing.h"
#include "core/surgery/event.h"
#include "core/surgery/opening.h"
#include "core/work_budget.h"

namespace handlebody {

//! A way to close the openings of a group.
struct Plan {
  std::vector<Opening> openings;
  Patch patch;
  EventKind kind = EventKind::smoothed;
  int fronts = 0;
  //! One vertex of each polygon that a handle or a band joins; all other polygons get caps.
  std::vector<int> joined;
  bool shortest = true;  //!< false: there may be a shorter handle, the search for it was cut short
  HandleSource handleFrom = HandleSource::none;
};

struct PlanSettings {
  bool outwardOnly = true;
  //! Faces that collide (per face slot): they do not stand in the way of a patch.
  FaceMarkSpan colliding;
  //! Where no patch may lie, what it may not swallow, and which vertices are pinned.
  Forbidden forbidden{};
  WorkBudget* work = nullptr;  //!< none: no bound
};

//! The most fronts that one handle joins.
inline constexpr std::size_t kMaxFronts = 4;

//! Opens the mesh around the sets Λ (at most kMaxFronts) and looks for what closes it: a handle if several
//! openings have a boundary, caps or a band if one has, nothing if none has. The mesh is refined where an
//! opening needs it, and its blocks with it. None, with the reason and the mesh as it was, if nothing fits.
std::optional<Plan> planFor(Mesh& mesh, FaceBlocks& blocks, const std::vector<std::vector<int>>& sets,
                            const PlanSettings& settings, FindingKind& reason);

}  // namespace handlebody
