#include "core/evolution/locked_regions.h"

namespace handlebody {

void LockedRegions::lock(const Conflict& trouble, const Mesh& mesh, double longest, double size,
                         int iteration) {
  if (trouble.atPin)
    pins.stop(mesh, trouble.centre, trouble.radius, longest);
  else
    lockedRegions.add(trouble.centre, size * (trouble.radius + 0.5 * longest), iteration, trouble.waits);
}

void LockedRegions::forgetRollbacks() {
  lockedRegions = {};
  pins.forgetStops();
}

void LockedRegions::takeBack(const LockedRegions& before) {
  lockedRegions = before.lockedRegions;
  held = before.held;
  pins.takeStopsBack(before.pins);
}

}  // namespace handlebody
