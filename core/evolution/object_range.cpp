#include "core/evolution/object_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/evolution/object_boundary.h"
#include "core/evolution/object_image.h"
#include "core/evolution/object_region.h"
#include "core/evolution/region_growth_level.h"
#include "core/evolution/seed_statistics.h"
#include "core/evolution/seeds.h"
#include "core/evolution/word_flood.h"
#include "core/threads.h"
#include "core/told_error.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Standard deviations of the Gaussian that are tried, in voxels (mean spacing).
constexpr std::array<double, 7> kSigmas{0.5, 0.7, 1.0, 1.3, 1.6, 2.0, 2.5};
constexpr double kFirstSigma = 1.0;
// Where the noise hides the boundary at that one, these are tried.
constexpr std::array<double, 2> kSigmasInNoise{1.6, 2.5};
// Noise may be this part of the distance between the object's level and the boundary level. Speckle that the
// smoothing has made a few voxels wide still looks like background here and there at a fifth.
constexpr double kNoiseAllowed = 0.15;
// The noise is measured in balls of up to this many voxels: in smaller ones speckle is hardly more than one
// grain.
constexpr double kNoiseRadius = 8;
// A region of this many times the ball that fits around the seed, that also holds this part of the volume's
// border, may have leaked.
constexpr double kOutOfProportion = 400;
constexpr double kOnBorder = 1e-3;
// White noise falls by at least a third from one of kSigmas to the next; what falls by less than this is
// structure.
constexpr double kStructure = 0.85;
// A dark object is none if a bright one at the same seed has a boundary this many times stronger, and the
// reverse.
constexpr double kWrongKind = 4;
// In pure noise the mean edge is as strong at every level as in the seeds; a boundary must be stronger than
// that.
constexpr double kClearEdge = 1.4;
// An automatic object is the background, too, if more than this part of its surface lies against the padding
// around the image.
constexpr double kFillsView = 2.0 / 3;
// Levels that hold so many times the region on which they were found let it leak.
constexpr double kLeaks = 1.5;
// Parts of the way from the object's level to the half-way levels that are tried as levels to begin with.
constexpr double kParts[] = {1, 0.8, 0.64, 0.51, 0.41, 0.33, 0.26, 0.21, 0.17, 0.13, 0.11};
constexpr std::size_t kViewVoxels = 3'000'000;  // enough of it to tell

using FieldOfViewPointer = std::shared_ptr<const FieldOfView>;
using ImagePointer = std::shared_ptr<const SmoothedVolume>;

//! About 200,000 voxel values, evenly spread.
std::vector<double> sampleVoxels(const Volume& volume) {
  const std::size_t n = volume.grid.voxelCount();
  const std::size_t stride =
      std::max<std::size_t>(1, n / 200'000) | 1;  // odd: does not fall in step with the rows
  std::vector<double> values;
  visitVoxels(volume, [&](const auto* v) {
    for (std::size_t i = 0; i < n; i += stride) values.push_back(static_cast<double>(v[i]));
  });
  return values;
}

//! What the intensities alone say of the object, one level for all places.
struct Intensities {
  ObjectKind object;
  IntensityRange range;
  double level;     // median in the seeds
  double contrast;  // as in ObjectChoice
};

double signOf(ObjectKind kind) { return kind == ObjectKind::dark ? 1 : -1; }

//! All that is darker than the level, or all that is brighter.
IntensityRange rangeTo(ObjectKind kind, double level) {
  return kind == ObjectKind::dark ? IntensityRange{-kInfinity, level} : IntensityRange{level, kInfinity};
}

//! Median in the seeds.
double levelIn(const SmoothedVolume& volume, const std::vector<Seed>& seeds) {
  return quantile(valuesNear(volume, seeds, statisticsRadius(volume.grid(), seeds)), 0.5);
}

std::vector<Vec3> indicesOf(const Grid& grid, const std::vector<Seed>& seeds) {
  std::vector<Vec3> indices;
  for (const Seed& s : seeds) indices.push_back(grid.toIndex(s.centre));
  return indices;
}

FindingKind notInObject(ObjectKind asked) {
  return asked == ObjectKind::bright ? FindingKind::noBrightObject
         : asked == ObjectKind::dark ? FindingKind::noDarkObject
                                     : FindingKind::noObject;
}

void requireVoxelsInRange(const Volume& volume, const IntensityRange& range) {
  if (!(range.low <= range.high)) throw Told<UsageError>(Finding(FindingKind::rangeEmpty));
  bool any = false;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  visitVoxels(volume, [&](const auto* v) {
    for (std::size_t i = 0; i < volume.grid.voxelCount(); ++i) {
      const double x = static_cast<double>(v[i]);
      any = any || (x >= range.low && x <= range.high);
      low = std::min(low, x);
      high = std::max(high, x);
    }
  });
  if (!any)
    throw Told<UsageError>(
        Finding(FindingKind::rangeWithoutVoxels,
                {{"low", range.low}, {"high", range.high}, {"least", low}, {"most", high}}));
}

//! By the median of the nearest voxels: one of them may be noise.
double intensityAt(const SmoothedVolume& volume, const Seed& seed) {
  return quantile(valuesNear(volume, {seed}, 1.5 * volume.grid().meanSpacing()), 0.5);
}

//! The first seed that does not lie in the range; null if all do.
const Seed* seedOutOfRange(const SmoothedVolume& volume, const IntensityRange& range,
                           const std::vector<Seed>& seeds) {
  const auto isOut = [&](const Seed& s) {
    const double value = intensityAt(volume, s);
    return value < range.low || value > range.high;
  };
  const auto found = std::find_if(seeds.begin(), seeds.end(), isOut);
  return found == seeds.end() ? nullptr : &*found;
}

void requireSeedsInRange(const SmoothedVolume& volume, const IntensityRange& range,
                         const std::vector<Seed>& seeds) {
  const Seed* s = seedOutOfRange(volume, range, seeds);
  if (!s) return;
  throw Told<SeedError>(Finding(FindingKind::seedNotInRange, {{"place", placeValue(s->centre)},
                                                              {"intensity", intensityAt(volume, *s)},
                                                              {"low", range.low},
                                                              {"high", range.high}}));
}

//! Radius (mm) of the balls around the seeds in which the noise is measured: as far as the object goes.
double noiseRadius(const std::vector<Seed>& seeds, const ImagePointer& volume, const Intensities& found) {
  const Grid& grid = volume->grid();
  const ObjectImage image(volume, found.range, found.contrast);
  double radius = kNoiseRadius * grid.meanSpacing();
  for (const Seed& s : seeds) radius = std::min(radius, fittingRadius(image, s.centre, radius));
  return std::max(radius, statisticsRadius(grid, seeds));
}

//! The least smoothing that is enough for the noise near the seeds. What more smoothing hardly lessens is
//! structure and not noise: it ends the search too. `image`: the one on which the intensities were found.
double chooseSmoothing(const Volume& volume, const std::vector<Seed>& seeds, const ImagePointer& image,
                       const Intensities& found) {
  const double voxel = volume.grid.meanSpacing();
  const double radius = noiseRadius(seeds, image, found);
  double before = std::numeric_limits<double>::infinity();
  double best = kSigmas.front();
  for (double sigma : kSigmas) {
    const SmoothedVolume smoothed(volume, sigma * voxel);
    const double noise = robustDeviation(valuesNear(smoothed, seeds, radius));
    if (noise > kStructure * before) break;
    best = sigma;
    before = noise;
    if (noise <= kNoiseAllowed * found.contrast) break;
  }
  return best * voxel;
}

//! Padding, unless a seed lies in it.
std::shared_ptr<const FieldOfView> paddingBeside(const Volume& volume, const std::vector<Seed>& seeds) {
  std::shared_ptr<const FieldOfView> view = FieldOfView::find(volume);
  const bool anyInside = view && std::any_of(seeds.begin(), seeds.end(), [&](const Seed& s) {
                           return view->isPaddingNear(volume.grid.toIndex(s.centre));
                         });
  return anyInside ? nullptr : view;
}

//! The image that the surface will see, and where there is none.
struct FinalImage {
  ImagePointer volume;
  FieldOfViewPointer view;
};

//! Padding matters where its value would count as object: there it is given a value as far outside the range
//! as the object lies inside it. Elsewhere it is a background like any other. `made`: an image without
//! padding, which may be the one.
FinalImage finalImage(const Volume& volume, double sigma, const FieldOfViewPointer& view,
                      const Intensities& found, const ImagePointer& made) {
  const IntensityRange& range = found.range;
  const bool needed = view && view->value() >= range.low && view->value() <= range.high;
  const double wall = std::isfinite(range.high) ? range.high + found.contrast : range.low - found.contrast;
  const bool walled = needed && std::isfinite(wall);  // a range without ends holds everything
  if (!walled && made->sigma() == sigma) return {made, view};
  return {std::make_shared<SmoothedVolume>(volume, sigma, walled ? view : nullptr, wall), view};
}

//! Voxels of the largest ball around a seed, of at most kNoiseRadius.
double seedBallVoxels(const ImagePointer& volume, const Intensities& found, const std::vector<Seed>& seeds) {
  const ObjectImage image(volume, found.range, found.contrast);
  const double voxel = volume->grid().meanSpacing();
  double largest = voxel;
  for (const Seed& s : seeds)
    largest = std::max(largest, fittingRadius(image, s.centre, kNoiseRadius * voxel));
  return 4.0 / 3 * std::numbers::pi * std::pow(largest / voxel, 3);
}

//! The boundary place by place, and the contrast that goes with it.
struct PlacedBoundary {
  ObjectBoundary boundary;
  double contrast;
};

//! `grown`: what the growth said about the level in the range.
PlacedBoundary placeBoundary(const FinalImage& image, const Intensities& found,
                             const RegionGrowthLevel& grown, const std::vector<Seed>& seeds) {
  const Grid& grid = image.volume->grid();
  const double end = found.object == ObjectKind::dark ? found.range.high : found.range.low;
  const ObjectSearch search{*image.volume, indicesOf(grid, seeds), signOf(found.object),
                            found.level,   LevelField(grid, end),  grown.voxels};
  if (grown.border > kOnBorder &&
      grown.voxels > kOutOfProportion * seedBallVoxels(image.volume, found, seeds))
    if (auto cut = findBoundaryAtNeck(search)) {
      const double contrast = std::abs(cut->levels.at(search.seeds[0]) - found.level);
      return {*std::move(cut), contrast};
    }
  return {findBoundary(search), found.contrast};
}

//! All of it. The range says what is used: without a gain, given as --range, it leads to the same surface.
ObjectChoice choiceOf(const Intensities& found, const FinalImage& image, PlacedBoundary placed,
                      const Vec3& seed) {
  ObjectChoice choice{found.object, rangeTo(found.object, placed.boundary.levels.at(seed)),
                      found.level,  placed.contrast,
                      image.volume, nullptr,
                      nullptr,      image.view};
  choice.levels = std::make_shared<LevelField>(std::move(placed.boundary.levels));
  if (placed.boundary.neck) choice.neck = std::make_shared<NeckCut>(*std::move(placed.boundary.neck));
  return choice;
}

//! True if levels hold the seeds and hardly more than the start.
bool isTight(const LevelField& levels, const SmoothedVolume& volume, const std::vector<Vec3>& seeds,
             const BoundaryStart& start) {
  const double sign = signOf(start.object);
  const auto isInside = [&](const Vec3& s) { return sign * volume.sample(s) < sign * levels.at(s); };
  if (!std::all_of(seeds.begin(), seeds.end(), isInside)) return false;
  const auto most = static_cast<std::size_t>(kLeaks * start.voxels);
  WordFlood held(volume, seeds, sign, levels);
  return held.run(most) && static_cast<double>(held.count()) * kLeaks >= start.voxels;
}

//! Levels that hold, and what they say of the intensities at the first seed.
struct TightLevels {
  LevelField levels;
  Intensities intensities;
};

//! The outermost tight levels between the object's and the half-way ones. What has been opened leaks by its
//! shape, whatever the level. None if there are none. `level`: the object's.
std::optional<TightLevels> tightLevels(const SmoothedVolume& volume, double level,
                                       const std::vector<Vec3>& seeds, const BoundaryStart& start) {
  const LevelField object(volume.grid(), level);
  for (const double part : kParts) {
    if (part < 1 && start.isOpened) break;
    LevelField levels = LevelField::between(object, start.levels, part);
    if (!isTight(levels, volume, seeds, start)) continue;
    const double end = levels.at(seeds[0]);
    return TightLevels{std::move(levels),
                       {start.object, rangeTo(start.object, end), level, std::abs(end - level)}};
  }
  return {};
}

//! With a given range the contrast is the distance from the level in the seeds to the nearer end.
Intensities intensitiesOf(const IntensityRange& range, double level, ObjectKind asked) {
  const double above = range.high - level, below = level - range.low;
  double contrast = std::min(above, below);
  if (!(contrast > 0) || !std::isfinite(contrast)) contrast = std::max(1e-6, std::abs(level) * 1e-3);
  const ObjectKind nearer = above < below ? ObjectKind::dark : ObjectKind::bright;
  return {asked == ObjectKind::automatic ? nearer : asked, range, level, contrast};
}

ObjectChoice withGivenRange(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& p) {
  requireVoxelsInRange(volume, *p.range);
  double sigma = p.smoothing.value_or(kFirstSigma * volume.grid.meanSpacing());
  const auto first = std::make_shared<const SmoothedVolume>(volume, sigma);
  requireSeedsInRange(*first, *p.range, seeds);
  const Intensities given = intensitiesOf(*p.range, levelIn(*first, seeds), p.object);
  if (!p.smoothing) sigma = std::min(sigma, chooseSmoothing(volume, seeds, first, given));
  const FinalImage image = finalImage(volume, sigma, paddingBeside(volume, seeds), given, first);
  return {given.object, given.range, given.level, given.contrast, image.volume, nullptr, nullptr, image.view};
}

//! Where a level is looked for.
struct LevelSearch {
  const Volume& volume;
  const std::vector<Seed>& seeds;
  FieldOfViewPointer view;
  double lowest, highest;  // of the whole volume, outliers left out
  const Parameters& parameters;
};

std::optional<RegionGrowthLevel> grownLevel(const LevelSearch& in, const SmoothedVolume& image,
                                            double seedLevel, ObjectKind kind) {
  const double sign = signOf(kind);
  const double from = sign * seedLevel, to = sign > 0 ? in.highest : -in.lowest;
  if (!(to > from)) return {};
  return strongestLevel(growRegion(image, indicesOf(image.grid(), in.seeds), sign, from, to));
}

//! What a dark and a bright object at the seeds would have as their boundary.
struct BothLevels {
  std::optional<RegionGrowthLevel> dark, bright;
};

BothLevels searchBoth(const LevelSearch& in, const SmoothedVolume& plain, double seedLevel) {
  const double noise = noiseEdge(plain, in.seeds, statisticsRadius(in.volume.grid, in.seeds));
  const auto search = [&](ObjectKind kind) {
    // Padding as dark as a dark object would be flooded with it; the region stops there, and its edge does
    // not count.
    const bool alike =
        in.view && (kind == ObjectKind::dark ? in.view->value() <= seedLevel : in.view->value() >= seedLevel);
    auto found = alike ? grownLevel(in, SmoothedVolume(in.volume, plain.sigma(), in.view, in.view->value()),
                                    seedLevel, kind)
                       : grownLevel(in, plain, seedLevel, kind);
    if (found && found->strength <= kClearEdge * noise) found.reset();
    return found;
  };
  BothLevels both;
  forEachOnThreads(2, growsByItself(plain) ? threadCount(in.parameters.threads) : 1, [&](std::size_t k) {
    (k == 0 ? both.dark : both.bright) = search(k == 0 ? ObjectKind::dark : ObjectKind::bright);
  });
  return both;
}

//! A level, and the image on which it was found.
struct FoundLevel {
  ImagePointer image;
  Intensities intensities;
  RegionGrowthLevel grown;
};

//! Dark or bright, and the level of the boundary, on an image of one smoothing. None if there is none, or if
//! what is asked for has a far weaker boundary than the opposite, or if what was found is the background
//! around everything.
std::optional<FoundLevel> chooseLevel(const LevelSearch& in, double sigma) {
  const ObjectKind asked = in.parameters.object;
  auto image = std::make_shared<const SmoothedVolume>(in.volume, sigma);
  const double level = levelIn(*image, in.seeds);
  const auto [dark, bright] = searchBoth(in, *image, level);
  const bool takeDark = asked == ObjectKind::dark || (asked == ObjectKind::automatic && dark &&
                                                      (!bright || dark->strength >= bright->strength));
  const auto& best = takeDark ? dark : bright;
  const auto& other = takeDark ? bright : dark;
  if (!best || (other && other->strength > kWrongKind * best->strength)) return {};
  if (asked == ObjectKind::automatic && best->border > kBackgroundBorder) return {};
  const ObjectKind kind = takeDark ? ObjectKind::dark : ObjectKind::bright;
  const double end = takeDark ? best->level : -best->level, contrast = std::abs(end - level);
  if (!(contrast > 0)) return {};
  return FoundLevel{std::move(image), {kind, rangeTo(kind, end), level, contrast}, *best};
}

//! A level, and the smoothing of the final image (mm).
struct SmoothedLevel {
  FoundLevel found;
  double sigma;
};

//! On the first image, or, unless the smoothing is given, on smoother ones where noise hides the boundary.
std::optional<SmoothedLevel> chooseLevelInNoise(const LevelSearch& in) {
  const std::optional<double> given = in.parameters.smoothing;
  const double voxel = in.volume.grid.meanSpacing(), first = given.value_or(kFirstSigma * voxel);
  if (auto found = chooseLevel(in, first)) return SmoothedLevel{*std::move(found), first};
  if (given) return {};
  for (const double sigma : kSigmasInNoise)
    if (auto found = chooseLevel(in, sigma * voxel)) return SmoothedLevel{*std::move(found), sigma * voxel};
  return {};
}

//! With the least smoothing that is enough, where it is left open.
std::optional<SmoothedLevel> chooseSmoothedLevel(const LevelSearch& in) {
  auto first = chooseLevelInNoise(in);
  if (!first || in.parameters.smoothing) return first;
  // Less smoothing than the first moves no level, and the growth need not be repeated; more does.
  const double used = first->sigma;
  double sigma = chooseSmoothing(in.volume, in.seeds, first->found.image, first->found.intensities);
  if (used > kFirstSigma * in.volume.grid.meanSpacing())
    sigma = std::max(sigma, used);  // it was found with that much only
  if (!(sigma > used)) return SmoothedLevel{std::move(first->found), sigma};
  auto again = chooseLevel(in, sigma);
  if (!again) return {};
  return SmoothedLevel{*std::move(again), sigma};
}

//! Padding is no border of the volume: an object that fills the field of view shows only here.
bool fillsView(const ObjectChoice& choice, const std::vector<Vec3>& seeds) {
  if (!choice.view || choice.neck) return false;
  const ObjectRegion r =
      floodObject(*choice.volume, seeds, signOf(choice.object), *choice.levels, kViewVoxels);
  const auto padding = static_cast<double>(r.againstPadding);
  return padding > kFillsView * static_cast<double>(r.faces.size() + r.againstPadding + r.atBorder);
}

void requireNotAllOfView(const ObjectChoice& choice, const std::vector<Seed>& seeds) {
  if (!fillsView(choice, indicesOf(choice.volume->grid(), seeds))) return;
  throw Told<SeedError>(Finding(FindingKind::fillsView));
}

}  // namespace

void requireSeedsInside(const Grid& grid, const std::vector<Seed>& seeds) {
  if (seeds.empty()) throw Told<UsageError>(Finding(FindingKind::noSeed));
  for (const Seed& s : seeds) {
    if (s.radius && !(*s.radius > 0 && std::isfinite(*s.radius)))
      throw Told<UsageError>(Finding(FindingKind::seedRadius));
    const Vec3 i = grid.toIndex(s.centre);
    if (!grid.contains(i))
      throw Told<SeedError>(
          Finding(FindingKind::seedOutside, {{"place", placeValue(s.centre)}, {"voxel", placeValue(i)}}));
  }
}

std::optional<ObjectChoice> objectNextTo(const BoundaryStart& start, const Volume& volume,
                                         const std::vector<Seed>& seeds, const Parameters& p) {
  const double sigma = p.smoothing.value_or(kFirstSigma * volume.grid.meanSpacing());
  const auto first = std::make_shared<const SmoothedVolume>(volume, sigma);
  const double level = levelIn(*first, seeds);
  const std::vector<Vec3> indices = indicesOf(volume.grid, seeds);
  const std::optional<TightLevels> rough = tightLevels(*first, level, indices, start);
  if (!rough) return {};
  const FinalImage image = finalImage(
      volume, p.smoothing ? *p.smoothing : chooseSmoothing(volume, seeds, first, rough->intensities),
      paddingBeside(volume, seeds), rough->intensities, first);
  std::optional<TightLevels> tight = tightLevels(*image.volume, level, indices, start);
  if (!tight || seedOutOfRange(*image.volume, tight->intensities.range, seeds)) return {};
  const ObjectSearch search{*image.volume, indices, signOf(start.object), level, std::move(tight->levels),
                            start.voxels,  true};
  ObjectChoice choice =
      choiceOf(tight->intensities, image, {findBoundary(search), tight->intensities.contrast}, indices[0]);
  if (p.object == ObjectKind::automatic && fillsView(choice, indices)) return {};
  return choice;
}

ObjectChoice chooseObject(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& p) {
  requireSeedsInside(volume.grid, seeds);
  if (p.range) return withGivenRange(volume, seeds, p);

  const std::vector<double> voxels = sampleVoxels(volume);
  const FieldOfViewPointer view = paddingBeside(volume, seeds);
  const auto chosen =
      chooseSmoothedLevel({volume, seeds, view, quantile(voxels, 0.002), quantile(voxels, 0.998), p});
  if (!chosen) throw Told<SeedError>(Finding(notInObject(p.object)));
  const Intensities& found = chosen->found.intensities;
  const FinalImage image = finalImage(volume, chosen->sigma, view, found, chosen->found.image);
  requireSeedsInRange(*image.volume, found.range, seeds);
  ObjectChoice choice = choiceOf(found, image, placeBoundary(image, found, chosen->found.grown, seeds),
                                 volume.grid.toIndex(seeds[0].centre));
  if (p.object == ObjectKind::automatic) requireNotAllOfView(choice, seeds);
  return choice;
}

}  // namespace handlebody
