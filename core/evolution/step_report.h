#pragma once
// What one iteration did: the numbers and events that the report, the timeline and the tests read.

#include <vector>

#include "core/surgery/event.h"

namespace handlebody {

struct StepReport {
  int iteration = 0;
  int movedVertices = 0;
  int settledVertices = 0;
  double volume = 0;       //!< mm³ enclosed
  double largestMove = 0;  //!< mm
  std::vector<Event> events;
};

//! Why an evolution ended.
enum class StopReason { running, converged, maxIterations, empty };
//! "converged", "max-iterations", "empty", "running".
const char* stopReasonName(StopReason reason);

}  // namespace handlebody
