#include "core/surgery/event.h"

namespace handlebody {

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
    case EventKind::smoothed:
      return "smoothed";
    default:
      return "rolled back";
  }
}

}  // namespace handlebody
