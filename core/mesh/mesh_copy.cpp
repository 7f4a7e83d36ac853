#include "core/mesh/mesh_copy.h"

namespace handlebody {

MeshCopy::MeshCopy(const Mesh& mesh, const MeshCopy* before)
    : positions_(mesh.positions_, before ? &before->positions_ : nullptr),
      faces_(mesh.faces_, before ? &before->faces_ : nullptr),
      opposite_(mesh.opposite_, before ? &before->opposite_ : nullptr),
      outgoing_(mesh.outgoing_, before ? &before->outgoing_ : nullptr),
      freeVertices_(mesh.freeVertices_, before ? &before->freeVertices_ : nullptr),
      freeFaces_(mesh.freeFaces_, before ? &before->freeFaces_ : nullptr) {}

Mesh MeshCopy::mesh() const {
  Mesh out;
  out.positions_ = positions_.joined();
  out.faces_ = faces_.joined();
  out.opposite_ = opposite_.joined();
  out.outgoing_ = outgoing_.joined();
  out.freeVertices_ = freeVertices_.joined();
  out.freeFaces_ = freeFaces_.joined();
  return out;
}

std::size_t MeshCopy::memoryBeside(const MeshCopy* before) const {
  return positions_.memoryBeside(before ? &before->positions_ : nullptr) +
         faces_.memoryBeside(before ? &before->faces_ : nullptr) +
         opposite_.memoryBeside(before ? &before->opposite_ : nullptr) +
         outgoing_.memoryBeside(before ? &before->outgoing_ : nullptr) +
         freeVertices_.memoryBeside(before ? &before->freeVertices_ : nullptr) +
         freeFaces_.memoryBeside(before ? &before->freeFaces_ : nullptr);
}

}  // namespace handlebody
