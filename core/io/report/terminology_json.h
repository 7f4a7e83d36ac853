#pragma once
// What a segment's file says of it besides, in sessions, reports and `info`.

#include "core/io/report/json.h"

namespace handlebody {

//! {"category", "type", "region"}, each {"value", "scheme", "meaning"}, type and region with "modifiers"
//! where there are some, the region only where there is one.
Json terminologyToJson(const Terminology& terminology);

//! Adds "terminology" and "algorithm" ({"type", "name"}), each where it is said.
void addSource(Json& object, const SegmentSource& source);
//! The inverse. Throws UsageError, also for a code or name that could not be written.
SegmentSource sourceFromJson(const JsonField& object);

}  // namespace handlebody
