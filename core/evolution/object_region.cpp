#include "core/evolution/object_region.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>

namespace handlebody {

namespace {

using Voxel = ObjectRegion::Voxel;

class ObjectFlood {
 public:
  ObjectFlood(const SmoothedVolume& volume, double sign, const LevelField& levels)
      : volume_(volume), levels_(levels), sign_(sign), state_(allUnknown(volume.grid().voxelCount())) {}

  //! The nearest voxel may be noise: its neighbours are tried too.
  void start(const Vec3& seed) {
    const Voxel middle{round(seed[0]), round(seed[1]), round(seed[2])};
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) visit({middle[0] + i, middle[1] + j, middle[2] + k});
  }

  ObjectRegion run(std::size_t mostVoxels) {
    for (std::size_t next = 0; next < region_.voxels.size(); ++next) {
      if (region_.voxels.size() > mostVoxels) {
        region_.whole = false;
        break;
      }
      const Voxel v = region_.voxels[next];
      for (std::int8_t axis = 0; axis < 3; ++axis)
        for (int step : {-1, 1}) {
          Voxel w = v;
          w[static_cast<std::size_t>(axis)] += step;
          if (visit(w) == kOutside)
            region_.faces.push_back({static_cast<std::int32_t>(next), axis, static_cast<std::int8_t>(step)});
        }
    }
    return std::move(region_);
  }

 private:
  enum State : unsigned char { kUnknown = 0, kInside, kOutside, kNoImage };
  struct Free {
    void operator()(State* states) const { std::free(states); }
  };
  using States = std::unique_ptr<State[], Free>;

  //! By calloc, so that of a large volume only the pages that the region touches become memory.
  static States allUnknown(std::size_t voxels) {
    auto* states = static_cast<State*>(std::calloc(voxels, sizeof(State)));
    if (!states) throw std::bad_alloc();
    return States(states);
  }

  static std::int32_t round(double x) { return static_cast<std::int32_t>(std::lround(x)); }

  State visit(const Voxel& v) {
    const auto& n = volume_.grid().size;
    if (v[0] < 0 || v[1] < 0 || v[2] < 0 || v[0] >= n[0] || v[1] >= n[1] || v[2] >= n[2]) return kNoImage;
    const std::size_t at =
        (static_cast<std::size_t>(v[2]) * static_cast<std::size_t>(n[1]) + static_cast<std::size_t>(v[1])) *
            static_cast<std::size_t>(n[0]) +
        static_cast<std::size_t>(v[0]);
    State& state = state_[at];
    if (state != kUnknown) return state;
    if (volume_.isPadding(at)) return state = kNoImage;
    const double value = static_cast<double>(volume_.at(v[0], v[1], v[2]));
    state = sign_ * (value - levels_.at(Vec3(v[0], v[1], v[2]))) < 0 ? kInside : kOutside;
    if (state == kInside) region_.voxels.push_back(v);
    return state;
  }

  const SmoothedVolume& volume_;
  const LevelField& levels_;
  double sign_;
  States state_;  // per voxel
  ObjectRegion region_;
};

}  // namespace

ObjectRegion floodObject(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                         const LevelField& levels, std::size_t mostVoxels) {
  ObjectFlood flood(volume, sign, levels);
  for (const Vec3& s : seeds) flood.start(s);
  return flood.run(mostVoxels);
}

}  // namespace handlebody
