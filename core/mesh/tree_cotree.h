#pragma once
// Loops that generate the first homology of a closed connected surface (tree-cotree decomposition; D.
// Eppstein, "Dynamic generators of topologically embedded graphs", 2003).

#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! A spanning tree of the edges, one of the dual edges that crosses none of those, and the 2g edges in
//! neither.
//!
//! Generator k gives two loops: the primal loop along its edge and back through the tree, and the dual loop
//! across its edge and back through the cotree. Primal loop j meets dual loop k once if j = k, else nowhere.
struct TreeCotree {
  std::vector<int> vertexParent;  //!< per vertex: the half-edge that arrives at it; -1 at the root
  std::vector<int> vertexDepth;
  std::vector<int> faceParent;  //!< per face: its half-edge across which its parent lies; -1 at the root
  std::vector<int> faceDepth;
  std::vector<int> generators;  //!< a half-edge of each of the 2g edges
};

//! Precondition: closed, connected, without free slots.
TreeCotree treeCotree(const Mesh& mesh);

//! The half-edges of the primal loop k, in order, its generator among them.
std::vector<int> primalLoop(const Mesh& mesh, const TreeCotree& trees, int k);

//! The half-edges that the dual loop k crosses, in order, each from its own face to that of its opposite; the
//! generator is the first.
std::vector<int> dualLoop(const Mesh& mesh, const TreeCotree& trees, int k);

}  // namespace handlebody
