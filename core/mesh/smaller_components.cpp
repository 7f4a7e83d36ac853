#include "core/mesh/smaller_components.h"

#include <algorithm>

namespace handlebody {

namespace {

constexpr double kReach = 2;  // longest edges: on the way of a face, and by regulating

}  // namespace

void SmallerComponents::know(const Components& parts) {
  boxes_.emplace();
  const auto largest = std::max_element(parts.extent.begin(), parts.extent.end()) - parts.extent.begin();
  for (std::ptrdiff_t c = 0; c < parts.count(); ++c)
    if (c != largest) boxes_->push_back(parts.box[c]);
}

void SmallerComponents::follow(const MeshMotion& motion) {
  if (boxes_ && mayBeReached(motion)) boxes_.reset();
}

bool SmallerComponents::mayBeReached(const MeshMotion& motion) const {
  if (boxes_->empty()) return false;
  std::vector<Eigen::AlignedBox3d> reaches = *boxes_;
  const Vec3 margin = Vec3::Constant(kReach * motion.longest);
  for (Eigen::AlignedBox3d& box : reaches) box = {box.min() - margin, box.max() + margin};
  for (int v = 0; v < static_cast<int>(motion.touched.size()); ++v) {
    if (motion.touched[v] == 0 || !motion.mesh.isVertex(v)) continue;
    Eigen::AlignedBox3d way(motion.mesh.position(v));
    if (v < motion.before.vertexSlots() && motion.before.isVertex(v)) way.extend(motion.before.position(v));
    if (std::any_of(reaches.begin(), reaches.end(), [&](const auto& box) { return box.intersects(way); }))
      return true;
  }
  return false;
}

}  // namespace handlebody
