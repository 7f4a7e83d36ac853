#include "core/sensitivity/perturbation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/object/arrival.h"
#include "core/object/policy.h"
#include "core/volume/field_of_view.h"
#include "core/volume/not_a_number.h"

namespace handlebody {

namespace {

double between(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

template <typename T>
T rounded(double value) {
  if constexpr (std::is_integral_v<T>) {
    constexpr double low = std::numeric_limits<T>::lowest(), high = std::numeric_limits<T>::max();
    return static_cast<T>(std::clamp(std::round(value), low, high));
  } else {
    return static_cast<T>(value);
  }
}

Seed moved(Seed seed, const Grid& grid, double voxels, std::mt19937_64& random) {
  Vec3 index = grid.toIndex(seed.centre);
  for (int a = 0; a < 3; ++a)
    index[a] = std::clamp(index[a] + between(-voxels, voxels, random), 0.0, grid.size[a] - 1.0);
  seed.centre = grid.toWorld(index);
  return seed;
}

//! Noise has pushed voxels below the mark of those that were not a number: these become the lowest again, or
//! nobody would know them.
template <typename T>
void markAgain(const T* before, T* noisy, std::size_t count) {
  const std::optional<T> mark = notANumberIn(before, count);
  if (!mark) return;
  if constexpr (std::is_floating_point_v<T>) {
    T least = std::numeric_limits<T>::infinity();
    for (std::size_t v = 0; v < count; ++v)
      if (before[v] != *mark) least = std::min(least, noisy[v]);
    const T below = notANumberBelow(least);
    for (std::size_t v = 0; v < count; ++v)
      if (before[v] == *mark) noisy[v] = below;
  }
}

}  // namespace

double noiseNear(const Volume& volume, const Vec3& place) {
  const ObjectPolicy policy;
  const double reach = policy.nearCells * volume.grid.meanSpacing();
  const CellGrid cells = cellsAround(volume.grid, place, reach, policy.wideCells);
  const std::vector<float> values = makeCells(volume, cells, nullptr).values;
  return noiseAround(cells, values, cells.nearest(place), policy.noiseCells);
}

Volume withNoise(const Volume& volume, double deviation, std::mt19937_64& random) {
  const auto view = FieldOfView::find(volume);
  const std::size_t count = volume.grid.voxelCount();
  void* buffer = nullptr;
  Volume out = makeVolume(volume.grid, volume.type, &buffer);
  std::normal_distribution<double> noise(0, std::max(deviation, std::numeric_limits<double>::min()));
  visitVoxels(volume, [&](const auto* in) {
    using T = std::remove_cvref_t<decltype(*in)>;
    T* to = static_cast<T*>(buffer);
    for (std::size_t v = 0; v < count; ++v)
      to[v] = deviation > 0 && !(view && view->isPadding(v))
                  ? rounded<T>(static_cast<double>(in[v]) + noise(random))
                  : in[v];
    markAgain(in, to, count);
  });
  return out;
}

Request perturbed(const Request& request, const ResolvedParameters& used, const Grid& grid,
                  const Perturbation& by, std::mt19937_64& random) {
  Request out = request;
  for (Seed& seed : out.seeds) seed = moved(seed, grid, by.clickVoxels, random);
  Parameters& p = out.parameters;
  p.threads = 1;
  p.edgeLength = used.edgeLength;
  p.smoothing = used.smoothing * (1 + between(-by.smoothing, by.smoothing, random));
  if (p.range) {
    // A user's range says where the boundary lies, to within the noise.
    p.range->low += by.noise * between(-1, 1, random);
    p.range->high += by.noise * between(-1, 1, random);
    if (p.range->low > p.range->high) p.range = request.parameters.range;
  }
  return out;
}

}  // namespace handlebody
