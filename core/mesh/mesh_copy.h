#pragma once
// Copies of a mesh as it changes: what is the same in two of them is kept once.

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace handlebody {

//! An array in blocks. A block that is, bit for bit, that of an earlier copy at its place is shared with it.
template <typename T>
class SharedBlocks {
 public:
  SharedBlocks(std::span<const T> values, const SharedBlocks* before) : size_(values.size()) {
    for (std::size_t begin = 0; begin < values.size(); begin += kLength) {
      const std::span<const T> part = values.subspan(begin, std::min(kLength, values.size() - begin));
      const Block* known = before ? before->block(blocks_.size()) : nullptr;
      blocks_.push_back(known && isSame(**known, part)
                            ? *known
                            : std::make_shared<const std::vector<T>>(part.begin(), part.end()));
    }
  }
  std::vector<T> joined() const {
    std::vector<T> out;
    out.reserve(size_);
    for (const Block& b : blocks_) out.insert(out.end(), b->begin(), b->end());
    return out;
  }
  //! Bytes, but for the blocks that are shared with `before`.
  std::size_t memoryBeside(const SharedBlocks* before) const {
    std::size_t bytes = blocks_.size() * sizeof(Block);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const Block* known = before ? before->block(i) : nullptr;
      if (!known || *known != blocks_[i]) bytes += blocks_[i]->size() * sizeof(T);
    }
    return bytes;
  }

 private:
  using Block = std::shared_ptr<const std::vector<T>>;
  static constexpr std::size_t kLength = 256;  // elements: a few neighbourhoods of vertices

  //! Bits, not values: 0 and -0 differ.
  static bool isSame(const std::vector<T>& a, std::span<const T> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), b.size_bytes()) == 0;
  }
  const Block* block(std::size_t i) const { return i < blocks_.size() ? &blocks_[i] : nullptr; }

  std::vector<Block> blocks_;
  std::size_t size_;
};

//! A mesh as it was, with all of its slots. Immutable.
class MeshCopy {
 public:
  //! `before`: an earlier copy of the same mesh; what has not changed since is shared with it.
  MeshCopy(const Mesh& mesh, const MeshCopy* before);
  //! The mesh, bit for bit.
  Mesh mesh() const;
  //! Bytes, but for what is shared with `before`, if that is given.
  std::size_t memoryBeside(const MeshCopy* before) const;

 private:
  SharedBlocks<Vec3> positions_;
  SharedBlocks<Triangle> faces_;
  SharedBlocks<int> opposite_, outgoing_, freeVertices_, freeFaces_;
};

}  // namespace handlebody
