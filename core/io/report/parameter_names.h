#pragma once
// The words for the enumerations of Parameters: the same in options, reports and sessions.

#include <optional>
#include <string_view>

#include "core/evolution/parameters.h"

namespace handlebody {

//! "auto", "dark", "bright".
const char* objectKindName(ObjectKind kind);
//! None for any other word.
std::optional<ObjectKind> objectKindFromName(std::string_view name);

//! "outward", "both".
const char* directionName(Direction direction);
//! None for any other word.
std::optional<Direction> directionFromName(std::string_view name);

//! "auto", "uniform", "adaptive".
const char* resolutionName(Resolution resolution);
//! None for any other word.
std::optional<Resolution> resolutionFromName(std::string_view name);

//! "sorted", "hashing".
const char* broadPhaseName(BroadPhase phase);
//! None for any other word.
std::optional<BroadPhase> broadPhaseFromName(std::string_view name);

}  // namespace handlebody
