#include "core/volume/smoothed_volume.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/volume/not_a_number.h"

namespace handlebody {

namespace {

constexpr double kCutOff =
    3.0;  // radius of the kernel in standard deviations: 0.3 % of the weight is left out
constexpr double kNoSmoothing =
    0.2;  // narrower kernels than this many voxels change nothing (weight of a neighbour < 4e-6)

std::vector<float> gaussian(double sigmaVoxels) {
  if (sigmaVoxels < kNoSmoothing) return {1.0f};
  const int radius = std::max(1, static_cast<int>(std::ceil(kCutOff * sigmaVoxels)));
  std::vector<double> w(idx(radius) + 1);
  double sum = 0;
  for (int i = 0; i <= radius; ++i) {
    w[i] = std::exp(-0.5 * i * i / (sigmaVoxels * sigmaVoxels));
    sum += i == 0 ? w[0] : 2 * w[i];
  }
  std::vector<float> out;
  for (double x : w) out.push_back(static_cast<float>(x / sum));
  return out;
}

//! out[i] = sum over the kernel of in[i + radius ± t], for lines of a block: `stride` between neighbours
//! along the axis.
void convolve(const float* in, float* out, const std::vector<float>& w, int outCount, int lineStride,
              int lines) {
  const int radius = static_cast<int>(w.size()) - 1;
  for (int i = 0; i < outCount; ++i) {
    const float* centre = in + static_cast<std::ptrdiff_t>(i + radius) * lineStride;
    float* target = out + static_cast<std::ptrdiff_t>(i) * lineStride;
    for (int l = 0; l < lines; ++l) target[l] = w[0] * centre[l];
    for (int t = 1; t <= radius; ++t) {
      const float* before = centre - static_cast<std::ptrdiff_t>(t) * lineStride;
      const float* after = centre + static_cast<std::ptrdiff_t>(t) * lineStride;
      const float weight = w[t];
      for (int l = 0; l < lines; ++l) target[l] += weight * (before[l] + after[l]);
    }
  }
}

//! Along x, where neighbours lie side by side.
void convolveRow(const float* in, float* out, const std::vector<float>& w, int outCount) {
  const int radius = static_cast<int>(w.size()) - 1;
  for (int i = 0; i < outCount; ++i) out[i] = w[0] * in[i + radius];
  for (int t = 1; t <= radius; ++t)
    for (int i = 0; i < outCount; ++i) out[i] += w[t] * (in[i + radius - t] + in[i + radius + t]);
}

//! In single precision, so that sums of neighbours stay finite: readers leave no voxel beyond kLargestVoxel,
//! but volumes also come from elsewhere. NaN becomes the least.
template <typename T>
float singleOf(T voxel) {
  if constexpr (std::is_floating_point_v<T>) {
    constexpr T kMax = static_cast<T>(kLargestVoxel);
    return static_cast<float>(std::min(std::max(-kMax, voxel), kMax));
  } else {
    return static_cast<float>(voxel);
  }
}

}  // namespace

SmoothedVolume::SmoothedVolume(Volume volume, double sigma, std::shared_ptr<const FieldOfView> view,
                               double wall)
    : volume_(std::move(volume)), sigma_(sigma), view_(std::move(view)), wall_(static_cast<float>(wall)) {
  std::size_t count = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    kernels_[a].weights = gaussian(sigma / grid().spacing[static_cast<int>(a)]);
    bricks_[a] = (grid().size[a] + kBrick - 1) / kBrick;
    count *= idx(bricks_[a]);
  }
  table_ = std::vector<std::atomic<float*>>(count);
}

SmoothedVolume::~SmoothedVolume() {
  for (auto& b : table_) delete[] b.load();
}

const float* SmoothedVolume::make(std::size_t slot) const {
  const std::lock_guard<std::mutex> lock(making_);
  std::atomic<float*>& place = table_[slot];
  if (const float* ready = place.load(std::memory_order_acquire)) return ready;
  giveUpIfCancelled();
  const int at = static_cast<int>(slot), nx = bricks_[0], ny = bricks_[1];
  float* made = makeBrick({at % nx * kBrick, at / nx % ny * kBrick, at / (nx * ny) * kBrick}).release();
  place.store(made, std::memory_order_release);
  made_.fetch_add(1, std::memory_order_relaxed);
  return made;
}

//! Voxels from `from` on, of a row of the grid; beyond the border the border's values repeat.
template <typename T>
void SmoothedVolume::readRow(const T* voxels, std::size_t row, int from, int count, float* out) const {
  const int low = std::max(0, from), high = std::min(grid().size[0], from + count);
  for (int i = low; i < high; ++i) out[i - from] = singleOf(voxels[row + idx(i)]);
  if (view_)
    for (int i = low; i < high; ++i)
      if (isPadding(row + idx(i))) out[i - from] = wall_;
  std::fill(out, out + (low - from), out[low - from]);
  std::fill(out + (high - from), out + count, out[high - 1 - from]);
}

std::unique_ptr<float[]> SmoothedVolume::makeBrick(const std::array<int, 3>& first) const {
  const std::array<int, 3> radius{kernels_[0].radius(), kernels_[1].radius(), kernels_[2].radius()};
  const std::array<int, 3> n{kStored + 2 * radius[0], kStored + 2 * radius[1], kStored + 2 * radius[2]};
  std::vector<float>& raw = scratch_.raw;
  std::vector<float>& alongZ = scratch_.alongZ;
  std::vector<float>& alongY = scratch_.alongY;
  raw.resize(idx(n[0]) * idx(n[1]) * idx(n[2]));  // with a halo of the kernel's radius
  alongZ.resize(idx(n[0]) * idx(n[1]) * idx(kStored));
  alongY.resize(idx(n[0]) * idx(kStored) * idx(kStored));
  const auto inGrid = [&](int i, std::size_t a) { return idx(std::clamp(i, 0, grid().size[a] - 1)); };
  visitVoxels(volume_, [&](const auto* voxels) {
    float* row = raw.data();
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j, row += n[0])
        readRow(voxels,
                (inGrid(first[2] + k - radius[2], 2) * idx(grid().size[1]) +
                 inGrid(first[1] + j - radius[1], 1)) *
                    idx(grid().size[0]),
                first[0] - radius[0], n[0], row);
  });
  convolve(raw.data(), alongZ.data(), kernels_[2].weights, kStored, n[0] * n[1], n[0] * n[1]);
  for (int k = 0; k < kStored; ++k)
    convolve(&alongZ[idx(k) * idx(n[0] * n[1])], &alongY[idx(k) * idx(n[0] * kStored)], kernels_[1].weights,
             kStored, n[0], n[0]);
  auto out = std::make_unique_for_overwrite<float[]>(idx(kStored) * idx(kStored) * idx(kStored));
  for (int row = 0; row < kStored * kStored; ++row)
    convolveRow(&alongY[idx(row) * idx(n[0])], &out[idx(row) * idx(kStored)], kernels_[0].weights, kStored);
  return out;
}

float SmoothedVolume::at(int i, int j, int k) const {
  const float* b = brick(i >> kBrickShift, j >> kBrickShift, k >> kBrickShift);
  const int mask = kBrick - 1;
  return b[((k & mask) * kStored + (j & mask)) * kStored + (i & mask)];
}

SmoothedVolume::Cell SmoothedVolume::cellOf(const Vec3& index) const {
  std::array<int, 3> cell;
  Cell out;
  for (std::size_t a = 0; a < 3; ++a) {
    // In this order a coordinate that is not a number becomes 0.
    const double x = std::min(std::max(0.0, index[static_cast<int>(a)]), grid().size[a] - 1.0);
    cell[a] = std::min(static_cast<int>(x), std::max(0, grid().size[a] - 2));
    out.fraction[a] = x - cell[a];
  }
  const int mask = kBrick - 1;
  out.brick = slotOf(cell[0] >> kBrickShift, cell[1] >> kBrickShift, cell[2] >> kBrickShift);
  out.first = idx(((cell[2] & mask) * kStored + (cell[1] & mask)) * kStored + (cell[0] & mask));
  return out;
}

void SmoothedVolume::prefetch(const Vec3& index) const {
  const Cell cell = cellOf(index);
  const float* brick = table_[cell.brick].load(std::memory_order_acquire);
  if (!brick) return;
  for (const int row : {0, kStored, kStored * kStored, kStored * (kStored + 1)})
    __builtin_prefetch(brick + cell.first + row);
}

double SmoothedVolume::sample(const Vec3& index) const {
  const Cell cell = cellOf(index);
  const std::array<double, 3>& t = cell.fraction;
  const float* p = brick(cell.brick) + cell.first;
  const auto along = [](double a, double c, double s) { return a + s * (c - a); };
  const double c00 = along(p[0], p[1], t[0]), c10 = along(p[kStored], p[kStored + 1], t[0]);
  const float* q = p + idx(kStored) * idx(kStored);
  const double c01 = along(q[0], q[1], t[0]), c11 = along(q[kStored], q[kStored + 1], t[0]);
  return along(along(c00, c10, t[1]), along(c01, c11, t[1]), t[2]);
}

}  // namespace handlebody
