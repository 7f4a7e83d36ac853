#pragma once
// Internal: how the surface of a mask runs through a cell of eight voxel centres.

#include <array>
#include <vector>

namespace handlebody {

//! Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2). Edge 4·a + k runs along axis a; bit 0 of k is its
//! place along axis (a+1) % 3, bit 1 along (a+2) % 3.
struct CellCase {
  //! Loops of edges in which the surface crosses the sides of the cell, those of 5 and more. Each is filled
  //! by a fan around its mean point.
  std::vector<std::vector<int>> fans;
  //! Triangles of edges: the rest.
  std::vector<std::array<int, 3>> triangles;
};

//! By the corners that are inside (bit c: corner c), counter-clockwise seen from outside of the object.
const std::array<CellCase, 256>& cellCases();

//! The edge of a cell from `corner` along `axis`; the corner is its lower end.
int cellEdge(int corner, int axis);
//! The lower end of an edge.
int cellEdgeStart(int edge);

}  // namespace handlebody
