#pragma once
// Iterations ↔ pixels: the same for the plot and the slider under it, so that they line up.

#include <algorithm>
#include <cmath>

namespace handlebody::ui {

struct TimelineAxis {
  static constexpr int kMargin = 12;  //!< pixels left and right of the first and last iteration

  int width = 0;  //!< of the widget, pixels
  int last = 0;   //!< last iteration

  double toX(int iteration) const {
    return kMargin + (last > 0 ? double(iteration) / last : 0.0) * (width - 2 * kMargin);
  }
  int toIteration(double x) const {
    const double share = (x - kMargin) / std::max(1, width - 2 * kMargin);
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * last));
  }
};

}  // namespace handlebody::ui
