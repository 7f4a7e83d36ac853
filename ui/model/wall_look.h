#pragma once
// Whether walls that a growth does not know yet lie where its surface is already: on a thread of its own.

#include <functional>
#include <memory>
#include <optional>

#include "core/evolution/constraints.h"
#include "ui/model/background.h"
#include "ui/model/document.h"

namespace handlebody::ui {

struct WallQuestion {
  std::shared_ptr<const MeshSnapshot> shown;
  WallList fresh;  //!< walls that are new to it
  bool movesBothWays = false;
  bool operator==(const WallQuestion&) const = default;
};

//! Calls come from one thread.
class WallLook {
 public:
  using Done = std::function<void(const WallQuestion&, std::optional<WallConflict>)>;

  //! `done` is called on the thread. Of several questions only the newest is sure to be answered. `grid`: the
  //! volume's; `edge`: mm, of the surface.
  void ask(const WallQuestion& question, const Grid& grid, double edge, Done done);
  //! What was asked is not answered, unless that has begun.
  void forget();

 private:
  std::unique_ptr<Background> background_;  // from the first question on
};

}  // namespace handlebody::ui
