#include "ui/view/wall_surfaces.h"

#include "ui/view/wall_shapes.h"

namespace handlebody::ui {

void WallSurfaces::request(const WallList& walls, const Grid& grid) {
  int number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = ++asked_;
    made_.reset();
    if (walls.empty()) made_.emplace();
  }
  if (walls.empty()) return;
  if (!background_) background_ = std::make_unique<Background>();
  background_->postInstead([this, walls, grid, number] {
    TriangleSoup made = shapesOf(walls, grid);
    {
      const std::lock_guard lock(mutex_);
      if (number != asked_) return;
      made_ = std::move(made);
    }
    ready_();
  });
}

std::optional<TriangleSoup> WallSurfaces::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(made_, std::nullopt);
}

void WallSurfaces::finish() {
  if (background_) background_->finish();
}

}  // namespace handlebody::ui
