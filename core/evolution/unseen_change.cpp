#include "core/evolution/unseen_change.h"

#include <algorithm>
#include <vector>

#include "core/indices.h"
#include "core/mesh/changed_blocks.h"

namespace handlebody {

namespace {

bool isMarked(VertexMarkSpan marks, int v) { return idx(v) < marks.size() && marks[idx(v)] != 0; }

std::vector<int> newFaces(const Mesh& before, const Mesh& mesh) {
  std::vector<int> out;
  const int common = std::min(before.faceSlots(), mesh.faceSlots());
  const Triangle *was = before.faces().data(), *is = mesh.faces().data();
  visitChangedBlocks(
      common, [&](int f, int n) { return areSame(was + f, is + f, n); },
      [&](int f) {
        if (mesh.isFace(f) && was[f] != is[f]) out.push_back(f);
      });
  for (int f = common; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f)) out.push_back(f);
  return out;
}

}  // namespace

std::optional<int> unseenFace(const Mesh& mesh, std::span<const int> newFaces, VertexMarkSpan looked) {
  for (const int f : newFaces) {
    const Triangle& t = mesh.face(f);
    if (std::none_of(t.begin(), t.end(), [&](int v) { return isMarked(looked, v); })) return t[0];
  }
  return std::nullopt;
}

std::optional<int> unseenMove(const Mesh& before, const Mesh& mesh, VertexMarkSpan looked) {
  std::optional<int> unseen;
  const Vec3 *was = before.positions().data(), *is = mesh.positions().data();
  visitChangedBlocks(
      std::min(before.vertexSlots(), mesh.vertexSlots()),
      [&](int v, int n) { return areSame(was + v, is + v, n); },
      [&](int v) {
        if (!isMarked(looked, v) && mesh.isVertex(v) && is[v] != was[v]) unseen = v;
      });
  return unseen;
}

std::optional<int> unseenChange(const Mesh& before, const Mesh& mesh, VertexMarkSpan looked) {
  if (const auto v = unseenFace(mesh, newFaces(before, mesh), looked)) return v;
  return unseenMove(before, mesh, looked);
}

}  // namespace handlebody
