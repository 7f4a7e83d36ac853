#pragma once
// Which events of a growth are changes of topology, and which only keep the mesh valid.

#include "core/surgery/event.h"

namespace handlebody::ui {

//! False for repairs: a fold that was smoothed away, a part that was rolled back.
inline bool changesTopology(EventKind kind) {
  return kind != EventKind::smoothed && kind != EventKind::rolledBack;
}

}  // namespace handlebody::ui
