#include "core/surgery/face_blocks.h"

#include <array>
#include <numeric>

#include "core/indices.h"

namespace handlebody {

namespace {

constexpr std::size_t kBits = 5;  // per axis: 32³ cells, some 100 kB of counters
constexpr std::size_t kCells = std::size_t{1} << 3 * kBits;

//! Bit i goes to bit 3i.
constexpr std::array<unsigned short, 1 << kBits> spreadBits() {
  std::array<unsigned short, 1 << kBits> out{};
  for (std::size_t x = 0; x < out.size(); ++x)
    for (std::size_t i = 0; i < kBits; ++i)
      out[x] = static_cast<unsigned short>(out[x] | ((x >> i & 1) << 3 * i));
  return out;
}

//! Cells of a grid over all faces, numbered in Morton order.
class Cells {
 public:
  explicit Cells(const Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (int v = 0; v < mesh.vertexSlots(); ++v)
      if (mesh.isVertex(v)) box.extend(mesh.position(v));
    if (box.isEmpty()) return;
    low_ = box.min();
    const double longest = box.sizes().maxCoeff();
    if (longest > 0) scale_ = (1 << kBits) * 0.999 / longest;
  }
  std::size_t of(const Vec3& p) const {
    static constexpr auto kSpread = spreadBits();
    const Vec3 a = (p - low_) * scale_;
    const auto along = [&](int axis) {
      return static_cast<std::size_t>(kSpread[static_cast<int>(std::clamp(a[axis], 0.0, 31.0))]);
    };
    return along(0) | along(1) << 1 | along(2) << 2;
  }

 private:
  Vec3 low_{0, 0, 0};
  double scale_ = 0;
};

}  // namespace

FaceBlocks::FaceBlocks(const Mesh& mesh) {
  for (int f = 0; f < mesh.faceSlots(); ++f)
    if (mesh.isFace(f)) include(mesh, f);
}

void FaceBlocks::sortByPlace(const Mesh& mesh) {
  const Cells cells(mesh);
  const int slots = mesh.faceSlots();
  std::vector<unsigned short> cell(slots, kCells - 1);  // of free slots: at the end, in some block
  std::vector<int> start(kCells + 1, 0);
  for (int f = 0; f < slots; ++f) {
    if (mesh.isFace(f)) cell[f] = static_cast<unsigned short>(cells.of(mesh.position(mesh.face(f)[0])));
    ++start[std::size_t{cell[f]} + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  faceOfPlace_.resize(slots);
  placeOfFace_.resize(slots);
  for (int f = 0; f < slots; ++f) {
    const int place = start[cell[f]]++;
    faceOfPlace_[place] = f;
    placeOfFace_[f] = place;
  }
  boxes_.clear();
  for (int f = 0; f < slots; ++f)
    if (mesh.isFace(f)) include(mesh, f);
}

void FaceBlocks::include(const Mesh& mesh, int face) {
  const auto block = idx(placeOf(face) / kBlock);
  if (block >= boxes_.size()) boxes_.resize(block + 1);
  for (const int v : mesh.face(face)) boxes_[block].extend(mesh.position(v));
}

void FaceBlocks::includeAround(const Mesh& mesh, std::span<const int> vertices) {
  for (const int v : vertices) mesh.forEachOutgoing(v, [&](int h) { include(mesh, Mesh::faceOf(h)); });
}

}  // namespace handlebody
