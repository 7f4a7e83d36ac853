#include "core/surgery/trace.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

namespace {

constexpr int kRings = 4;  // of the opened mesh that are shown

std::array<Vec3, 3> cornersOf(const Mesh& mesh, const Triangle& t) {
  return {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])};
}

std::vector<Vec3> positionsOf(const Mesh& mesh, const std::vector<int>& vertices) {
  std::vector<Vec3> out;
  for (const int v : vertices) out.push_back(mesh.position(v));
  return out;
}

//! Faces near the opening that stay.
std::vector<int> facesAround(const Mesh& mesh, const Opening& opening, std::span<const Opening> openings) {
  std::vector<int> near = opening.lambda;
  for (int ring = 0; ring < kRings; ++ring) near = enlarge(mesh, near);
  std::vector<int> faces;
  for (const int v : near) mesh.forEachOutgoing(v, [&](int h) { faces.push_back(Mesh::faceOf(h)); });
  sortUnique(faces);
  std::erase_if(faces, [&](int f) {
    return std::any_of(openings.begin(), openings.end(), [f](const Opening& o) {
      return std::binary_search(o.faces.begin(), o.faces.end(), f);
    });
  });
  return faces;
}

}  // namespace

EventTrace traceOfCollision(const Mesh& mesh, std::span<const FacePair> pairs) {
  EventTrace trace;
  std::vector<int> colliding;
  for (const auto& [f, g] : pairs) colliding.insert(colliding.end(), {f, g});
  sortUnique(colliding);
  for (const int f : colliding)
    if (mesh.isFace(f)) trace.collidingFaces.push_back(cornersOf(mesh, mesh.face(f)));
  return trace;
}

void traceOpening(const Mesh& mesh, std::span<const Opening> openings, EventTrace& trace) {
  std::vector<int> opened;
  for (const Opening& o : openings) {
    trace.lambda.push_back(positionsOf(mesh, o.lambda));
    for (const auto& loop : o.loops) trace.boundaryLoops.push_back(positionsOf(mesh, loop));
    const std::vector<int> faces = facesAround(mesh, o, openings);
    opened.insert(opened.end(), faces.begin(), faces.end());
  }
  sortUnique(opened);
  for (const int f : opened) trace.openedFaces.push_back(cornersOf(mesh, mesh.face(f)));
  if (std::none_of(openings.begin(), openings.end(), [](const Opening& o) { return o.isRefined; })) return;
  trace.refinedFaces = trace.openedFaces;
  for (const Opening& o : openings)
    for (const int f : o.faces) trace.refinedFaces.push_back(cornersOf(mesh, mesh.face(f)));
}

void traceClosing(const Mesh& mesh, std::span<const Triangle> patch, EventTrace& trace) {
  for (const Triangle& t : patch) trace.handleFaces.push_back(cornersOf(mesh, t));
  trace.closedFaces = trace.openedFaces;
  trace.closedFaces.insert(trace.closedFaces.end(), trace.handleFaces.begin(), trace.handleFaces.end());
}

}  // namespace handlebody
