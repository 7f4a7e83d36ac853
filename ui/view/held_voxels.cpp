#include "ui/view/held_voxels.h"

#include "core/indices.h"

namespace handlebody::ui {

namespace {

HeldVoxels::Mask heldIn(const ObjectImage& object, const SliceAxes& axes, int slice) {
  const Grid& grid = object.volume().grid();
  HeldVoxels::Mask mask;
  mask.reserve(idx(grid.size[axes.across]) * idx(grid.size[axes.down]));
  Vec3 index;
  index[axes.normal] = slice;
  for (int down = 0; down < grid.size[axes.down]; ++down)
    for (int across = 0; across < grid.size[axes.across]; ++across) {
      index[axes.down] = down;
      index[axes.across] = across;
      mask.push_back(object.inside(grid.toWorld(index)) > 0);
    }
  return mask;
}

}  // namespace

std::shared_ptr<const HeldVoxels::Mask> HeldVoxels::of(const std::shared_ptr<const ObjectImage>& object,
                                                       const SliceAxes& axes, int slice) {
  Key key{object, axes.normal, slice};
  if (key == asked_) return mask_.get();
  asked_ = std::move(key);
  mask_.request([object, axes, slice] { return heldIn(*object, axes, slice); });
  return nullptr;
}

void HeldVoxels::forget() {
  asked_ = {};
  mask_.set(nullptr);
}

}  // namespace handlebody::ui
