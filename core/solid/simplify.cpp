#include "core/solid/simplify.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/mesh/validity.h"
#include "core/object/distance.h"
#include "core/phase.h"
#include "core/solid/mask_surface.h"

namespace handlebody {

namespace {

//! Marks the part that holds a voxel as `label`; returns its number of voxels.
std::size_t flood(const Mask& mask, std::size_t start, int label, std::vector<int>& labels) {
  const std::array<int, 3>& n = mask.grid.size;
  std::vector<std::size_t> reached{start};
  labels[start] = label;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const std::size_t at = reached[i];
    const std::array<int, 3> p{static_cast<int>(at % idx(n[0])), static_cast<int>(at / idx(n[0]) % idx(n[1])),
                               static_cast<int>(at / (idx(n[0]) * idx(n[1])))};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int by : {-1, 1}) {
        std::array<int, 3> q = p;
        q[axis] += by;
        if (!mask.holds(q[0], q[1], q[2])) continue;
        const std::size_t next = mask.at(q[0], q[1], q[2]);
        if (labels[next] != 0) continue;
        labels[next] = label;
        reached.push_back(next);
      }
  }
  return reached.size();
}

//! With `margin` voxels more on all sides.
Mask widened(const Mask& mask, int margin) {
  Mask wide;
  wide.grid = mask.grid;
  for (int& n : wide.grid.size) n += 2 * margin;
  wide.grid.origin = mask.grid.toWorld(Vec3::Constant(-margin));
  wide.inside.assign(wide.grid.voxelCount(), 0);
  for (int z = 0; z < mask.grid.size[2]; ++z)
    for (int y = 0; y < mask.grid.size[1]; ++y)
      for (int x = 0; x < mask.grid.size[0]; ++x)
        wide.inside[wide.at(x + margin, y + margin, z + margin)] = mask.inside[mask.at(x, y, z)];
  return wide;
}

//! Every voxel within the radius (mm) of one of `value` becomes so.
void spread(Mask& mask, std::uint8_t value, double radius) {
  giveUpIfCancelled();
  std::vector<std::uint8_t> of(mask.inside.size());
  for (std::size_t i = 0; i < of.size(); ++i) of[i] = mask.inside[i] == value ? 1 : 0;
  const std::vector<float> distance = distanceTo(mask.grid.size, mask.grid.spacing, of);
  for (std::size_t i = 0; i < of.size(); ++i)
    if (distance[i] <= radius) mask.inside[i] = value;
}

std::size_t difference(const Mask& a, const Mask& b) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < a.inside.size(); ++i) n += a.inside[i] != b.inside[i];
  return n;
}

}  // namespace

Mask largestPart(const Mask& mask) {
  const Phase phase("largest part");
  std::vector<int> labels(mask.inside.size(), 0);
  int count = 0, largest = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (mask.inside[i] == 0 || labels[i] != 0) continue;
    const std::size_t n = flood(mask, i, ++count, labels);
    if (n > most) {
      most = n;
      largest = count;
    }
  }
  Mask part = mask;
  for (std::size_t i = 0; i < labels.size(); ++i)
    part.inside[i] = labels[i] == largest && largest > 0 ? 1 : 0;
  return part;
}

namespace {

Certificate topologyOf(const Mask& mask) {
  const TriangleSoup surface = maskSurface(mask);
  return surface.triangles.empty() ? Certificate{} : examine(Mesh(surface));
}

int tunnelsOf(const Certificate& c) { return std::accumulate(c.genus.begin(), c.genus.end(), 0); }

//! Neither more parts nor more cavities.
bool isSimpler(const Certificate& c, const Certificate& before, int genus) {
  return tunnelsOf(c) <= genus && c.cavities <= std::max(0, before.cavities) &&
         c.components - c.cavities <= before.components - before.cavities;
}

}  // namespace

int countTunnels(const Mask& mask) { return tunnelsOf(topologyOf(mask)); }

std::optional<Mask> withFewerTunnels(const Mask& mask, int genus) {
  const Phase phase("tunnels");
  const Certificate before = topologyOf(mask);
  if (tunnelsOf(before) <= genus) return mask;
  std::optional<Mask> best;
  std::size_t fewest = 0;
  const double step = mask.grid.spacing.minCoeff();
  const Mask wide = widened(mask, kLargestBall + 1);
  for (const std::uint8_t first : {std::uint8_t{1}, std::uint8_t{0}})
    for (int ball = 1; ball <= kLargestBall; ++ball) {
      Mask changed = wide;
      spread(changed, first, ball * step * 1.001);
      spread(changed, first == 1 ? 0 : 1, ball * step * 1.001);
      const std::size_t n = difference(changed, wide);
      if (changed.count() == 0 || (best && n >= fewest)) break;  // larger balls change more
      if (!isSimpler(topologyOf(changed), before, genus)) continue;
      best = std::move(changed);
      fewest = n;
      break;
    }
  return best;
}

}  // namespace handlebody
