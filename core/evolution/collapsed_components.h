#pragma once
// Components that are to go.

#include <functional>
#include <vector>

#include "core/mesh/topology.h"
#include "core/surgery/event.h"

namespace handlebody {

struct CollapseSettings {
  double smallest = 0;                      //!< mm: components of less extent go
  bool mayHaveTurned = false;               //!< also those that have turned inside out (isMisplaced)
  int iteration = 0;                        //!< for the events
  std::function<bool(const Vec3&)> isKept;  //!< asked for the first vertex of each that would go
};

//! Deletes them, one after the other.
std::vector<Event> deleteCollapsedComponents(Mesh& mesh, const Components& parts,
                                             const CollapseSettings& settings);

}  // namespace handlebody
