#pragma once
// The certificate of a mesh: what is checked after every step, on every export and by `handlebody-cli check`.

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
  int selfIntersections = -1;  //!< pairs of faces; -1: not checked

  bool passes() const { return faces > 0 && closed && manifold && oriented && selfIntersections == 0; }
};

//! Everything but self-intersections (those need the collision library; see collision/certify.h).
Certificate examine(const TriangleSoup& soup);

}  // namespace handlebody
