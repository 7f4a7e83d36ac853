#include "ui/model/wall_look.h"

#include "core/evolution/wall_pieces.h"

namespace handlebody::ui {

namespace {

std::optional<WallConflict> conflictOf(const WallQuestion& question, const Grid& grid, double edge) {
  const Occupied occupied = findOccupied(Mesh(question.shown->mesh), Walls(question.fresh, grid, edge, edge));
  if (occupied.touched.empty() && occupied.enclosed.empty()) return std::nullopt;
  return WallConflict{question.movesBothWays && occupied.enclosed.empty() && occupied.touched.discs.empty()};
}

}  // namespace

void WallLook::ask(const WallQuestion& question, const Grid& grid, double edge, Done done) {
  if (!background_) background_ = std::make_unique<Background>();
  background_->postInstead(
      [question, grid, edge, done = std::move(done)] { done(question, conflictOf(question, grid, edge)); });
}

void WallLook::forget() {
  if (background_) background_->postInstead([] {});
}

}  // namespace handlebody::ui
