#include "core/io/report/parameter_names.h"

namespace handlebody {

const char* objectKindName(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::dark:
      return "dark";
    case ObjectKind::bright:
      return "bright";
    default:
      return "auto";
  }
}

std::optional<ObjectKind> objectKindFromName(std::string_view name) {
  for (ObjectKind kind : {ObjectKind::automatic, ObjectKind::dark, ObjectKind::bright})
    if (name == objectKindName(kind)) return kind;
  return std::nullopt;
}

const char* directionName(Direction direction) {
  return direction == Direction::outward ? "outward" : "both";
}

std::optional<Direction> directionFromName(std::string_view name) {
  for (Direction direction : {Direction::outward, Direction::both})
    if (name == directionName(direction)) return direction;
  return std::nullopt;
}

const char* resolutionName(Resolution resolution) {
  switch (resolution) {
    case Resolution::automatic:
      return "auto";
    case Resolution::uniform:
      return "uniform";
    case Resolution::adaptive:
      break;
  }
  return "adaptive";
}

std::optional<Resolution> resolutionFromName(std::string_view name) {
  for (Resolution resolution : {Resolution::automatic, Resolution::uniform, Resolution::adaptive})
    if (name == resolutionName(resolution)) return resolution;
  return std::nullopt;
}

const char* broadPhaseName(BroadPhase phase) { return phase == BroadPhase::sorted ? "sorted" : "hashing"; }

std::optional<BroadPhase> broadPhaseFromName(std::string_view name) {
  for (BroadPhase phase : {BroadPhase::sorted, BroadPhase::hashing})
    if (name == broadPhaseName(phase)) return phase;
  return std::nullopt;
}

}  // namespace handlebody
