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
  const Key key{object, axes.normal, slice};
  {
    const std::lock_guard lock(mutex_);
    if (key == asked_) return made_;
    asked_ = key;
    made_.reset();
  }
  if (!background_) background_ = std::make_unique<Background>();
  background_->postInstead([this, key, axes] {
    auto mask = std::make_shared<const Mask>(heldIn(*key.object, axes, key.slice));
    {
      const std::lock_guard lock(mutex_);
      if (!(key == asked_)) return;
      made_ = std::move(mask);
    }
    ready_();
  });
  return nullptr;
}

void HeldVoxels::forget() {
  const std::lock_guard lock(mutex_);
  asked_ = {};
  made_.reset();
}

void HeldVoxels::finish() {
  if (background_) background_->finish();
}

}  // namespace handlebody::ui
