#pragma once
// The iterations of a run, and what is done at a leak (docs/leaks.md) or
// where a change of topology is held.

#include "core/evolution/active_contour.h"
#include "core/io/report/report.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

//! What happens when the surface comes through a narrow passage.
enum class OnLeak {
  goOn,   //!< it is told
  pause,  //!< a person at the terminal is asked; where there is none: stop
  stop,   //!< back to the last iteration at which the passage was free, and there it ends
  wall    //!< back there, a disc is put across, and on
};

//! Adds --on-leak.
void addOnLeak(CLI::App& command, OnLeak& onLeak);

//! What happens when a limit of the topology begins to hold a change (docs/constraints.md).
enum class OnHeld {
  hold,   //!< it is held and listed
  pause,  //!< a person at the terminal is asked; where there is none: stop
  stop    //!< it ends there
};

//! Adds --on-held.
void addOnHeld(CLI::App& command, OnHeld& onHeld);

//! Has the limits of the object ask, if that is wanted and it has any. True if it asks.
bool letAsk(OnHeld onHeld, Constraints& constraints);

struct EvolveSettings {
  OnLeak onLeak = OnLeak::goOn;
  OnHeld onHeld = OnHeld::hold;
  bool traces = false;
  bool quiet = false;
};

//! Makes the steps of the report's session; sets what the report tells of them. Returns the contour in the
//! end. Throws UsageError for a veto, a pin or an edit that the growth did not come to.
ActiveContour evolve(ActiveContour contour, RunReport& report, const EvolveSettings& settings);

}  // namespace handlebody::cli
