#pragma once
// Internal: walls as surfaces for the 3D view, made on a thread of their own.

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "core/evolution/constraints.h"
#include "core/mesh/mesh.h"
#include "ui/model/background.h"

namespace handlebody::ui {

//! Calls come from one thread.
class WallSurfaces {
 public:
  //! `ready` is called on the worker's thread when there is something to take.
  explicit WallSurfaces(std::function<void()> ready) : ready_(std::move(ready)) {}

  //! Returns at once; what was asked for before is not answered any more.
  void request(const WallList& walls, const Grid& grid);
  //! What was asked for last, once it is there.
  std::optional<TriangleSoup> take();
  //! Waits until it is.
  void finish();

 private:
  const std::function<void()> ready_;
  std::mutex mutex_;
  int asked_ = 0;
  std::optional<TriangleSoup> made_;
  std::unique_ptr<Background> background_;  // from the first walls on; last: its job uses the others
};

}  // namespace handlebody::ui
