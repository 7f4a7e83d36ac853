#include "core/collision/certify.h"

#include "core/collision/self_intersection.h"
#include "core/phase.h"

namespace handlebody {

Certificate certify(const TriangleSoup& soup) {
  const Phase phase("certifying");
  Certificate c = examine(soup);
  c.selfIntersections = static_cast<int>(findSelfIntersections(soup.points, soup.triangles).size());
  return c;
}

}  // namespace handlebody
