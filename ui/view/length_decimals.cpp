#include "ui/view/length_decimals.h"

#include <algorithm>
#include <cmath>

namespace handlebody::ui {

int lengthDecimals(double voxel) {
  constexpr int kMin = 2, kMax = 8;
  if (!(voxel > 0)) return kMin;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(voxel))), kMin, kMax);
}

int lengthDecimals(const Grid& grid) { return lengthDecimals(grid.spacing.minCoeff()); }

int placeDecimals(const Grid& grid) { return lengthDecimals(grid) - 1; }

}  // namespace handlebody::ui
