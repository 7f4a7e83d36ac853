#include "core/evolution/seed_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/volume/intensity_statistics.h"

namespace handlebody {

std::vector<double> valuesNear(const SmoothedVolume& volume, const std::vector<Seed>& seeds, double radius) {
  const Grid& grid = volume.grid();
  std::vector<double> values;
  for (const Seed& seed : seeds) {
    const Vec3 centre = grid.toIndex(seed.centre);
    std::array<int, 3> low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      const double reach = radius / grid.spacing[static_cast<int>(a)];
      low[a] = std::max(0, static_cast<int>(std::ceil(centre[static_cast<int>(a)] - reach)));
      high[a] = std::min(grid.size[a] - 1, static_cast<int>(std::floor(centre[static_cast<int>(a)] + reach)));
    }
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int i = low[0]; i <= high[0]; ++i)
          if ((grid.toWorld(Vec3(i, j, k)) - seed.centre).norm() <= radius)
            values.push_back(static_cast<double>(volume.at(i, j, k)));
    values.push_back(volume.sample(centre));
  }
  return values;
}

double robustDeviation(std::vector<double> values) {
  const double middle = quantile(values, 0.5);
  for (double& v : values) v = std::abs(v - middle);
  return 1.4826 * quantile(values, 0.5);
}

double noiseEdge(const SmoothedVolume& volume, const std::vector<Seed>& seeds, double radius) {
  const Grid& grid = volume.grid();
  double s1 = 0, s2 = 0;
  for (const Seed& seed : seeds) {
    const Vec3 centre = grid.toIndex(seed.centre);
    const Vec3 reach = Vec3::Constant(radius).cwiseQuotient(grid.spacing);
    for (double k = std::ceil(centre[2] - reach[2]); k <= centre[2] + reach[2]; ++k)
      for (double j = std::ceil(centre[1] - reach[1]); j <= centre[1] + reach[1]; ++j)
        for (double i = std::ceil(centre[0] - reach[0]); i <= centre[0] + reach[0]; ++i) {
          const Vec3 index(i, j, k);
          if (!grid.contains(index) || (grid.toWorld(index) - seed.centre).norm() > radius) continue;
          Vec3 gradient;
          for (int a = 0; a < 3; ++a)
            gradient[a] = (volume.sample(index + Vec3::Unit(a)) - volume.sample(index - Vec3::Unit(a))) /
                          (2 * grid.spacing[a]);
          s1 += gradient.norm();
          s2 += gradient.squaredNorm();
        }
  }
  return s1 > 0 ? s2 / s1 : 0;
}

double statisticsRadius(const Grid& grid, const std::vector<Seed>& seeds) {
  double radius = 3 * grid.meanSpacing();
  for (const Seed& s : seeds)
    if (s.radius) radius = std::min(radius, *s.radius);
  return radius;
}

}  // namespace handlebody
