#include "core/solid/solid.h"

#include <algorithm>

#include "core/phase.h"
#include "core/solid/mask_surface.h"

namespace handlebody {

double Solid::volume() const {
  if (mask) return static_cast<double>(mask->count()) * mask->grid.voxelVolume();
  return certificate.volume;
}

Solid solidOf(TriangleSoup mesh) {
  const Phase phase("topology");
  Solid solid{std::move(mesh)};
  solid.certificate = examine(solid.surface);
  if (!(solid.certificate.closed && solid.certificate.volume < 0)) return solid;
  TriangleSoup turned = solid.surface;
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  const Certificate certificate = examine(turned);
  if (!certificate.oriented) return solid;  // not only inside out
  solid.surface = std::move(turned);
  solid.certificate = certificate;
  solid.wasInsideOut = true;
  return solid;
}

Solid solidOf(Mask mask) {
  const Phase phase("topology");
  Solid solid{maskSurface(mask)};
  if (!solid.empty()) solid.certificate = examine(Mesh(solid.surface));
  solid.mask = std::move(mask);
  return solid;
}

}  // namespace handlebody
