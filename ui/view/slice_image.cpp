#include "ui/view/slice_image.h"

#include <algorithm>
#include <cmath>

namespace handlebody::ui {
namespace {

constexpr std::uint32_t kBlack = 0xff000000;
constexpr int kTint[3] = {255, 64, 129};  // pink: in no colour map
constexpr float kTintOpacity = 0.45F;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

//! One line of pixels: the weighted rows of samples added up, over the columns that are needed.
void blendRows(const float* plane, int width, const Resampling& rows, int line, int from, int to,
               float* out) {
  for (int t = 0; t < rows.taps; ++t) {
    const std::size_t tap = at(line * rows.taps + t);
    const float weight = rows.weight[tap];
    const float* row = plane + at(rows.sample[tap]) * at(width);
    if (t == 0)
      for (int x = from; x < to; ++x) out[x] = weight * row[x];
    else if (weight != 0)
      for (int x = from; x < to; ++x) out[x] += weight * row[x];
  }
}

float blendColumns(const Resampling& columns, int pixel, const float* row) {
  const std::size_t first = at(pixel * columns.taps);
  float sum = 0;
  for (std::size_t t = first; t < first + at(columns.taps); ++t)
    sum += columns.weight[t] * row[columns.sample[t]];
  return sum;
}

std::uint32_t tinted(std::uint32_t colour, float share) {
  const float opacity = kTintOpacity * share;
  std::uint32_t result = 0xff;
  for (int c = 0; c < 3; ++c) {
    const float under = static_cast<float>(colour >> (16 - 8 * c) & 0xffU);
    result =
        result << 8 | static_cast<std::uint32_t>(under + opacity * (static_cast<float>(kTint[c]) - under));
  }
  return result;
}

//! Where a plane of samples lands on the pixels.
struct Layout {
  Resampling columns, rows;
  int from = 0, to = 0;  // samples that the columns need
};

Layout layoutOf(const SliceGeometry& geometry, const QSize& pixels, double pixelRatio, int width,
                int height) {
  const SliceAxes& axes = geometry.axes();
  const double half = 0.5 / pixelRatio;
  const Vec3 first = geometry.toIndex({half, half}), next = geometry.toIndex({3 * half, 3 * half});
  Layout layout;
  layout.columns =
      resampling(pixels.width(), first[axes.across], next[axes.across] - first[axes.across], width);
  layout.rows = resampling(pixels.height(), first[axes.down], next[axes.down] - first[axes.down], height);
  if (!layout.columns.sample.empty()) {
    const auto [low, high] = std::minmax_element(layout.columns.sample.begin(), layout.columns.sample.end());
    layout.from = *low;
    layout.to = *high + 1;
  }
  return layout;
}

template <typename F>
void forEachLine(QImage& image, const Layout& layout, F&& paint) {
  for (int y = layout.rows.begin; y < layout.rows.end; ++y)
    paint(y - layout.rows.begin, reinterpret_cast<std::uint32_t*>(image.scanLine(y)) + layout.columns.begin);
}

//! What is no number has the first colour.
std::size_t entryOf(float value) { return value > 0 ? static_cast<std::size_t>(std::min(value, 255.0F)) : 0; }

void paintIntensities(QImage& image, const Layout& layout, const std::vector<float>& plane, int width,
                      const SliceColours& colours) {
  const ColourTable& table = colourTable(colours.map);
  const auto scale = static_cast<float>(256 / colours.window.window);
  const auto low = static_cast<float>(colours.window.level - colours.window.window / 2);
  std::vector<float> blended(at(width));
  const int pixels = layout.columns.end - layout.columns.begin;
  forEachLine(image, layout, [&](int line, std::uint32_t* out) {
    blendRows(plane.data(), width, layout.rows, line, layout.from, layout.to, blended.data());
    for (int x = 0; x < pixels; ++x) {
      const float intensity = blendColumns(layout.columns, x, blended.data());
      out[x] = table[entryOf((intensity - low) * scale)];
    }
  });
}

//! Shares from 0 to 1.
std::vector<float> inRange(const std::vector<float>& plane, const IntensityRange& range) {
  std::vector<float> mask(plane.size());
  for (std::size_t i = 0; i < plane.size(); ++i)
    mask[i] = plane[i] >= range.low && plane[i] <= range.high ? 1 : 0;
  return mask;
}

void paintTint(QImage& image, const Layout& layout, const std::vector<float>& mask, int width) {
  std::vector<float> blended(at(width));
  const int pixels = layout.columns.end - layout.columns.begin;
  forEachLine(image, layout, [&](int line, std::uint32_t* out) {
    blendRows(mask.data(), width, layout.rows, line, layout.from, layout.to, blended.data());
    for (int x = 0; x < pixels; ++x) {
      const float share = blendColumns(layout.columns, x, blended.data());
      if (share > 0) out[x] = tinted(out[x], share);
    }
  });
}

}  // namespace

Resampling resampling(int pixels, double first, double step, int samples) {
  Resampling result;
  const auto inside = [&](int p) {
    const double index = first + p * step;
    return index >= -0.5 && index <= samples - 0.5;
  };
  while (result.begin < pixels && !inside(result.begin)) ++result.begin;
  result.end = result.begin;
  while (result.end < pixels && inside(result.end)) ++result.end;
  const double reach = std::max(1.0, std::abs(step));
  result.taps = static_cast<int>(std::ceil(2 * reach));
  for (int p = result.begin; p < result.end; ++p) {
    const double index = std::clamp(first + p * step, 0.0, samples - 1.0);
    const int lowest = static_cast<int>(std::floor(index - reach)) + 1;
    double sum = 0;
    for (int s = lowest; s < lowest + result.taps; ++s) sum += std::max(0.0, 1 - std::abs(s - index) / reach);
    for (int s = lowest; s < lowest + result.taps; ++s) {
      result.sample.push_back(std::clamp(s, 0, samples - 1));
      result.weight.push_back(static_cast<float>(std::max(0.0, 1 - std::abs(s - index) / reach) / sum));
    }
  }
  return result;
}

void SliceImage::gather(const Volume& volume, const SliceGeometry& geometry) {
  const SliceAxes& axes = geometry.axes();
  if (gatheredFrom_ == volume.voxels && normal_ == axes.normal && slice_ == geometry.slice()) return;
  const Grid& grid = volume.grid;
  const std::size_t strides[3] = {1, at(grid.size[0]), at(grid.size[0]) * at(grid.size[1])};
  const std::size_t across = strides[axes.across], down = strides[axes.down];
  width_ = grid.size[axes.across];
  height_ = grid.size[axes.down];
  plane_.resize(at(width_) * at(height_));
  visitVoxels(volume, [&](const auto* voxels) {
    const auto* start = voxels + at(geometry.slice()) * strides[axes.normal];
    // Along memory in the inner loop, whichever way the slice lies.
    const bool rowsFirst = across < down;
    for (int outer = 0; outer < (rowsFirst ? height_ : width_); ++outer) {
      const auto* from = start + at(outer) * (rowsFirst ? down : across);
      float* to = plane_.data() + at(outer) * (rowsFirst ? at(width_) : 1);
      const std::size_t step = rowsFirst ? across : down, toStep = rowsFirst ? 1 : at(width_);
      const int count = rowsFirst ? width_ : height_;
      for (int i = 0; i < count; ++i) to[at(i) * toStep] = static_cast<float>(from[at(i) * step]);
    }
  });
  gatheredFrom_ = volume.voxels;
  normal_ = axes.normal;
  slice_ = geometry.slice();
}

const QImage& SliceImage::render(const Volume& volume, const SliceGeometry& geometry, double pixelRatio,
                                 const SliceColours& colours) {
  const QSize size = (geometry.size() * pixelRatio).toSize();
  if (image_.size() != size) image_ = QImage(size, QImage::Format_RGB32);
  image_.setDevicePixelRatio(pixelRatio);
  image_.fill(kBlack);
  if (size.isEmpty()) return image_;
  gather(volume, geometry);
  const Layout layout = layoutOf(geometry, size, pixelRatio, width_, height_);
  paintIntensities(image_, layout, plane_, width_, colours);
  if (colours.tint) paintTint(image_, layout, inRange(plane_, *colours.tint), width_);
  if (colours.tinted && colours.tinted->size() == plane_.size())
    paintTint(image_, layout, {colours.tinted->begin(), colours.tinted->end()}, width_);
  return image_;
}

}  // namespace handlebody::ui
