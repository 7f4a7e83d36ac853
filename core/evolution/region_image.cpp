#include "core/evolution/region_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "core/evolution/region_levels.h"

namespace handlebody {

namespace {

// An edge of half a step of so many standard deviations of the noise is trusted for a whole cell.
constexpr double kTrusted = 2;
// Of a region that is given, for half a cell. 36 labels of real volumes with surfaces a voxel and a half off
// (root mean square; Dice .910) end at .897 with it, at .891 with a whole cell, at .893 with none.
constexpr double kTrustedBesideGiven = 0.5;
constexpr double kNextTo = 1.5;  // cells: a boundary that is that near to the region's surface is its own
// Standard deviations that are tried, in voxels, and the part of the half-step that noise may be.
constexpr std::array<double, 6> kSigmas{0.5, 0.7, 1.0, 1.3, 1.6, 2.0};
constexpr double kNoiseAllowed = 0.15;

//! The least smoothing that is enough for white noise.
double smoothingFor(double noise, double halfStep) {
  for (const double sigma : kSigmas) {
    const double left = noise / std::sqrt(8 * std::pow(std::numbers::pi, 1.5) * sigma * sigma * sigma);
    if (std::min(noise, left) <= kNoiseAllowed * halfStep) return sigma;
  }
  return kSigmas.back();
}

//! The volume as the model compares intensities; itself where it takes them as they are.
Volume onScale(const Volume& volume, const IntensityScale& scale) {
  if (!scale.isLogarithmic()) return volume;
  void* buffer = nullptr;
  Volume out = makeVolume(volume.grid, VoxelType::float32, &buffer);
  visitVoxels(volume, [&](const auto* in) {
    std::transform(in, in + volume.grid.voxelCount(), static_cast<float*>(buffer),
                   [&](auto v) { return static_cast<float>(scale.to(static_cast<double>(v))); });
  });
  return out;
}

//! A region as limits, from the edges on its surface.
struct Edges {
  RegionLimits limits;
  double halfStep;  // intensities
};

Edges edgesOf(const ObjectModel& model, const KnownLevel& known = {}) {
  const RegionLevels levels = levelsOn(*model.work, model.region, model.work->cells().grid, known);
  const double halfStep = levels.halfStep > 0 ? levels.halfStep : model.noise;
  const CellGrid& cells = model.work->cells();
  const double cell = cells.grid.meanSpacing();
  // A star-shaped region was chosen because the image around it leads astray: its own surface counts.
  const double most = model.isStar ? 0 : model.isGiven ? kTrustedBesideGiven : 1;
  // Without a step nothing is an edge, and without noise any step is one.
  const double trust = halfStep > 0 ? most * std::min(1.0, halfStep / (kTrusted * model.noise)) : 0;
  return {{std::make_shared<RegionField>(*model.work, model.region), cells.grid, levels.low, levels.high,
           levels.side, trust * cell, cell, false, model.clicks},
          halfStep};
}

}  // namespace

std::shared_ptr<const ObjectImage> imageOfRegion(const Volume& volume, const ObjectModel& model,
                                                 std::optional<double> smoothing,
                                                 std::shared_ptr<const FieldOfView> view) {
  Edges edges = edgesOf(model);
  const double voxel = volume.grid.meanSpacing();
  const double sigma = smoothing.value_or(smoothingFor(model.noise, edges.halfStep) * voxel);
  return std::make_shared<ObjectImage>(
      std::make_shared<SmoothedVolume>(onScale(volume, model.scale), sigma), std::move(edges.limits),
      std::max(edges.halfStep, 1e-6 * std::abs(model.level)), std::move(view));
}

std::shared_ptr<const ObjectImage> imageOfBoundary(const ObjectChoice& choice, const ObjectModel& model) {
  const Grid& grid = choice.volume->grid();
  const double cell = model.work->cells().grid.meanSpacing();
  RegionLimits region{std::make_shared<RegionField>(*model.work, model.region),
                      grid,
                      choice.levels,
                      choice.levels,
                      std::make_shared<LevelField>(grid, choice.object == ObjectKind::dark ? 1 : -1),
                      kNextTo * cell,
                      cell,
                      true};
  return std::make_shared<ObjectImage>(choice.volume, std::move(region), choice.contrast, choice.view);
}

std::shared_ptr<const ObjectImage> imageOfCorrected(std::shared_ptr<const ObjectImage> before,
                                                    const ObjectModel& model) {
  Region changes = model.region;
  std::transform(changes.inside.begin(), changes.inside.end(), model.start.inside.begin(),
                 changes.inside.begin(), std::not_equal_to<>());
  if (changes.count() == 0) return before;
  // The half-way level of all edges around may be far from that which the surface follows: in coarse voxels
  // it would jump all around a click.
  const RegionField start(*model.work, model.start);
  const double cell = model.work->cells().grid.meanSpacing();
  Edges edges = edgesOf(model, [&](const Vec3& world, bool rises) -> std::optional<double> {
    const ObjectImage::Limits limits = before->read(world).limits;
    const double level = rises ? limits.high : limits.low;
    if (!std::isfinite(level) || std::abs(start.at(world)) >= cell) return {};
    return level;
  });
  return std::make_shared<ObjectImage>(std::move(before), RegionField(*model.work, changes),
                                       std::move(edges.limits));
}

RegionInCells shownCells(const ObjectImage& image, const ObjectModel& model) {
  const CellGrid& cells = model.work->cells();
  RegionInCells out{cells, {std::vector<std::uint8_t>(cells.count(), 0)}};
  constexpr int kMargin = 2;  // cells: further out there is none
  forBox(boxOf(cells, model.region).grown(kMargin, cells.grid.size), [&](const std::array<int, 3>& c) {
    out.region.inside[cells.at(c)] = image.inside(cells.grid.toWorld(Vec3(c[0], c[1], c[2]))) > 0;
  });
  return out;
}

}  // namespace handlebody
