#pragma once
// What one iteration did: the numbers and events that the report, the timeline and the tests read.

#include <vector>

#include "core/evolution/held_changes.h"
#include "core/evolution/leak_alarm.h"
#include "core/surgery/event.h"

namespace handlebody {

struct StepReport {
  int iteration = 0;
  int movedVertices = 0;
  int unmovedVertices = 0;
  double volume = 0;       //!< mm³ enclosed
  double largestMove = 0;  //!< mm
  std::vector<Event> events;
  std::vector<Leak> leaks{};  //!< passages that it came through in this iteration; nearly always none
  //! Changes that a limit of the topology has begun to hold in it, where the limits ask; each is held until
  //! somebody lets it happen.
  std::vector<HeldPlace> questions{};
};

//! Why an evolution ended.
enum class StopReason {
  running,        //!< it has not
  converged,      //!< nothing moves any more of its own accord
  maxIterations,  //!< the limit was reached
  empty,          //!< nothing is left
  frozen,         //!< nothing moves any more, but regions that are locked for good would
  stuck,          //!< no part of a step could be kept, again and again: everything is locked
  given,          //!< the surface was there already, and nothing is to grow (StartSurface::isDone)
};
//! "converged", "max-iterations", "empty", "frozen", "stuck", "given", "running".
const char* stopReasonName(StopReason reason);

}  // namespace handlebody
