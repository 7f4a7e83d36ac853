#include "core/surgery/event.h"

#include <algorithm>

namespace handlebody {

bool changesTopology(EventKind kind) {
  return kind != EventKind::smoothed && kind != EventKind::rolledBack && kind != EventKind::surfaceSmoothed &&
         kind != EventKind::surfacePulled;
}

bool hasSurgery(std::span<const Event> events) {
  return !std::all_of(events.begin(), events.end(), [](const Event& e) {
    return e.kind == EventKind::smoothed && e.loopSizes.empty() && e.before == e.after;
  });
}

const char* eventKindName(EventKind kind) {
  switch (kind) {
    case EventKind::handleInserted:
      return "handle inserted";
    case EventKind::split:
      return "split";
    case EventKind::enclosedPartCutOff:
      return "enclosed part cut off";
    case EventKind::tunnelClosed:
      return "tunnel closed";
    case EventKind::componentDeleted:
      return "component deleted";
    case EventKind::handleCut:
      return "handle cut";
    case EventKind::componentRemoved:
      return "component removed";
    case EventKind::cavityFilled:
      return "cavity filled";
    case EventKind::planeCut:
      return "cut by a plane";
    case EventKind::surfaceSmoothed:
      return "smoothed by hand";
    case EventKind::surfacePulled:
      return "pulled";
    case EventKind::smoothed:
      return "smoothed";
    default:
      return "rolled back";
  }
}

}  // namespace handlebody
