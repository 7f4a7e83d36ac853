#pragma once
// Growth over time in JSON. Only sources include this header, as json.h.

#include "core/io/report/json.h"
#include "core/io/report/over_time_report.h"

namespace handlebody {

//! "over_time" of a session: "frames" ([first, last] or "all"), "topology" ("held" or "free"), "drift_check"
//! ("none", "back" or "wrap") and, where it was given, "given_frame_time_ms".
Json overTimeToJson(const OverTimeRequest& request);
//! The inverse. Throws UsageError.
OverTimeRequest overTimeFromJson(const JsonField& json);
//! "over_time" of a report: the same with "time_ms" and where that comes from, "results" per frame, "curve"
//! (volumes in ml) and "drift" (docs/time.md).
Json overTimeToJson(const OverTimeReport& report);

//! "none", "back" or "wrap".
const char* driftCheckName(DriftCheck check);
//! Nothing for another word.
std::optional<DriftCheck> driftCheckFromName(std::string_view name);

}  // namespace handlebody
