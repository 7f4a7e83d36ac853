#include "core/surgery/opening.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "core/indices.h"

namespace handlebody {

namespace {

bool contains(const std::vector<int>& sorted, int v) {
  return std::binary_search(sorted.begin(), sorted.end(), v);
}

std::vector<int> neighbourhood(const Mesh& mesh, const std::vector<int>& lambda) {
  std::vector<int> n;
  for (int v : lambda)
    mesh.forEachNeighbour(v, [&](int w) {
      if (!contains(lambda, w)) n.push_back(w);
    });
  sortUnique(n);
  return n;
}

bool everyFaceTouches(const Mesh& mesh, int v, const std::vector<int>& lambda) {
  bool all = true;
  mesh.forEachOutgoing(
      v, [&](int h) { all = all && (contains(lambda, mesh.target(h)) || contains(lambda, mesh.apex(h))); });
  return all;
}

//! Adds to Λ the neighbours that would be left without a face.
void absorbEnclosed(const Mesh& mesh, std::vector<int>& lambda) {
  for (bool any = true; any;) {
    any = false;
    for (int v : neighbourhood(mesh, lambda))
      if (everyFaceTouches(mesh, v, lambda)) {
        lambda.insert(std::lower_bound(lambda.begin(), lambda.end(), v), v);
        any = true;
      }
  }
}

//! The polygons of the half-edges that lead round the faces, or none if two of them start at one vertex.
std::optional<std::vector<std::vector<int>>> boundaryLoops(const Mesh& mesh, const std::vector<int>& faces) {
  std::map<int, int> successor;
  for (int f : faces)
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (!contains(faces, Mesh::faceOf(mesh.opposite(h))) &&
          !successor.emplace(mesh.origin(h), mesh.target(h)).second)
        return std::nullopt;
  std::vector<std::vector<int>> loops;
  while (!successor.empty()) {
    std::vector<int> loop;
    const int start = successor.begin()->first;
    int v = start;
    do {
      loop.push_back(v);
      const auto it = successor.find(v);
      v = it->second;
      successor.erase(it);
    } while (v != start);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

std::vector<int> enlarge(const Mesh& mesh, const std::vector<int>& lambda) {
  std::vector<int> out = neighbourhood(mesh, lambda);
  out.insert(out.end(), lambda.begin(), lambda.end());
  sortUnique(out);
  return out;
}

std::optional<Opening> planOpening(const Mesh& mesh, std::vector<int> lambda) {
  absorbEnclosed(mesh, lambda);
  Opening o;
  for (int v : lambda) mesh.forEachOutgoing(v, [&](int h) { o.faces.push_back(Mesh::faceOf(h)); });
  sortUnique(o.faces);
  auto loops = boundaryLoops(mesh, o.faces);
  if (!loops) return std::nullopt;
  o.lambda = std::move(lambda);
  o.loops = std::move(*loops);
  return o;
}

Opening openWithRefinement(Mesh& mesh, const std::vector<int>& lambda) {
  if (auto opening = planOpening(mesh, lambda)) return *opening;
  std::vector<std::pair<int, int>> spokes;
  for (int v : lambda)
    mesh.forEachNeighbour(v, [&](int w) {
      if (!contains(lambda, w)) spokes.emplace_back(v, w);
    });
  for (const auto& [v, w] : spokes)
    mesh.splitEdge(mesh.findHalfedge(v, w), (mesh.position(v) + mesh.position(w)) / 2);
  auto opening = planOpening(mesh, lambda);
  assert(opening);
  opening->isRefined = true;
  return *opening;
}

}  // namespace handlebody
