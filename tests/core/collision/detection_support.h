#pragma once
// A workspace as the detector makes it ready, and what is to be found, face by face.

#include <algorithm>
#include <random>

#include "core/collision/detection_workspace.h"
#include "tests/support/mesh_zoo.h"

namespace handlebody::testing {

//! Spans of what must outlive it.
inline DetectionWorkspace workspaceOf(const TriangleSoup& soup) {
  DetectionWorkspace work;
  work.points = soup.points;
  work.faces = soup.triangles;
  work.stars.build(soup.points.size(), soup.triangles);
  work.sizes.resize(soup.points.size());
  return work;
}

inline void measure(DetectionWorkspace& work) {
  for (const int v : work.vertices) work.sizes[v] = measureStar(work.points, v, work.stars.corners(v));
}

//! All faces are looked at.
inline void lookAtAll(DetectionWorkspace& work) {
  for (int v = 0; v < work.stars.vertexCount(); ++v)
    if (!work.stars.corners(v).empty()) work.vertices.push_back(v);
  measure(work);
  for (const int v : work.vertices)
    work.longestSquared = std::max(work.longestSquared, work.sizes[v].longestEdge);
}

//! One flag per point, one in `every` of them 1.
inline std::vector<unsigned char> someMoved(std::size_t points, unsigned every, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<unsigned char> moved(points, 0);
  for (unsigned char& m : moved) m = random() % every == 0;
  return moved;
}

//! Every pair of faces that intersects and is wanted: those with a common vertex, or those without.
inline std::vector<FacePair> everyPair(const DetectionWorkspace& work, bool adjacent) {
  std::vector<FacePair> out;
  const int n = static_cast<int>(work.faces.size());
  for (int f = 0; f < n; ++f)
    for (int g = f + 1; g < n; ++g) {
      const Triangle &s = work.faces[f], &t = work.faces[g];
      if (work.isWanted(f, g) && shareVertex(s, t) == adjacent && facesIntersect(work.points, s, t))
        out.emplace_back(f, g);
    }
  return out;
}

}  // namespace handlebody::testing
