#pragma once
// How far one surface is from another, over all of its area (docs/compare.md).

#include <cstddef>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! Every triangle is halved along its longest edge until no edge is longer than the sampling distance h; each
//! piece counts with its area and the distance of its centroid, whose error is at most 2/3·h. Vertices count
//! for the smallest and the largest distance alone.
struct DirectedDistances {
  double area = 0;          //!< mm², of the surface whose points are measured
  double mean = 0;          //!< mm, weighted by area
  double percentile95 = 0;  //!< mm: the smallest d for which 95 % of the area is no farther than d
  double largest = 0;       //!< mm: the directed Hausdorff distance
  double smallest = 0;      //!< mm
  std::size_t samples = 0;
};

//! From the points of one mesh to the nearest point of another; both have triangles. `h` in mm, > 0. The same
//! for any number of threads. Takes 16 bytes per sample.
DirectedDistances directedDistances(const TriangleSoup& from, const TriangleSoup& to, double h, int threads);

//! How many samples that takes; where there are more than `most`, any number above it.
std::size_t countSamples(const TriangleSoup& mesh, double h, std::size_t most);

//! mm²
double areaOf(const TriangleSoup& mesh);

//! Per point of `mesh` the distance (mm) to `to`, negative inside of it. `to` is closed and oriented; where
//! it is not (`isSigned` = false) all are positive.
std::vector<double> vertexDistances(const TriangleSoup& mesh, const TriangleSoup& to, bool isSigned,
                                    int threads);

}  // namespace handlebody
