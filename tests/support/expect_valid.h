#pragma once
// Every mutation test ends with these two.

#include <numeric>

#include "core/mesh/structure.h"
#include "core/mesh/validity.h"
#include "tests/support/catch.h"

namespace handlebody {

//! Closed, manifold, consistently oriented: by the mesh's own structure, and by its triangles alone.
inline void expectValid(const Mesh& mesh) {
  const auto fault = findStructureFault(mesh);
  if (fault) FAIL("the mesh is not valid: " << sentence(fault->what) << " at vertex " << fault->vertex);
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
