#pragma once
// Every mutation test ends with these two.

#include <numeric>

#include "core/mesh/certificate.h"
#include "tests/support/catch.h"

namespace handlebody {

//! Closed, manifold, consistently oriented; the corner table agrees with itself.
inline void expectValid(const Mesh& mesh) {
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int g = mesh.opposite(h);
      REQUIRE(g >= 0);
      REQUIRE(mesh.opposite(g) == h);
      REQUIRE(mesh.origin(g) == mesh.target(h));
      REQUIRE(mesh.target(g) == mesh.origin(h));
    }
  }
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) REQUIRE(mesh.origin(mesh.outgoing(v)) == v);
  const Certificate c = examine(mesh.compact());
  CHECK(c.closed);
  CHECK(c.manifold);
  CHECK(c.vertices == mesh.vertexCount());
  CHECK(c.faces == mesh.faceCount());
}

inline void expectTopology(const Mesh& mesh, int components, int genus) {
  const Certificate c = examine(mesh.compact());
  CHECK(c.components == components);
  CHECK(std::accumulate(c.genus.begin(), c.genus.end(), 0) == genus);
  CHECK(c.euler == 2 * components - 2 * genus);
}

}  // namespace handlebody
