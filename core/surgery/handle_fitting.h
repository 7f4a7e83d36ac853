#pragma once
// The choice of a handle for boundary polygons of an opened mesh (paper, section 4, "Inserting handles from
// the database").

#include <optional>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/surgery/closing.h"
#include "core/surgery/opening.h"
#include "core/work_budget.h"

namespace handlebody {

//! Handles that join two to four polygons, shortest first, at most `limit`; none has an edge that the opened
//! mesh has already.
std::vector<Patch> handlesBetween(const Mesh& mesh, std::span<const Opening> openings,
                                  std::span<const std::vector<int>> loops, std::size_t limit);

struct FittingHandle {
  Patch patch;  //!< handle and caps
  bool found = false;
  bool shortest = true;   //!< false: the search was cut short, and there may be a shorter one
  bool isListed = false;  //!< chosen from the handle database, without a search
  int tried = 0;          //!< handles that did not fit before this one
};

//! The shortest of all handles for the polygons that intersects neither itself, nor the caps, nor what stays
//! of the mesh, together with the caps. A face that intersects the mesh or a cap is in no handle that fits:
//! the choice goes on among those without it, so that next best handles with the same fault are not tried one
//! by one. The handle database is asked first, each time, and the search where it tells none: both choose the
//! same. Exact up to kFitTries handles, or until the work is spent; then none.
FittingHandle shortestFittingHandle(const Mesh& mesh, std::span<const Opening> openings,
                                    std::span<const std::vector<int>> loops, const Patch& caps,
                                    const Surroundings& surroundings, WorkBudget* work = nullptr);

inline constexpr int kFitTries = 60;

}  // namespace handlebody
