#include "core/mesh/morton_order.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace handlebody {

namespace {

constexpr int kBits = 21;  // per axis: three of them fit into a key

//! Bit i goes to bit 3i.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::uint64_t mortonKey(const Vec3& p) {
  const auto along = [&](int axis) {
    return spread(static_cast<std::uint64_t>(std::min(p[axis], (1 << kBits) - 1.0)));
  };
  return along(0) | along(1) << 1 | along(2) << 2;
}

}  // namespace

std::vector<int> mortonOrder(const Mesh& mesh, double cell) {
  std::vector<std::pair<std::uint64_t, int>> keys;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) low = low.cwiseMin(mesh.position(v));
  for (int v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.isVertex(v)) keys.emplace_back(mortonKey((mesh.position(v) - low) / cell), v);
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& [key, v] : keys) order.push_back(v);
  return order;
}

}  // namespace handlebody
