#include "core/sequence/moved_object.h"

#include "core/collision/certify.h"
#include "core/sequence/carried_seeds.h"
#include "core/sequence/frame_motion.h"

namespace handlebody {

StartSurface MovedObject::given() const {
  StartSurface object;
  object.mesh = surface;
  object.inside = deepestPlace(*surface).centre;
  return object;
}

MovedObject movedObject(const Volume& from, const Volume& to, const TriangleSoup& surface) {
  auto moved = std::make_shared<const TriangleSoup>(FrameMotion(from, to, surface).moved(surface));
  const bool isCertified = certify(*moved).boundsBody();
  return {std::move(moved), isCertified};
}

}  // namespace handlebody
