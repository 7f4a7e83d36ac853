#include "core/evolution/object_region.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

#include "core/evolution/level_test.h"
#include "core/evolution/neck.h"

namespace handlebody {

namespace {

using Voxel = ObjectRegion::Voxel;

class ObjectFlood {
 public:
  ObjectFlood(const SmoothedVolume& volume, double sign, const LevelField& levels, const Barrier* barrier)
      : volume_(volume),
        barrier_(barrier),
        isInside_(sign, levels),
        state_(allUnknown(volume.grid().voxelCount())) {
    const auto& n = volume.grid().size;
    stride_ = {1, static_cast<std::size_t>(n[0]),
               static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1])};
  }

  //! The nearest voxel may be noise: its neighbours are tried too.
  void start(const Vec3& seed) {
    const Voxel middle{round(seed[0]), round(seed[1]), round(seed[2])};
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          const Voxel v{middle[0] + i, middle[1] + j, middle[2] + k};
          if (volume_.grid().contains(Vec3(v[0], v[1], v[2]))) visit(v, indexOf(v));
        }
  }

  ObjectRegion run(std::size_t mostVoxels) {
    for (std::size_t next = 0; next < region_.voxels.size(); ++next) {
      if (region_.voxels.size() > mostVoxels) {
        region_.whole = false;
        break;
      }
      const Voxel v = region_.voxels[next];
      const std::size_t at = indexOf(v);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool before = v[axis] > 0, after = v[axis] + 1 < volume_.grid().size[axis];
        if (before) visitBeside(next, axis, -1, at - stride_[axis]);
        if (after) visitBeside(next, axis, 1, at + stride_[axis]);
        region_.atBorder += static_cast<std::size_t>(!before) + static_cast<std::size_t>(!after);
      }
    }
    return std::move(region_);
  }

 private:
  enum class State : std::uint8_t { unknown = 0, inside, outside, noImage, closed };
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

  std::size_t indexOf(const Voxel& v) const {
    return static_cast<std::size_t>(v[0]) + static_cast<std::size_t>(v[1]) * stride_[1] +
           static_cast<std::size_t>(v[2]) * stride_[2];
  }

  //! The neighbour, with index `at`, of the given voxel of the region.
  void visitBeside(std::size_t voxel, std::size_t axis, int step, std::size_t at) {
    State state = state_[at];
    if (state == State::unknown) {
      Voxel v = region_.voxels[voxel];
      v[axis] += step;
      state = visit(v, at);
    }
    if (state == State::outside)
      region_.faces.push_back(
          {static_cast<std::int32_t>(voxel), static_cast<std::int8_t>(axis), static_cast<std::int8_t>(step)});
    region_.againstPadding += state == State::noImage;
  }

  State visit(const Voxel& v, std::size_t at) {
    State& state = state_[at];
    if (state != State::unknown) return state;
    if (volume_.isPadding(at)) return state = State::noImage;
    if (barrier_ && barrier_->openness(Vec3(v[0], v[1], v[2])) <= 0) return state = State::closed;
    const bool inside = isInside_.at(volume_.at(v[0], v[1], v[2]), Vec3(v[0], v[1], v[2]));
    state = inside ? State::inside : State::outside;
    if (state == State::inside) region_.voxels.push_back(v);
    return state;
  }

  const SmoothedVolume& volume_;
  const Barrier* barrier_;  // may be null
  LevelTest isInside_;
  std::array<std::size_t, 3> stride_{};
  States state_;  // per voxel
  ObjectRegion region_;
};

}  // namespace

ObjectRegion floodObject(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                         const LevelField& levels, std::size_t mostVoxels, const Barrier* barrier) {
  ObjectFlood flood(volume, sign, levels, barrier);
  for (const Vec3& s : seeds) flood.start(s);
  return flood.run(mostVoxels);
}

}  // namespace handlebody
