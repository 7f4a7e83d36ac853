#include "core/solid/blurred_mask.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/cancellation.h"
#include "core/indices.h"

namespace handlebody {

namespace {

//! From the middle on; sums up to 1 with its mirror image.
std::vector<float> kernel(double sigma) {
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  std::vector<float> weights;
  double sum = 0;
  for (int i = 0; i <= reach; ++i) {
    const double w = std::exp(-0.5 * i * i / (sigma * sigma));
    weights.push_back(static_cast<float>(w));
    sum += i == 0 ? w : 2 * w;
  }
  for (float& w : weights) w = static_cast<float>(w / sum);
  return weights;
}

//! Along one axis; there is nothing beyond the ends.
void blurAlong(std::vector<float>& values, const std::array<int, 3>& size, std::size_t axis,
               const std::vector<float>& weights) {
  std::size_t stride = 1;
  for (std::size_t a = 0; a < axis; ++a) stride *= idx(size[a]);
  const std::size_t n = idx(size[axis]), block = stride * n;
  std::vector<float> line(n);
  for (std::size_t first = 0; first < values.size(); first += block)
    for (std::size_t at = first; at < first + stride; ++at) {
      giveUpIfCancelled();
      for (std::size_t i = 0; i < n; ++i) line[i] = values[at + i * stride];
      for (std::size_t i = 0; i < n; ++i) {
        float sum = weights[0] * line[i];
        for (std::size_t k = 1; k < weights.size(); ++k) {
          if (i >= k) sum += weights[k] * line[i - k];
          if (i + k < n) sum += weights[k] * line[i + k];
        }
        values[at + i * stride] = sum;
      }
    }
}

}  // namespace

BlurredMask::BlurredMask(const Mask& mask, const Vec3& sigma) {
  for (std::size_t a = 0; a < 3; ++a) {
    margin_[a] = static_cast<int>(std::ceil(3 * sigma[static_cast<Eigen::Index>(a)])) + 2;
    size_[a] = mask.grid.size[a] + 2 * margin_[a];
  }
  values_.assign(idx(size_[0]) * idx(size_[1]) * idx(size_[2]), 0);
  auto voxel = mask.inside.begin();
  for (int z = 0; z < mask.grid.size[2]; ++z)
    for (int y = 0; y < mask.grid.size[1]; ++y)
      for (int x = 0; x < mask.grid.size[0]; ++x)
        values_[(idx(z + margin_[2]) * idx(size_[1]) + idx(y + margin_[1])) * idx(size_[0]) +
                idx(x + margin_[0])] = *voxel++;
  for (std::size_t axis = 0; axis < 3; ++axis)
    blurAlong(values_, size_, axis, kernel(sigma[static_cast<Eigen::Index>(axis)]));
}

double BlurredMask::at(const Vec3& index) const {
  std::array<std::size_t, 3> low{};
  Vec3 part;
  for (int a = 0; a < 3; ++a) {
    const auto i = static_cast<std::size_t>(a);
    const double p = std::clamp(index[a] + margin_[i], 0.0, size_[i] - 1.0);
    const int cell = std::min(static_cast<int>(p), size_[i] - 2);
    low[i] = idx(cell);
    part[a] = p - cell;
  }
  const std::size_t row = idx(size_[0]), plane = row * idx(size_[1]);
  const float* v = &values_[low[2] * plane + low[1] * row + low[0]];
  const auto along = [&](const float* p) { return p[0] + part.x() * (p[1] - p[0]); };
  const double near = along(v) + part.y() * (along(v + row) - along(v));
  const double far = along(v + plane) + part.y() * (along(v + plane + row) - along(v + plane));
  return near + part.z() * (far - near);
}

Vec3 BlurredMask::gradient(const Vec3& index) const {
  Vec3 g;
  for (int a = 0; a < 3; ++a) g[a] = at(index + 0.5 * Vec3::Unit(a)) - at(index - 0.5 * Vec3::Unit(a));
  return g;
}

}  // namespace handlebody
