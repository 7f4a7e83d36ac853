#include "core/evolution/hollow_sizes.h"

#include <algorithm>
#include <cmath>

#include "core/evolution/size_field.h"

namespace handlebody {

namespace {

// Voxels of mean size that faces before a hollow object may lie below their corners: what they leave to half
// a voxel is for the corners' own distance, and for the faces of the object, which do the same.
constexpr double kMaxSagitta = 0.15;
constexpr double kMinPart = 0.5;  // of the target; nor less than
constexpr double kMinVoxels = 1;  // of mean size: shorter edges go into crevices where they meet themselves
constexpr double kNear = 0.5;     // edge lengths from such a place up to which edges are as short
constexpr double kFar = 1e9;      // cells: more than any volume has, and no overflow

}  // namespace

HollowSizes::HollowSizes(const WallSurface& objects, double edgeLength, double voxel)
    : edgeLength_(edgeLength) {
  const double least = std::min(1.0, std::max(kMinPart, kMinVoxels * voxel / edgeLength));
  reach_ = (kNear + (1 - least) / SizeField::kGrade) * edgeLength;
  const double across = kCircumradius * edgeLength, most = kMaxSagitta * voxel;
  for (std::size_t v = 0; v < objects.points().size(); ++v) {
    const double sagitta = objects.hollows()[v] * across * across;
    if (sagitta <= most) continue;
    const Vec3& where = objects.points()[v];
    places_[cellOf(where)].push_back({where, std::max(least, std::sqrt(most / sagitta))});
  }
}

double HollowSizes::at(const Vec3& world) const {
  if (places_.empty()) return 1;
  double part = 1;
  const Cell middle = cellOf(world);
  Cell c;
  for (c[0] = middle[0] - 1; c[0] <= middle[0] + 1; ++c[0])
    for (c[1] = middle[1] - 1; c[1] <= middle[1] + 1; ++c[1])
      for (c[2] = middle[2] - 1; c[2] <= middle[2] + 1; ++c[2]) {
        const auto held = places_.find(c);
        if (held == places_.end()) continue;
        for (const Place& p : held->second) {
          const double away = (p.where - world).norm() / edgeLength_;
          part = std::min(part, p.part + SizeField::kGrade * std::max(0.0, away - kNear));
        }
      }
  return part;
}

HollowSizes::Cell HollowSizes::cellOf(const Vec3& world) const {
  Cell c;
  for (std::size_t a = 0; a < 3; ++a)
    c[a] = static_cast<int>(std::clamp(std::floor(world[static_cast<int>(a)] / reach_), -kFar, kFar));
  return c;
}

std::size_t HollowSizes::Hash::operator()(const Cell& c) const {
  std::size_t hash = 0;
  for (const int x : c) hash = hash * 1'000'003 + static_cast<std::size_t>(static_cast<unsigned>(x));
  return hash;
}

}  // namespace handlebody
