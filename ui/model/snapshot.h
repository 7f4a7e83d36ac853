#pragma once
// What of a growth the views draw.

#include <memory>

#include "core/evolution/history.h"
#include "ui/model/document.h"

namespace handlebody::ui {

//! How much of a snapshot's certificate is worked out anew.
enum class Checking {
  //! All but self-intersections, of which a step leaves none: for frames on the way.
  structure,
  everything,
};

//! The iteration that `history` shows.
std::shared_ptr<const MeshSnapshot> makeSnapshot(const History& history, Checking checking);

//! One row of the timeline per recorded iteration from index `from` on.
std::vector<IterationSummary> summariesFrom(const History& history, std::size_t from);

}  // namespace handlebody::ui
