#pragma once
// What of a growth the views draw.

#include <memory>

#include "core/evolution/history.h"
#include "ui/model/document.h"

namespace handlebody::ui {

//! The iteration that `history` shows, certified in full.
std::shared_ptr<const MeshSnapshot> makeSnapshot(const History& history);

//! One row of the timeline per recorded iteration from index `from` on.
std::vector<IterationSummary> summariesFrom(const History& history, std::size_t from);

}  // namespace handlebody::ui
