#include "core/evolution/restraints.h"

namespace handlebody {

void Restraints::lock(const Conflict& conflict, const Mesh& mesh, double longest, double size,
                      int iteration) {
  if (conflict.atPin)
    pins.stop(mesh, conflict.centre, conflict.radius, longest);
  else
    regions.add(conflict.centre, size * (conflict.radius + 0.5 * longest), iteration, conflict.waits);
}

void Restraints::forgetRollbacks() {
  regions = {};
  pins.forgetStops();
}

void Restraints::takeBack(const Restraints& before) {
  regions = before.regions;
  held = before.held;
  pins.takeStopsBack(before.pins);
}

}  // namespace handlebody
