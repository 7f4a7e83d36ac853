#include "core/collision/face_pair.h"

#include <algorithm>

#include "core/geometry/triangle_intersection.h"

namespace handlebody {
namespace {

//! Brings the vertices of a that b has too to the front, each once; returns their number. The rest follows (a
//! repeated vertex that is shared counts as rest when it comes again).
int sharedFirst(const Triangle& a, const Triangle& b, Triangle& ordered) {
  int shared = 0;
  int rest = 2;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto sharedEnd = ordered.begin() + shared;
    const bool isShared = std::find(b.begin(), b.end(), a[i]) != b.end();
    const bool isNew = std::find(ordered.begin(), sharedEnd, a[i]) == sharedEnd;
    ordered[isShared && isNew ? shared++ : rest--] = a[i];
  }
  return shared;
}

}  // namespace

bool facesIntersect(std::span<const Vec3> points, const Triangle& a, const Triangle& b) {
  Triangle p{};
  Triangle q{};
  const int shared = sharedFirst(a, b, p);
  sharedFirst(b, a, q);
  const auto at = [&](int v) -> const Vec3& { return points[v]; };
  switch (shared) {
    case 0:
      return trianglesIntersect(at(p[0]), at(p[1]), at(p[2]), at(q[0]), at(q[1]), at(q[2]));
    case 1:
      return trianglesIntersectSharedVertex(at(p[0]), at(p[1]), at(p[2]), at(q[1]), at(q[2]));
    case 2:
      return trianglesIntersectSharedEdge(at(p[0]), at(p[1]), at(p[2]), at(q[2]));
    default:
      return true;
  }
}

}  // namespace handlebody
