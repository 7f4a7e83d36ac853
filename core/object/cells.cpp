#include "core/object/cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/cancellation.h"
#include "core/indices.h"
#include "core/volume/voxel_walk.h"

namespace handlebody {

namespace {

struct Span {
  int low, count;  // voxels
};

Span spanAround(const Grid& volume, int axis, const std::vector<Reach>& boxes) {
  const int n = volume.size[axis];
  int low = n - 1, high = 0;
  for (const Reach& b : boxes) {
    const double centre = volume.toIndex(b.centre)[axis], half = b.reach / volume.spacing[axis];
    low = std::min(low, std::clamp(static_cast<int>(std::floor(centre - half)), 0, n - 1));
    high = std::max(high, std::clamp(static_cast<int>(std::ceil(centre + half)), 0, n - 1));
  }
  return {low, high - low + 1};
}

//! Weights of a Gaussian, the centre first; they sum to 1 over both sides.
std::vector<float> gaussian(double sigma) {
  std::vector<float> w(idx(static_cast<int>(std::ceil(3 * sigma))) + 1);
  double sum = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double x = static_cast<double>(i) / sigma;
    w[i] = static_cast<float>(std::exp(-0.5 * x * x));
    sum += (i == 0 ? 1 : 2) * static_cast<double>(w[i]);
  }
  for (float& x : w) x /= static_cast<float>(sum);
  return w;
}

//! What lies `k` steps either way is added; beyond the ends there is the last one of that side.
void addBeside(const float* before, const float* after, float weight, float* to, std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) to[j] += weight * (before[j] + after[j]);
}

//! Along a row of memory. Each sum is made in the same order as across rows.
void smoothRow(const float* in, float* to, std::size_t n, const std::vector<float>& w) {
  for (std::size_t i = 0; i < n; ++i) to[i] = w[0] * in[i];
  for (std::size_t k = 1; k < w.size(); ++k) {
    const auto single = [&](std::size_t i) {
      to[i] += w[k] * (in[i - std::min(i, k)] + in[std::min(i + k, n - 1)]);
    };
    const std::size_t first = std::min(k, n), last = std::max(first, n - first);
    for (std::size_t i = 0; i < first; ++i) single(i);
    if (last > first) addBeside(in + first - k, in + first + k, w[k], to + first, last - first);
    for (std::size_t i = last; i < n; ++i) single(i);
  }
}

//! Across rows of memory; `block` values lie between neighbours along the axis.
void smoothAcross(const float* in, float* to, std::size_t n, std::size_t block, const std::vector<float>& w) {
  for (std::size_t i = 0; i < n; ++i, to += block) {
    const float* centre = in + i * block;
    for (std::size_t j = 0; j < block; ++j) to[j] = w[0] * centre[j];
    for (std::size_t k = 1; k < w.size(); ++k)
      addBeside(in + (i - std::min(i, k)) * block, in + std::min(i + k, n - 1) * block, w[k], to, block);
  }
}

//! Voxels of each cell along an axis: the last may stand out of the volume.
std::vector<int> widthsAlong(const CellGrid& cells, std::size_t axis, int size) {
  std::vector<int> out;
  for (int i = 0; i < cells.grid.size[axis]; ++i)
    out.push_back(std::min(cells.factor[axis], size - cells.low[axis] - i * cells.factor[axis]));
  return out;
}

//! One voxel after the other, so that the sums do not depend on how the loop is written.
template <typename T>
void addRow(const T* from, const std::vector<int>& widths, float* to) {
  for (const int width : widths) {
    float sum = *to;
    for (int i = 0; i < width; ++i) sum += static_cast<float>(from[i]);
    *to++ = sum;
    from += width;
  }
}

void markPadding(const FieldOfView& view, std::size_t from, const std::vector<int>& widths,
                 std::uint8_t* to) {
  for (const int width : widths) {
    for (int i = 0; i < width; ++i)
      if (view.isPadding(from++)) *to = 1;
    ++to;
  }
}

}  // namespace

std::array<int, 3> CellGrid::nearest(const Vec3& world) const {
  const Vec3 index = grid.toIndex(world);
  std::array<int, 3> cell;
  for (int a = 0; a < 3; ++a)
    cell[a] = std::clamp(static_cast<int>(std::lround(index[a])), 0, grid.size[a] - 1);
  return cell;
}

bool isSame(const CellGrid& a, const CellGrid& b) {
  return a.low == b.low && a.factor == b.factor && a.grid.size == b.grid.size;
}

CellGrid cellsAround(const Grid& volume, const Vec3& centre, double reach, std::size_t most) {
  return cellsAround(volume, {{centre, reach}}, most);
}

CellGrid cellsAround(const Grid& volume, const std::vector<Reach>& boxes, std::size_t most) {
  std::array<Span, 3> spans;
  for (int a = 0; a < 3; ++a) spans[a] = spanAround(volume, a, boxes);
  CellGrid out;
  const auto count = [&] {
    std::size_t n = 1;
    for (int a = 0; a < 3; ++a) n *= idx((spans[a].count + out.factor[a] - 1) / out.factor[a]);
    return n;
  };
  while (count() > most) {
    int finest = 0;
    for (int a = 1; a < 3; ++a)
      if (volume.spacing[a] * out.factor[a] < 0.99 * volume.spacing[finest] * out.factor[finest]) finest = a;
    ++out.factor[finest];
  }
  out.grid = volume;
  Vec3 first;
  for (int a = 0; a < 3; ++a) {
    const auto [low, n] = spans[a];
    const int f = out.factor[a];
    out.low[a] = low;
    out.grid.size[a] = (n + f - 1) / f;
    out.grid.spacing[a] *= f;
    first[a] = low + 0.5 * (f - 1);
    out.goesOn[a] = {low > 0, low + n < volume.size[a]};
  }
  out.grid.origin = volume.toWorld(first);
  return out;
}

CellImage makeCells(const Volume& volume, const CellGrid& cells, const FieldOfView* view) {
  const std::size_t n = cells.count();
  CellImage out{cells, std::vector<float>(n, 0), std::vector<std::uint8_t>(n, 0)};
  const auto& size = volume.grid.size;
  std::array<std::vector<int>, 3> width;  // voxels of each cell, along each axis
  std::array<int, 3> last;
  for (std::size_t a = 0; a < 3; ++a) {
    width[a] = widthsAlong(cells, a, size[a]);
    last[a] = cells.low[a] + std::accumulate(width[a].begin(), width[a].end(), 0);
  }
  visitVoxels(volume, [&](const auto* v) {
    for (int z = cells.low[2]; z < last[2]; ++z) {
      giveUpIfCancelled();
      for (int y = cells.low[1]; y < last[1]; ++y) {
        const std::size_t from = (idx(z) * idx(size[1]) + idx(y)) * idx(size[0]) + idx(cells.low[0]);
        const std::size_t to =
            cells.at(0, (y - cells.low[1]) / cells.factor[1], (z - cells.low[2]) / cells.factor[2]);
        addRow(v + from, width[0], &out.values[to]);
        if (view) markPadding(*view, from, width[0], &out.padding[to]);
      }
    }
  });
  std::size_t c = 0;
  for (const int z : width[2])
    for (const int y : width[1])
      for (const int x : width[0]) out.values[c++] /= static_cast<float>(x * y * z);
  return out;
}

//! The same sum in the same order as `trilinear`, which costs more than twice as much for the values that it
//! must not look at.
double interpolated(const Grid& grid, const std::vector<float>& values, const Vec3& index) {
  std::array<std::size_t, 3> low, step;
  std::array<double, 3> before, after;  // weights
  std::size_t stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const int n = grid.size[a];
    const double x = std::clamp(index[static_cast<int>(a)], 0.0, n - 1.0);
    const int cell = std::max(0, std::min(static_cast<int>(x), n - 2));
    after[a] = x - cell;
    before[a] = 1 - after[a];
    low[a] = idx(cell) * stride;
    step[a] = n > 1 ? stride : 0;
    stride *= idx(n);
  }
  const std::array<double, 4> inPlane{before[0] * before[1], after[0] * before[1], before[0] * after[1],
                                      after[0] * after[1]};
  const float* v = &values[low[0] + low[1] + low[2]];
  double sum = 0;
  for (const double weight : {before[2], after[2]}) {
    sum += inPlane[0] * weight * static_cast<double>(v[0]);
    sum += inPlane[1] * weight * static_cast<double>(v[step[0]]);
    sum += inPlane[2] * weight * static_cast<double>(v[step[1]]);
    sum += inPlane[3] * weight * static_cast<double>(v[step[0] + step[1]]);
    v += step[2];
  }
  return sum;
}

std::vector<float> smoothed(const CellGrid& cells, std::vector<float> values, double sigma) {
  std::vector<float> other(values.size());
  std::size_t block = 1;
  for (int a = 0; a < 3; ++a) {
    const double s = sigma / cells.grid.spacing[a];
    const int n = cells.grid.size[a];
    if (s > 0.15) {  // less is nothing but the centre
      const std::vector<float> w = gaussian(s);
      for (std::size_t from = 0; from < values.size(); from += block * idx(n))
        if (block == 1)
          smoothRow(&values[from], &other[from], idx(n), w);
        else
          smoothAcross(&values[from], &other[from], idx(n), block, w);
      values.swap(other);
    }
    block *= idx(n);
  }
  return values;
}

}  // namespace handlebody
