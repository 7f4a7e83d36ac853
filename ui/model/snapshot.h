#pragma once
// What of a growth the views draw.

#include <memory>

#include "core/evolution/history.h"
#include "ui/model/document.h"

namespace handlebody::ui {

//! How a snapshot's certificate is worked out: self-intersections are looked for either way.
enum class Checking {
  //! Its numbers from the mesh's structure: for frames on the way.
  structure,
  everything,
};

//! The iteration that `history` shows.
std::shared_ptr<const MeshSnapshot> makeSnapshot(const History& history, Checking checking);

//! One row of the timeline per recorded iteration from index `from` on.
std::vector<IterationSummary> summariesFrom(const History& history, std::size_t from);

}  // namespace handlebody::ui
