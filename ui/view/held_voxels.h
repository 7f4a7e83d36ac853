#pragma once
// Internal: which voxels of a slice lie in an object, found on a thread of its own.

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/volume/anatomy.h"
#include "ui/model/background.h"

namespace handlebody::ui {

//! Calls come from one thread.
class HeldVoxels {
 public:
  //! One value per voxel, 1 = in the object; across fastest.
  using Mask = std::vector<std::uint8_t>;

  //! `ready` is called on the worker's thread when what was asked for last is there.
  explicit HeldVoxels(std::function<void()> ready) : ready_(std::move(ready)) {}

  //! Of a slice of the object's grid, at a voxel index along the normal axis. Null while it is being found.
  std::shared_ptr<const Mask> of(const std::shared_ptr<const ObjectImage>& object, const SliceAxes& axes,
                                 int slice);
  //! Lets go of all.
  void forget();
  //! Waits until what was asked for is there.
  void finish();

 private:
  struct Key {
    std::shared_ptr<const ObjectImage> object;
    int normal = -1, slice = -1;
    bool operator==(const Key&) const = default;
  };

  const std::function<void()> ready_;
  std::mutex mutex_;
  Key asked_;
  std::shared_ptr<const Mask> made_;        // of what was asked for
  std::unique_ptr<Background> background_;  // from the first slice on; last: its job uses the others
};

}  // namespace handlebody::ui
