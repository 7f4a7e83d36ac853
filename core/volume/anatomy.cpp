#include "core/volume/anatomy.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"

namespace handlebody {
std::array<int, 3> nearestAxes(const Grid& grid) {
  std::array<int, 3> order{0, 1, 2}, best = order;
  double most = -1;
  do {
    double sum = 0;
    for (int w = 0; w < 3; ++w) sum += std::abs(grid.direction(w, order[w]));
    // The margin keeps the first of orders that are equally good, whatever the rounding.
    if (sum > most + 1e-9) {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

bool isOblique(const Grid& grid) {
  const double kOneDegree = std::cos(M_PI / 180);
  const std::array<int, 3> axes = nearestAxes(grid);
  for (int w = 0; w < 3; ++w)
    if (std::abs(grid.direction(w, axes[w])) < kOneDegree) return true;
  return false;
}

char anatomicalLetter(int worldAxis, bool positive) { return (positive ? "LPS" : "RAI")[worldAxis]; }

std::string anatomicalPlace(int worldAxis, double mm) {
  return std::string(1, anatomicalLetter(worldAxis, mm >= 0)) + ' ' + fixedText(std::abs(mm), 1);
}

const char* anatomicalName(AnatomicalPlane plane) {
  return plane == AnatomicalPlane::axial     ? "Axial"
         : plane == AnatomicalPlane::coronal ? "Coronal"
                                             : "Sagittal";
}

double roundLength(double longest) {
  const double decade = std::pow(10.0, std::floor(std::log10(longest)));
  return decade * (longest >= 5 * decade ? 5 : longest >= 2 * decade ? 2 : 1);
}

SliceAxes sliceAxes(const Grid& grid, AnatomicalPlane plane) {
  const std::array<int, 3> axes = nearestAxes(grid);
  const int right = plane == AnatomicalPlane::sagittal ? 1 : 0;
  const int downwards = plane == AnatomicalPlane::axial ? 1 : 2;
  const bool downIsPositive = plane == AnatomicalPlane::axial;
  SliceAxes view;
  view.normal = axes[static_cast<int>(plane)];
  view.across = axes[right];
  view.down = axes[downwards];
  view.acrossSign = grid.direction(right, view.across) < 0 ? -1 : 1;
  view.downSign = (downIsPositive ? 1 : -1) * grid.direction(downwards, view.down) < 0 ? -1 : 1;
  view.left = anatomicalLetter(right, false);
  view.right = anatomicalLetter(right, true);
  view.top = anatomicalLetter(downwards, !downIsPositive);
  view.bottom = anatomicalLetter(downwards, downIsPositive);
  return view;
}

Vec3 obliqueSight() { return Vec3(0.62, -1, 0.55).normalized(); }

}  // namespace handlebody
