#pragma once
// What the tests of the surgery share.

#include <algorithm>
#include <queue>

#include "core/collision/self_intersection.h"
#include "core/mesh/validity.h"
#include "core/surgery/closing.h"
#include "core/surgery/opening.h"

namespace handlebody::testing {

inline std::vector<FacePair> intersections(const Mesh& mesh) {
  return findSelfIntersections(mesh.positions(), mesh.faces());
}

inline double volumeOf(const Mesh& mesh) { return examine(mesh.compact()).volume; }
inline double areaOf(const Mesh& mesh) { return examine(mesh.compact()).area; }

//! Takes the openings out of the mesh and puts the patch in.
inline void apply(Mesh& mesh, const std::vector<Opening>& openings, const Patch& patch) {
  std::vector<int> faces, vertices;
  for (const Opening& o : openings) {
    faces.insert(faces.end(), o.faces.begin(), o.faces.end());
    vertices.insert(vertices.end(), o.lambda.begin(), o.lambda.end());
  }
  mesh.removeFaces(faces);
  for (int v : vertices) mesh.removeVertex(v);
  std::vector<int> fresh;
  for (const Vec3& p : patch.points) fresh.push_back(mesh.addVertex(p));
  std::vector<Triangle> triangles = patch.faces;
  for (Triangle& t : triangles)
    for (int& v : t)
      if (v >= patch.firstNew) v = fresh[v - patch.firstNew];
  mesh.addFaces(triangles);
}

//! Graph distance of every vertex from the nearest of `sources`; -1 where none is reached.
inline std::vector<int> graphDistances(const Mesh& mesh, const std::vector<int>& sources) {
  std::vector<int> distance(mesh.vertexSlots(), -1);
  std::queue<int> queue;
  for (int v : sources) {
    distance[v] = 0;
    queue.push(v);
  }
  while (!queue.empty()) {
    const int v = queue.front();
    queue.pop();
    mesh.forEachNeighbour(v, [&](int w) {
      if (distance[w] >= 0) return;
      distance[w] = distance[v] + 1;
      queue.push(w);
    });
  }
  return distance;
}

//! The vertex nearest to p.
inline int vertexNear(const Mesh& mesh, const Vec3& p) {
  int nearest = 0;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && (mesh.position(v) - p).norm() < (mesh.position(nearest) - p).norm()) nearest = v;
  return nearest;
}

//! All vertices closer to p than `radius`, ascending.
inline std::vector<int> verticesNear(const Mesh& mesh, const Vec3& p, double radius) {
  std::vector<int> near;
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v) && (mesh.position(v) - p).norm() < radius) near.push_back(v);
  return near;
}

//! Two vertices with exactly one common neighbour: the stars touch in one point.
inline std::vector<int> pinchingPair(const Mesh& mesh) {
  const std::vector<int> d = graphDistances(mesh, {0});
  for (int v = 0; v < mesh.vertexSlots(); ++v) {
    int common = 0;
    mesh.forEachNeighbour(v, [&](int w) { common += d[w] == 1; });
    if (d[v] == 2 && common == 1) return {0, v};
  }
  return {};
}

//! Of all faces: twice the area over the longest edge, mm.
inline double leastAltitude(const Mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (int f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isFace(f)) continue;
    double longest = 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      longest = std::max(longest, (mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))).norm());
    least = std::min(least, mesh.areaVector(f).norm() / longest);
  }
  return least;
}

}  // namespace handlebody::testing
