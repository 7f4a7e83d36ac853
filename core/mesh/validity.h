#pragma once
// What a valid mesh is, in numbers: the certificate that the engine, `handlebody-cli check`, the reports and
// the window share. The structure behind it, and how a step looks at it, is in structure.h; how components
// may lie in each other in nesting.h.

#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

struct Certificate {
  int vertices = 0;  //!< that belong to a face
  int faces = 0;
  int components = 0;
  std::vector<int> genus;  //!< per component; empty unless closed, manifold and oriented
  int euler = 0;
  double volume = 0;           //!< mm³, signed, outward positive
  double area = 0;             //!< mm²
  bool closed = false;         //!< every edge has two faces
  bool manifold = false;       //!< every edge at most two faces, every vertex link one cycle (or path)
  bool oriented = false;       //!< neighbours agree, and the whole encloses a positive volume
  int cavities = -1;           //!< components of negative volume; -1: closed, manifold or oriented fails
  int misplaced = -1;          //!< components in each other's way (nesting.h); -1 as above
  int selfIntersections = -1;  //!< pairs of faces; -1: not checked

  //! Closed, manifold, oriented, free of self-intersections: what `check` asks of any mesh.
  bool passes() const { return faces > 0 && closed && manifold && oriented && selfIntersections == 0; }
  //! And its components lie in each other as those of a body do: what this program asks of its own meshes.
  bool boundsBody() const { return passes() && misplaced == 0; }
};

//! Everything but self-intersections (those need the collision library; see collision/certify.h).
Certificate examine(const TriangleSoup& soup);

//! The same, an order of magnitude faster where the mesh's structure has no fault.
Certificate examine(const Mesh& mesh);

}  // namespace handlebody
