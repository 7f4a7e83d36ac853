#include "core/mesh/structure.h"

#include <algorithm>
#include <array>

#include "core/mesh/changed_blocks.h"

namespace handlebody {

namespace {

bool hasFace(const Mesh& mesh, int f) { return f < mesh.faceSlots() && mesh.isFace(f); }
bool hasVertex(const Mesh& mesh, int v) { return v >= 0 && v < mesh.vertexSlots() && mesh.isVertex(v); }

//! Without a branch, and without a call for so few bytes as std::array's == makes.
bool areEqual(const int* a, const int* b) { return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0; }

//! Half-edges that leave v in its fan. Precondition: those around it have opposites that agree.
int fanSize(const Mesh& mesh, int v) {
  int n = 0;
  mesh.forEachOutgoing(v, [&](int) { ++n; });
  return n;
}

//! A vertex that more faces hold than its fan does; -1 if there is none. Slow.
int vertexWithFans(const Mesh& mesh) {
  std::vector<int> corners(mesh.vertexSlots(), 0);
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f))
      for (const int v : mesh.face(f)) ++corners[v];
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (corners[v] != (mesh.isVertex(v) ? fanSize(mesh, v) : 0)) return v;
  return -1;
}

}  // namespace

void StructureCheck::listChanges(const Mesh& before, const Mesh& mesh) {
  changedFaces_.clear();
  newFaces_.clear();
  const int common = std::min(before.faceSlots(), mesh.faceSlots());
  const Triangle *was = before.faces().data(), *is = mesh.faces().data();
  const int *wasBeside = before.opposites().data(), *isBeside = mesh.opposites().data();
  const auto isSame = [&](int f, int n) {
    return areSame(was + f, is + f, n) && areSame(wasBeside + 3 * f, isBeside + 3 * f, 3 * n);
  };
  visitChangedBlocks(common, isSame, [&](int f) {
    const bool isNew = !areEqual(was[f].data(), is[f].data());
    const bool isBesideOther = !areEqual(wasBeside + 3 * f, isBeside + 3 * f);
    if (!(isNew | isBesideOther)) return;
    if (isNew && mesh.isFace(f)) newFaces_.push_back(f);
    if (isNew || mesh.isFace(f)) changedFaces_.push_back(f);
  });
  for (int f = common; f < std::max(before.faceSlots(), mesh.faceSlots()); ++f) {
    changedFaces_.push_back(f);
    if (hasFace(mesh, f)) newFaces_.push_back(f);
  }
}

std::optional<StructureFault> StructureCheck::examineHalfedge(const Mesh& mesh, int h) const {
  const int v = mesh.origin(h), g = mesh.opposite(h);
  if (g < 0) return StructureFault{FindingKind::edgeWithOneFace, v};
  if (!hasFace(mesh, Mesh::faceOf(g)) || mesh.opposite(g) != h)
    return StructureFault{FindingKind::facesDisagree, v};
  if (mesh.origin(g) != mesh.target(h) || mesh.target(g) != v)
    return StructureFault{FindingKind::facesOpposed, v};
  if (mesh.apex(h) == mesh.apex(g)) return StructureFault{FindingKind::facesTwice, v};
  return std::nullopt;
}

std::optional<StructureFault> StructureCheck::examineFace(const Mesh& mesh, int f) const {
  const Triangle& t = mesh.face(f);
  for (const int v : t)
    if (!hasVertex(mesh, v)) return StructureFault{FindingKind::removedVertex, -1};
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return StructureFault{FindingKind::vertexTwice, t[0]};
  for (int h = 3 * f; h < 3 * f + 3; ++h)
    if (auto fault = examineHalfedge(mesh, h)) return fault;
  return std::nullopt;
}

void StructureCheck::markCorners(const Mesh& mesh, int f, Counts& counts) {
  ++counts.faces;
  counts.corners += 3;
  for (const int v : mesh.face(f)) isChanged_[v] = 1;
}

//! Also looks at the faces that lay beside changed ones: they may still hold the opposites of before. One
//! that does not has changed itself, and where two hold each other, looking at one of them has been enough.
std::optional<StructureFault> StructureCheck::examineFaces(const Mesh& before, const Mesh& mesh) {
  for (const int f : changedFaces_) {
    if (hasFace(mesh, f)) {
      if (auto fault = examineFace(mesh, f)) return fault;
      markCorners(mesh, f, is_);
    }
    if (!hasFace(before, f)) continue;
    markCorners(before, f, was_);
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int g = before.opposite(h);
      if (!hasFace(mesh, Mesh::faceOf(g)) || mesh.opposite(g) != h) continue;
      if (!hasFace(mesh, f) || mesh.opposite(h) != g)
        return StructureFault{FindingKind::facesDisagree, mesh.origin(g)};
    }
  }
  return std::nullopt;
}

//! The link of v as its fan shows it: its neighbours, all different.
std::optional<StructureFault> StructureCheck::examineLink(const Mesh& mesh, int v) {
  const int start = mesh.outgoing(v);
  if (start < 0) return StructureFault{FindingKind::vertexWithoutFace, v};
  if (!hasFace(mesh, Mesh::faceOf(start)) || mesh.origin(start) != v)
    return StructureFault{FindingKind::wrongHalfedge, v};
  ++links_;
  bool isTwice = false;
  mesh.forEachOutgoing(v, [&](int h) {
    int& seen = seenAt_[mesh.target(h)];
    isTwice = isTwice || seen == links_;
    seen = links_;
    ++is_.fans;
  });
  if (isTwice) return StructureFault{FindingKind::edgesTwice, v};
  return std::nullopt;
}

void StructureCheck::listVertices(const Mesh& before, const Mesh& mesh) {
  changedVertices_.clear();
  const int common = std::min(before.vertexSlots(), mesh.vertexSlots());
  const int *was = before.outgoing().data(), *is = mesh.outgoing().data();
  static constexpr std::array<unsigned char, kLargestBlock> kNone{};
  const auto isSame = [&](int v, int n) {
    return areSame(was + v, is + v, n) && areSame(isChanged_.data() + v, kNone.data(), n);
  };
  visitChangedBlocks(common, isSame, [&](int v) {
    if (isChanged_[v] != 0 || was[v] != is[v]) changedVertices_.push_back(v);
  });
  for (int v = common; v < std::max(before.vertexSlots(), mesh.vertexSlots()); ++v)
    changedVertices_.push_back(v);
}

//! The fans of the changed vertices must have won and lost as many faces as hold these vertices: a fan can
//! miss faces of its vertex, but never have one too many.
std::optional<StructureFault> StructureCheck::examineVertices(const Mesh& before, const Mesh& mesh) {
  listVertices(before, mesh);
  for (const int v : changedVertices_) {
    const bool was = hasVertex(before, v), is = hasVertex(mesh, v);
    if (was) {
      ++was_.vertices;
      was_.fans += fanSize(before, v);
    }
    if (!is) continue;
    ++is_.vertices;
    if (auto fault = examineLink(mesh, v)) return fault;
  }
  if (is_.fans - was_.fans != is_.corners - was_.corners)
    return StructureFault{FindingKind::severalFans, vertexWithFans(mesh)};
  if (mesh.vertexCount() - before.vertexCount() != is_.vertices - was_.vertices ||
      mesh.faceCount() - before.faceCount() != is_.faces - was_.faces)
    return StructureFault{FindingKind::wrongCounts, -1};
  return std::nullopt;
}

std::optional<StructureFault> StructureCheck::examineChanges(const Mesh& before, const Mesh& mesh) {
  was_ = is_ = {};
  const int slots = std::max(before.vertexSlots(), mesh.vertexSlots());
  isChanged_.assign(slots, 0);
  seenAt_.resize(slots, 0);
  listChanges(before, mesh);
  if (auto fault = examineFaces(before, mesh)) return fault;
  return examineVertices(before, mesh);
}

std::optional<StructureFault> StructureCheck::examine(const Mesh& mesh) {
  return examineChanges(Mesh(), mesh);
}

std::optional<StructureFault> findStructureFault(const Mesh& mesh) { return StructureCheck().examine(mesh); }

}  // namespace handlebody
