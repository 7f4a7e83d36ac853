#include "core/io/parameter_names.h"

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

}  // namespace handlebody
