#pragma once
// The volume as the evolution sees it: smoothed by a Gaussian, once, in bricks, and only where something
// asks.

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "core/volume/field_of_view.h"
#include "core/volume/volume.h"

namespace handlebody {

//! Smoothed voxel values with trilinear sampling. Bricks are made when first needed; any number of threads
//! may sample at once, and the values do not depend on who asks first. Memory is that of the bricks touched
//! (4 bytes a voxel), and a megabyte to make them with.
class SmoothedVolume {
 public:
  //! `sigma`: standard deviation of the Gaussian in mm, >= 0; the same in all directions of space.
  //! Padding of `view` (may be null) counts as `wall`, in intensity units.
  SmoothedVolume(Volume volume, double sigma, std::shared_ptr<const FieldOfView> view = nullptr,
                 double wall = 0);
  ~SmoothedVolume();

  const Grid& grid() const { return volume_.grid; }
  bool hasPadding() const { return view_ != nullptr; }
  bool isPadding(std::size_t voxel) const { return view_ && view_->isPadding(voxel); }
  double sigma() const { return sigma_; }
  //! Bricks of the whole volume, and those made so far.
  std::size_t brickCount() const { return table_.size(); }
  std::size_t bricksMade() const { return made_.load(std::memory_order_relaxed); }
  //! Smoothed value at a voxel of the grid.
  float at(int i, int j, int k) const;
  //! Trilinear value at a continuous index; indices outside are moved to the nearest voxel of the border.
  double sample(const Vec3& index) const;
  //! Has the voxels that sample(index) reads fetched from memory meanwhile, if their brick has been made.
  void prefetch(const Vec3& index) const;

  // --- for walks over many voxels: brick (bi,bj,bk) holds the voxels from kBrick·(bi,bj,bk) on ---
  static constexpr int kBrickShift = 5;
  static constexpr int kBrick = 1 << kBrickShift;  //!< voxels that belong to a brick, per axis
  //! Voxels stored: one more layer, so that trilinear sampling stays inside one brick.
  static constexpr int kStored = kBrick + 1;
  //! Bricks along each axis.
  const std::array<int, 3>& bricks() const { return bricks_; }
  //! kStored³ smoothed values, x fastest. Beyond the grid they are those of its border.
  const float* brick(int bi, int bj, int bk) const { return brick(slotOf(bi, bj, bk)); }

 private:
  struct Kernel {
    std::vector<float> weights;  // radius + 1 values, the centre first
    int radius() const { return static_cast<int>(weights.size()) - 1; }
  };
  //! Place of a continuous index: its brick, the cell's first voxel in it, and the fraction in the cell.
  struct Cell {
    std::size_t brick;
    std::size_t first;
    std::array<double, 3> fraction;
  };
  Cell cellOf(const Vec3& index) const;
  std::size_t slotOf(int bi, int bj, int bk) const {
    return (static_cast<std::size_t>(bk) * static_cast<std::size_t>(bricks_[1]) +
            static_cast<std::size_t>(bj)) *
               static_cast<std::size_t>(bricks_[0]) +
           static_cast<std::size_t>(bi);
  }
  const float* brick(std::size_t slot) const {
    const float* ready = table_[slot].load(std::memory_order_acquire);
    return ready ? ready : make(slot);
  }
  //! What is between the voxels and a brick; kept from one brick to the next.
  struct Scratch {
    std::vector<float> raw, alongZ, alongY;
  };
  const float* make(std::size_t slot) const;
  std::unique_ptr<float[]> makeBrick(const std::array<int, 3>& first) const;
  template <typename T>
  void readRow(const T* voxels, std::size_t row, int from, int count, float* out) const;

  Volume volume_;
  double sigma_;
  std::shared_ptr<const FieldOfView> view_;
  float wall_;
  std::array<Kernel, 3> kernels_;
  std::array<int, 3> bricks_;
  mutable std::vector<std::atomic<float*>> table_;
  mutable std::atomic<std::size_t> made_{0};
  mutable std::mutex making_;
  mutable Scratch scratch_;  // guarded by making_
};

}  // namespace handlebody
