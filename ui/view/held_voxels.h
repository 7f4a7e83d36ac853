#pragma once
// Internal: which voxels of a slice lie in an object, found on a thread of its own.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/volume/anatomy.h"
#include "ui/model/newest_result.h"

namespace handlebody::ui {

//! Calls come from one thread.
class HeldVoxels {
 public:
  //! One value per voxel, 1 = in the object; across fastest.
  using Mask = std::vector<std::uint8_t>;

  //! `ready` is called on the worker's thread when what was asked for last is there.
  explicit HeldVoxels(std::function<void()> ready) : mask_(std::move(ready)) {}

  //! Of a slice of the object's grid, at a voxel index along the normal axis. Null while it is being found.
  std::shared_ptr<const Mask> of(const std::shared_ptr<const ObjectImage>& object, const SliceAxes& axes,
                                 int slice);
  //! Lets go of all.
  void forget();
  //! Waits until what was asked for is there.
  void finish() { mask_.finish(); }

 private:
  struct Key {
    std::shared_ptr<const ObjectImage> object;
    int normal = -1, slice = -1;
    bool operator==(const Key&) const = default;
  };

  Key asked_;
  NewestResult<Mask> mask_;
};

}  // namespace handlebody::ui
