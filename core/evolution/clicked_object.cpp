#include "core/evolution/clicked_object.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/evolution/region_levels.h"
#include "core/object/region_field.h"
#include "core/threads.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// An edge of half a step of so many standard deviations of the noise is trusted for a whole cell.
constexpr double kTrusted = 2;
// Standard deviations that are tried, in voxels, and the part of the half-step that noise may be.
constexpr std::array<double, 6> kSigmas{0.5, 0.7, 1.0, 1.3, 1.6, 2.0};
constexpr double kNoiseAllowed = 0.15;

ObjectQuery queryOf(const std::vector<Seed>& clicks, const Parameters& p) {
  ObjectQuery query;
  for (const Seed& s : clicks) (s.background ? query.outside : query.inside).push_back({s.centre, s.radius});
  query.candidate = p.candidate;
  query.threads = threadCount(p.threads);
  if (p.object != ObjectKind::automatic)
    query.contrast = p.object == ObjectKind::dark ? Contrast::dark : Contrast::bright;
  return query;
}

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
struct RegionImage {
  RegionLimits limits;
  double halfStep;  // intensities
};

RegionImage limitsOf(const ObjectModel& model) {
  const RegionLevels levels = levelsOn(*model.work, model.region, model.work->cells().grid);
  const double halfStep = levels.halfStep > 0 ? levels.halfStep : model.noise;
  const CellGrid& cells = model.work->cells();
  const double cell = cells.grid.meanSpacing();
  // A star-shaped region was chosen because the image around it leads astray: its own surface counts.
  const double trust = model.isStar ? 0 : std::min(1.0, halfStep / (kTrusted * model.noise));
  return {{std::make_shared<RegionField>(*model.work, model.region), cells.grid, levels.low, levels.high,
           levels.side, trust * cell, cell},
          halfStep};
}

std::shared_ptr<const ObjectImage> imageOf(const Volume& volume, const ObjectModel& model,
                                           const Parameters& p, std::shared_ptr<const FieldOfView> view) {
  RegionImage region = limitsOf(model);
  const double voxel = volume.grid.meanSpacing();
  const double sigma = p.smoothing.value_or(smoothingFor(model.noise, region.halfStep) * voxel);
  return std::make_shared<ObjectImage>(
      std::make_shared<SmoothedVolume>(onScale(volume, model.scale), sigma), std::move(region.limits),
      std::max(region.halfStep, 1e-6 * std::abs(model.level)), std::move(view));
}

//! The strongest boundary around the seeds, or why there is none.
struct Boundary {
  std::optional<ObjectChoice> choice;
  Finding why;
};

Boundary strongestBoundary(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& p) {
  try {
    return {chooseObject(volume, seeds, p), {}};
  } catch (const SeedError& error) {
    return {{}, findingOf(error)};
  }
}

//! A seed with a radius, or the kind of object, says more than a click: what is meant is the strongest
//! boundary of that kind around the seed, as far as it is there. Further clicks correct the likeliest region
//! instead.
bool isMeantByBoundary(const std::vector<Seed>& clicks, const Parameters& p) {
  const auto any = [&](auto&& f) { return std::any_of(clicks.begin(), clicks.end(), f); };
  if (p.candidate != 1 || any([](const Seed& s) { return s.background; })) return false;
  return p.object != ObjectKind::automatic || any([](const Seed& s) { return s.radius.has_value(); });
}

//! A boundary next to the region, no further from the region's own surface than it may have moved: it could
//! leak where it has a gap of less than a voxel.
std::shared_ptr<const ObjectImage> imageOf(const ObjectChoice& choice, const ObjectModel& model) {
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

//! A region that clicks have corrected, with the boundary as before where they have changed nothing.
std::shared_ptr<const ObjectImage> imageOf(const ObjectChoice& choice, const ObjectModel& corrected,
                                           const Region& before) {
  Region changed = corrected.region;
  for (std::size_t i = 0; i < changed.inside.size(); ++i)
    changed.inside[i] = changed.inside[i] != before.inside[i];
  RegionLimits limits = limitsOf(corrected).limits;
  limits.unchanged = {std::make_shared<RegionField>(*corrected.work, changed), choice.levels,
                      choice.object == ObjectKind::dark, kNextTo * limits.cell};
  return std::make_shared<ObjectImage>(choice.volume, std::move(limits), choice.contrast, choice.view);
}

std::shared_ptr<const ObjectImage> imageOf(const ObjectChoice& choice) {
  return std::make_shared<ObjectImage>(choice.volume, choice.range, choice.contrast, choice.levels,
                                       choice.neck, choice.view);
}

void takeBoundary(ClickedObject& out, const ObjectChoice& choice, std::shared_ptr<const ObjectImage> image) {
  out.image = std::move(image);
  out.kind = choice.object;
  out.range = choice.range;
}

void requireClicksInside(const Grid& grid, const std::vector<Seed>& clicks) {
  for (const Seed& s : clicks)
    if (s.background && !grid.contains(grid.toIndex(s.centre)))
      throw Told<SeedError>(Finding(FindingKind::clickOutside, {{"place", placeValue(s.centre)}}));
}

//! What else clicks may mean that mean a boundary. The choice among the candidates is close only if the
//! boundary is that of the first: else it was not the candidates that were chosen from.
ObjectChoices choicesBeside(const Volume& volume, const std::vector<Seed>& clicks, const Parameters& p,
                            const ObjectChoice& meant, const FieldOfView* view) {
  const std::optional<ObjectModel> model = findObject(volume, queryOf(clicks, p), view);
  if (!model) return {};
  return {model->candidates, model->isCloseChoice && isItselfABoundary(*model) &&
                                 enclosedAs(volume, meant, clicks, *model).has_value()};
}

ClickedObject meantObject(const Volume& volume, const std::vector<Seed>& clicks, const Parameters& p,
                          const ObjectChoice& meant, std::shared_ptr<const FieldOfView> view) {
  ClickedObject out;
  takeBoundary(out, meant, imageOf(meant));
  out.choices = std::make_shared<const AskedChoices>(
      [=] { return choicesBeside(volume, clicks, p, meant, view.get()); });
  out.smoothing = out.image->volume().sigma();
  return out;
}

}  // namespace

const ObjectChoices& AskedChoices::get() const {
  const std::lock_guard lock(guard_);
  if (!found_) {
    found_ = find_();
    find_ = nullptr;  // and what it holds
  }
  return *found_;
}

bool AskedChoices::areKnown() const {
  const std::lock_guard lock(guard_);
  return found_.has_value();
}

std::optional<ObjectModel> ObjectMemory::find(const Volume& volume, const ObjectQuery& query,
                                              std::shared_ptr<const FieldOfView> view) {
  const std::unique_lock lock(guard_, std::try_to_lock);
  return lock ? finder_.find(volume, query, std::move(view)) : findObject(volume, query, view.get());
}

std::shared_ptr<const FirstObject> ObjectMemory::first(const Volume& volume, const Seed& seed,
                                                       const Parameters& p,
                                                       const std::shared_ptr<const FieldOfView>& view) {
  const auto findWith = [&](ObjectFinder& finder) {
    return std::make_shared<const FirstObject>(
        findFirstObject(volume, seed, queryOf({seed}, p), p,
                        [&](const ObjectQuery& query) { return finder.find(volume, query, view); }));
  };
  const std::unique_lock lock(guard_, std::try_to_lock);
  if (!lock) {
    ObjectFinder own;
    return findWith(own);
  }
  const bool isKnown = first_ && first_->voxels == volume.voxels && first_->seed == seed &&
                       chooseSameImage(first_->parameters, p);
  if (!isKnown) {
    first_.reset();
    first_ = KnownFirst{volume.voxels, seed, p, findWith(finder_)};
  }
  return first_->object;
}

namespace {

//! Of bare clicks: the likeliest region, or the boundary next to it, corrected by further clicks.
ClickedObject likeliestObject(const Volume& volume, const std::vector<Seed>& clicks, const Parameters& p,
                              const std::shared_ptr<const FieldOfView>& view, ObjectMemory& memory) {
  const std::vector<Seed> seeds = seedsOfSide(clicks, false);
  std::shared_ptr<const FirstObject> first = std::make_shared<FirstObject>();
  if (!isMeantByBoundary(clicks, p)) first = memory.first(volume, seeds[0], p, view);
  ObjectQuery query = queryOf(clicks, p);
  query.shown = first->shown;
  const std::optional<ObjectModel> model =
      first->model && clicks.size() == 1 ? first->model : memory.find(volume, query, view);
  ClickedObject out;
  if (!model) {
    const Boundary boundary = strongestBoundary(volume, seeds, p);
    if (!boundary.choice) throw Told<SeedError>(boundary.why);
    takeBoundary(out, *boundary.choice, imageOf(*boundary.choice));
    out.choices = std::make_shared<const AskedChoices>(ObjectChoices{});
  } else {
    out.candidate = model->chosen;
    out.choices =
        std::make_shared<const AskedChoices>(ObjectChoices{model->candidates, model->isCloseChoice});
    if (first->boundary && !model->isCorrected) {
      takeBoundary(out, *first->boundary, imageOf(*first->boundary, *first->model));
    } else {
      out.image = first->boundary ? imageOf(*first->boundary, *model, model->start)
                                  : imageOf(volume, *model, p, view);
      out.kind = model->rise > 0 ? ObjectKind::dark : ObjectKind::bright;
      out.range = {model->low, model->high};
      out.neckRadius = model->neckRadius;
    }
  }
  out.smoothing = out.image->volume().sigma();
  return out;
}

}  // namespace

ClickedObject findClickedObject(const Volume& volume, const std::vector<Seed>& clicks, const Parameters& p,
                                ObjectMemory* memory) {
  const std::vector<Seed> seeds = seedsOfSide(clicks, false);
  requireClicksInside(volume.grid, clicks);
  if (p.range) {
    if (seeds.size() != clicks.size()) throw Told<UsageError>(Finding(FindingKind::rangeAndBackground));
    ClickedObject out;
    const ObjectChoice choice = chooseObject(volume, seeds, p);
    takeBoundary(out, choice, imageOf(choice));
    out.choices = std::make_shared<const AskedChoices>(ObjectChoices{});
    out.smoothing = out.image->volume().sigma();
    return out;
  }
  requireSeedsInside(volume.grid, seeds);
  std::shared_ptr<const FieldOfView> view = FieldOfView::find(volume);
  if (view && view->isPaddingNear(volume.grid.toIndex(seeds[0].centre))) view = nullptr;
  if (isMeantByBoundary(clicks, p))
    if (const Boundary meant = strongestBoundary(volume, seeds, p); meant.choice)
      return meantObject(volume, clicks, p, *meant.choice, std::move(view));
  ObjectMemory own;
  return likeliestObject(volume, clicks, p, view, memory ? *memory : own);
}

}  // namespace handlebody
