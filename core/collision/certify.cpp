#include "core/collision/certify.h"

#include "core/collision/self_intersection.h"

namespace handlebody {

Certificate certify(const TriangleSoup& soup) {
  Certificate c = examine(soup);
  c.selfIntersections = static_cast<int>(findSelfIntersections(soup.points, soup.triangles).size());
  return c;
}

}  // namespace handlebody
