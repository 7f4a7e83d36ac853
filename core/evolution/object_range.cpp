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
// An automatic object that holds more than this part of the volume's border is the background.
constexpr double kBackground = 0.5;

// And one of whose surface more than this part lies against the padding around the image.
constexpr double kFillsView = 2.0 / 3;
// Levels that hold so many times the region on which they were found let it leak.
constexpr double kLeaks = 1.5;
// Parts of the way from the object's level to the half-way levels that are tried as levels to begin with.
constexpr double kParts[] = {1, 0.8, 0.64, 0.51, 0.41, 0.33, 0.26, 0.21, 0.17, 0.13, 0.11};
constexpr std::size_t kViewVoxels = 3'000'000;  // enough of it to tell

using FieldOfViewPointer = std::shared_ptr<const FieldOfView>;

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

struct Statistics {
  double level;            // median in the seeds
  double lowest, highest;  // of the whole volume, outliers left out
};

double signOf(ObjectKind kind) { return kind == ObjectKind::dark ? 1 : -1; }

std::vector<Vec3> indicesOf(const Grid& grid, const std::vector<Seed>& seeds) {
  std::vector<Vec3> indices;
  for (const Seed& s : seeds) indices.push_back(grid.toIndex(s.centre));
  return indices;
}

std::optional<RegionGrowthLevel> searchLevel(const SmoothedVolume& volume, const std::vector<Seed>& seeds,
                                             const Statistics& s, ObjectKind kind) {
  const double sign = signOf(kind);
  const double from = sign * s.level, to = sign > 0 ? s.highest : -s.lowest;
  if (!(to > from)) return {};
  return strongestLevel(growRegion(volume, indicesOf(volume.grid(), seeds), sign, from, to));
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

//! The first seed that does not lie in the object's range; null if all do.
const Seed* seedOutOfRange(const ObjectChoice& choice, const std::vector<Seed>& seeds) {
  const auto isOut = [&](const Seed& s) {
    const double value = intensityAt(*choice.volume, s);
    return value < choice.range.low || value > choice.range.high;
  };
  const auto found = std::find_if(seeds.begin(), seeds.end(), isOut);
  return found == seeds.end() ? nullptr : &*found;
}

void requireSeedsInRange(const ObjectChoice& choice, const std::vector<Seed>& seeds) {
  const Seed* s = seedOutOfRange(choice, seeds);
  if (!s) return;
  throw Told<SeedError>(Finding(FindingKind::seedNotInRange, {{"place", placeValue(s->centre)},
                                                              {"intensity", intensityAt(*choice.volume, *s)},
                                                              {"low", choice.range.low},
                                                              {"high", choice.range.high}}));
}

//! Radius (mm) of the balls around the seeds in which the noise is measured: as far as the object goes.
double noiseRadius(const std::vector<Seed>& seeds, const ObjectChoice& choice) {
  const Grid& grid = choice.volume->grid();
  const ObjectImage image(choice.volume, choice.range, choice.contrast);
  double radius = kNoiseRadius * grid.meanSpacing();
  for (const Seed& s : seeds) radius = std::min(radius, fittingRadius(image, s.centre, radius));
  return std::max(radius, statisticsRadius(grid, seeds));
}

//! The least smoothing that is enough for the noise near the seeds. What more smoothing hardly lessens is
//! structure and not noise: it ends the search too.
double chooseSmoothing(const Volume& volume, const std::vector<Seed>& seeds, const ObjectChoice& choice) {
  const double voxel = volume.grid.meanSpacing();
  const double radius = noiseRadius(seeds, choice);
  double before = std::numeric_limits<double>::infinity();
  double best = kSigmas.front();
  for (double sigma : kSigmas) {
    const SmoothedVolume smoothed(volume, sigma * voxel);
    std::vector<double> values = valuesNear(smoothed, seeds, radius);
    const double middle = quantile(values, 0.5);
    for (double& v : values) v = std::abs(v - middle);
    // 1.4826: from the median deviation to the standard deviation of a normal distribution.
    const double noise = 1.4826 * quantile(values, 0.5);
    if (noise > kStructure * before) break;
    best = sigma;
    before = noise;
    if (noise <= kNoiseAllowed * choice.contrast) break;
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

//! The final image. Padding matters where its value would count as object: there it is given a value as far
//! outside the range as the object lies inside it. Elsewhere it is a background like any other.
void setImage(ObjectChoice& choice, const Volume& volume, double sigma,
              std::shared_ptr<const FieldOfView> view) {
  choice.view = view;
  const bool needed = view && view->value() >= choice.range.low && view->value() <= choice.range.high;
  const double wall = std::isfinite(choice.range.high) ? choice.range.high + choice.contrast
                                                       : choice.range.low - choice.contrast;
  if (!needed || !std::isfinite(wall)) view = nullptr;  // a range without ends holds everything
  if (!view && choice.volume && choice.volume->sigma() == sigma) return;  // it has been made already
  choice.volume = std::make_shared<SmoothedVolume>(volume, sigma, std::move(view), wall);
}

//! Voxels of the largest ball around a seed, of at most kNoiseRadius.
double seedBallVoxels(const ObjectChoice& choice, const std::vector<Seed>& seeds) {
  const ObjectImage image(choice.volume, choice.range, choice.contrast);
  const double voxel = choice.volume->grid().meanSpacing();
  double largest = voxel;
  for (const Seed& s : seeds)
    largest = std::max(largest, fittingRadius(image, s.centre, kNoiseRadius * voxel));
  return 4.0 / 3 * std::numbers::pi * std::pow(largest / voxel, 3);
}

//! The finite end of the range.
double& endOf(ObjectChoice& choice) {
  return choice.object == ObjectKind::dark ? choice.range.high : choice.range.low;
}

//! The range says what is used: without a gain, given as --range, it leads to the same surface.
void takeBoundary(ObjectChoice& choice, ObjectBoundary boundary, const Vec3& seed) {
  endOf(choice) = boundary.levels.at(seed);
  choice.levels = std::make_shared<LevelField>(std::move(boundary.levels));
  if (boundary.neck) choice.neck = std::make_shared<NeckCut>(*std::move(boundary.neck));
}

//! The boundary place by place. `found`: what the growth said about the level in the range.
void setBoundary(ObjectChoice& choice, const std::vector<Seed>& seeds, const RegionGrowthLevel& found) {
  const Grid& grid = choice.volume->grid();
  const ObjectSearch search{*choice.volume, indicesOf(grid, seeds),          signOf(choice.object),
                            choice.level,   LevelField(grid, endOf(choice)), found.voxels};
  std::optional<ObjectBoundary> boundary;
  if (found.border > kOnBorder && found.voxels > kOutOfProportion * seedBallVoxels(choice, seeds))
    boundary = findBoundaryAtNeck(search);
  if (boundary) {
    choice.contrast = std::abs(boundary->levels.at(search.seeds[0]) - choice.level);
  } else {
    boundary = findBoundary(search);
  }
  takeBoundary(choice, *std::move(boundary), search.seeds[0]);
}

//! True if levels hold the seeds and hardly more than the start.
bool isTight(const LevelField& levels, const ObjectChoice& choice, const std::vector<Vec3>& seeds,
             const BoundaryStart& start) {
  const double sign = signOf(choice.object);
  const auto isInside = [&](const Vec3& s) { return sign * choice.volume->sample(s) < sign * levels.at(s); };
  if (!std::all_of(seeds.begin(), seeds.end(), isInside)) return false;
  const auto most = static_cast<std::size_t>(kLeaks * start.voxels);
  WordFlood held(*choice.volume, seeds, sign, levels);
  return held.run(most) && static_cast<double>(held.count()) * kLeaks >= start.voxels;
}

//! The outermost tight levels between the object's and the half-way ones. What has been opened leaks by its
//! shape, whatever the level. None if there are none.
std::optional<LevelField> tightLevels(const ObjectChoice& choice, const std::vector<Vec3>& seeds,
                                      const BoundaryStart& start) {
  const LevelField object(choice.volume->grid(), choice.level);
  for (const double part : kParts) {
    if (part < 1 && start.isOpened) break;
    LevelField levels = LevelField::between(object, start.levels, part);
    if (isTight(levels, choice, seeds, start)) return levels;
  }
  return {};
}

//! The same, and the range that follows.
std::optional<LevelField> takeTightLevels(ObjectChoice& choice, const std::vector<Vec3>& seeds,
                                          const BoundaryStart& start) {
  std::optional<LevelField> levels = tightLevels(choice, seeds, start);
  if (!levels) return {};
  choice.range = {-kInfinity, kInfinity};
  endOf(choice) = levels->at(seeds[0]);
  choice.contrast = std::abs(endOf(choice) - choice.level);
  return levels;
}

//! With a given range the contrast is the distance from the level in the seeds to the nearer end.
ObjectChoice withGivenRange(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& p) {
  requireVoxelsInRange(volume, *p.range);
  ObjectChoice choice;
  double sigma = p.smoothing.value_or(kFirstSigma * volume.grid.meanSpacing());
  choice.range = *p.range;
  choice.volume = std::make_shared<SmoothedVolume>(volume, sigma);
  requireSeedsInRange(choice, seeds);
  choice.level = quantile(valuesNear(*choice.volume, seeds, statisticsRadius(volume.grid, seeds)), 0.5);
  const double above = choice.range.high - choice.level, below = choice.level - choice.range.low;
  choice.contrast = std::min(above, below);
  if (!(choice.contrast > 0) || !std::isfinite(choice.contrast))
    choice.contrast = std::max(1e-6, std::abs(choice.level) * 1e-3);
  choice.object = p.object;
  if (p.object == ObjectKind::automatic)
    choice.object = above < below ? ObjectKind::dark : ObjectKind::bright;
  if (!p.smoothing) sigma = std::min(sigma, chooseSmoothing(volume, seeds, choice));
  setImage(choice, volume, sigma, paddingBeside(volume, seeds));
  return choice;
}

//! Dark or bright, and the level of the boundary, on an image of one smoothing. None if there is none, or if
//! what is asked for has a far weaker boundary than the opposite, or if what was found is the background
//! around everything.
std::optional<RegionGrowthLevel> chooseLevel(ObjectChoice& choice, const Volume& volume, double sigma,
                                             const FieldOfViewPointer& view, const std::vector<Seed>& seeds,
                                             Statistics& whole, const Parameters& p) {
  const ObjectKind asked = p.object;
  choice.volume = std::make_shared<SmoothedVolume>(volume, sigma);
  const SmoothedVolume& plain = *choice.volume;
  whole.level = quantile(valuesNear(plain, seeds, statisticsRadius(volume.grid, seeds)), 0.5);
  const double noise = noiseEdge(plain, seeds, statisticsRadius(volume.grid, seeds));
  const auto search = [&](ObjectKind kind) {
    // Padding as dark as a dark object would be flooded with it; the region stops there, and its edge does
    // not count.
    const bool alike =
        view && (kind == ObjectKind::dark ? view->value() <= whole.level : view->value() >= whole.level);
    auto found = alike ? searchLevel(SmoothedVolume(volume, sigma, view, view->value()), seeds, whole, kind)
                       : searchLevel(plain, seeds, whole, kind);
    if (found && found->strength <= kClearEdge * noise) found.reset();
    return found;
  };
  std::optional<RegionGrowthLevel> dark, bright;
  forEachOnThreads(2, growsByItself(plain) ? threadCount(p.threads) : 1, [&](std::size_t k) {
    (k == 0 ? dark : bright) = search(k == 0 ? ObjectKind::dark : ObjectKind::bright);
  });
  const bool takeDark = asked == ObjectKind::dark || (asked == ObjectKind::automatic && dark &&
                                                      (!bright || dark->strength >= bright->strength));
  const auto& best = takeDark ? dark : bright;
  const auto& other = takeDark ? bright : dark;
  if (!best || (other && other->strength > kWrongKind * best->strength)) return {};
  if (asked == ObjectKind::automatic && best->border > kBackground) return {};
  choice.object = takeDark ? ObjectKind::dark : ObjectKind::bright;
  choice.range = takeDark ? IntensityRange{-kInfinity, best->level} : IntensityRange{-best->level, kInfinity};
  choice.level = whole.level;
  choice.contrast = std::abs((takeDark ? best->level : -best->level) - whole.level);
  return choice.contrast > 0 ? best : std::nullopt;
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
  ObjectChoice choice;
  const double first = kFirstSigma * volume.grid.meanSpacing();
  choice.volume = std::make_shared<SmoothedVolume>(volume, p.smoothing.value_or(first));
  choice.object = start.object;
  choice.level = quantile(valuesNear(*choice.volume, seeds, statisticsRadius(volume.grid, seeds)), 0.5);
  const std::vector<Vec3> indices = indicesOf(volume.grid, seeds);
  if (!takeTightLevels(choice, indices, start)) return {};
  setImage(choice, volume, p.smoothing ? *p.smoothing : chooseSmoothing(volume, seeds, choice),
           paddingBeside(volume, seeds));
  std::optional<LevelField> levels = takeTightLevels(choice, indices, start);
  if (!levels || seedOutOfRange(choice, seeds)) return {};
  takeBoundary(choice,
               findBoundary({*choice.volume, indices, signOf(choice.object), choice.level, *std::move(levels),
                             start.voxels, true}),
               indices[0]);
  if (p.object == ObjectKind::automatic && fillsView(choice, indices)) return {};
  return choice;
}

ObjectChoice chooseObject(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& p) {
  requireSeedsInside(volume.grid, seeds);
  if (p.range) return withGivenRange(volume, seeds, p);

  const std::vector<double> voxels = sampleVoxels(volume);
  Statistics whole{0, quantile(voxels, 0.002), quantile(voxels, 0.998)};
  ObjectChoice choice;
  const FieldOfViewPointer view = paddingBeside(volume, seeds);
  const double first = kFirstSigma * volume.grid.meanSpacing();
  double sigma = p.smoothing.value_or(first);
  auto found = chooseLevel(choice, volume, sigma, view, seeds, whole, p);
  for (std::size_t i = 0; !found && !p.smoothing && i < kSigmasInNoise.size(); ++i) {
    sigma = kSigmasInNoise[i] * volume.grid.meanSpacing();
    found = chooseLevel(choice, volume, sigma, view, seeds, whole, p);
  }
  if (found && !p.smoothing) {
    // Less smoothing than the first moves no level, and the growth need not be repeated; more does.
    const double used = sigma;
    sigma = chooseSmoothing(volume, seeds, choice);
    if (used > first) sigma = std::max(sigma, used);  // it was found with that much only
    if (sigma > used) found = chooseLevel(choice, volume, sigma, view, seeds, whole, p);
  }
  if (!found) throw Told<SeedError>(Finding(notInObject(p.object)));
  setImage(choice, volume, sigma, view);
  requireSeedsInRange(choice, seeds);
  setBoundary(choice, seeds, *found);
  if (p.object == ObjectKind::automatic) requireNotAllOfView(choice, seeds);
  return choice;
}

}  // namespace handlebody
