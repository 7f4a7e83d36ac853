#include "tests/bench/clicks/click_peers.h"

#include <itkConfidenceConnectedImageFilter.h>
#include <itkCurvatureFlowImageFilter.h>
#include <itkImage.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/indices.h"

namespace handlebody::bench {

namespace {

using Image = itk::Image<float, 3>;
using Labels = itk::Image<std::uint8_t, 3>;
using Cell = std::array<int, 3>;
std::size_t at(const Grid& g, const Cell& c) {
  return (idx(c[2]) * idx(g.size[1]) + idx(c[1])) * idx(g.size[0]) + idx(c[0]);
}

Cell voxelOf(const Grid& g, const Vec3& place) {
  const Vec3 index = g.toIndex(place);
  Cell out{};
  for (std::size_t a = 0; a < 3; ++a)
    out[a] = std::clamp(static_cast<int>(std::lround(index[static_cast<Eigen::Index>(a)])), 0, g.size[a] - 1);
  return out;
}

std::vector<float> valuesOf(const Volume& volume) {
  std::vector<float> out(volume.grid.voxelCount());
  visitVoxels(volume, [&](const auto* values) {
    std::transform(values, values + out.size(), out.begin(), [](auto v) { return static_cast<float>(v); });
  });
  return out;
}

//! The 3x3x3 voxels of a click that lie in the volume.
template <typename F>
void forVoxelsOf(const Grid& g, const UserClick& click, F&& f) {
  const Cell c = voxelOf(g, click.place);
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const Cell n{c[0] + x, c[1] + y, c[2] + z};
        bool holds = true;
        for (std::size_t a = 0; a < 3; ++a) holds = holds && n[a] >= 0 && n[a] < g.size[a];
        if (holds) f(at(g, n));
      }
}

}  // namespace

Mask confidenceConnected(const Volume& volume, const std::vector<UserClick>& clicks) {
  const Grid& g = volume.grid;
  auto image = Image::New();
  Image::SizeType size;
  Image::SpacingType spacing;
  for (unsigned a = 0; a < 3; ++a) {
    size[a] = static_cast<itk::SizeValueType>(g.size[a]);
    spacing[a] = g.spacing[a];
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->Allocate();
  const std::vector<float> values = valuesOf(volume);
  std::copy(values.begin(), values.end(), image->GetBufferPointer());
  auto flow = itk::CurvatureFlowImageFilter<Image, Image>::New();
  flow->SetInput(image);
  flow->SetNumberOfIterations(5);
  flow->SetTimeStep(0.125);
  flow->SetNumberOfWorkUnits(1);
  auto grow = itk::ConfidenceConnectedImageFilter<Image, Labels>::New();
  grow->SetInput(flow->GetOutput());
  grow->SetMultiplier(2.5);
  grow->SetNumberOfIterations(5);
  grow->SetInitialNeighborhoodRadius(2);
  grow->SetReplaceValue(1);
  for (const UserClick& c : clicks) {
    if (!c.isInside) continue;
    const Cell v = voxelOf(g, c.place);
    grow->AddSeed({{v[0], v[1], v[2]}});
  }
  grow->Update();
  const std::uint8_t* out = grow->GetOutput()->GetBufferPointer();
  return {out, out + g.voxelCount()};
}

Mask growFromSeeds(const Volume& volume, const std::vector<UserClick>& clicks) {
  const Grid& g = volume.grid;
  const std::vector<float> values = valuesOf(volume);
  std::vector<float> length(values.size(), std::numeric_limits<float>::infinity());
  Mask label(values.size());
  using Entry = std::pair<float, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto start = [&](std::size_t v, bool isInside) {
    length[v] = 0;
    label[v] = isInside;
    queue.push({0, v});
  };
  bool hasBackground = false;
  for (const UserClick& c : clicks) {
    forVoxelsOf(g, c, [&](std::size_t v) { start(v, c.isInside); });
    hasBackground = hasBackground || !c.isInside;
  }
  const auto cellOf = [&](std::size_t i) {
    const std::size_t nx = idx(g.size[0]), ny = idx(g.size[1]);
    return Cell{static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / (nx * ny))};
  };
  for (std::size_t i = 0; !hasBackground && i < values.size(); ++i) {
    const Cell c = cellOf(i);
    for (std::size_t a = 0; a < 3; ++a)
      if ((c[a] == 0 || c[a] == g.size[a] - 1) && length[i] > 0) start(i, false);
  }
  while (!queue.empty()) {
    const auto [l, i] = queue.top();
    queue.pop();
    if (l > length[i]) continue;
    const Cell c = cellOf(i);
    for (std::size_t a = 0; a < 3; ++a)
      for (const int step : {-1, 1}) {
        Cell n = c;
        n[a] += step;
        if (n[a] < 0 || n[a] >= g.size[a]) continue;
        const std::size_t j = at(g, n);
        const float there = l + std::abs(values[j] - values[i]);
        if (there >= length[j]) continue;
        length[j] = there;
        label[j] = label[i];
        queue.push({there, j});
      }
  }
  return label;
}

}  // namespace handlebody::bench
