#include "core/surgery/face_blocks.h"

namespace handlebody {

FaceBlocks::FaceBlocks(const Mesh& mesh) {
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f)) include(mesh, f);
}

void FaceBlocks::include(const Mesh& mesh, int face) {
  const auto block = static_cast<std::size_t>(face / kBlock);
  if (block >= boxes_.size()) boxes_.resize(block + 1);
  for (const int v : mesh.face(face)) boxes_[block].extend(mesh.position(v));
}

void FaceBlocks::includeAround(const Mesh& mesh, std::span<const int> vertices) {
  for (const int v : vertices) mesh.forEachOutgoing(v, [&](int h) { include(mesh, Mesh::faceOf(h)); });
}

}  // namespace handlebody
