#include "core/evolution/clicked_object.h"

#include <algorithm>
#include <limits>

#include "core/evolution/boundary_evidence.h"
#include "core/evolution/click_faults.h"
#include "core/evolution/region_image.h"
#include "core/evolution/region_levels.h"
#include "core/evolution/start_object.h"
#include "core/phase.h"
#include "core/threads.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

ObjectQuery queryOf(const std::vector<Seed>& clicks, const Parameters& p) {
  ObjectQuery query;
  for (const Seed& s : clicks) (s.background ? query.outside : query.inside).push_back({s.centre, s.radius});
  query.candidate = p.candidate;
  query.threads = threadCount(p.threads);
  if (p.object != ObjectKind::automatic)
    query.contrast = p.object == ObjectKind::dark ? Contrast::dark : Contrast::bright;
  return query;
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
//! boundary of that kind around the seed, as far as the image shows it there. Further clicks correct the
//! likeliest region instead.
bool mayMeanBoundary(const std::vector<Seed>& clicks, const Parameters& p) {
  const auto any = [&](auto&& f) { return std::any_of(clicks.begin(), clicks.end(), f); };
  if (p.candidate != 1 || any([](const Seed& s) { return s.background; })) return false;
  return p.object != ObjectKind::automatic || any([](const Seed& s) { return s.radius.has_value(); });
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

//! `start`: what is meant where no seed says it; else null.
void requireNoContradiction(const Grid& grid, const std::vector<Seed>& clicks, const StartSurface* start) {
  const auto fault = start ? contradictionOf(grid, start->inside, clicks) : contradictionOf(grid, clicks);
  if (fault) throw Told<SeedError>(*fault);
}

//! What else clicks may mean that mean a boundary. The choice among the candidates is close only if the
//! boundary is that of the first: else it was not the candidates that were chosen from.
ObjectChoices choicesBeside(const Volume& volume, const std::vector<Seed>& clicks, const Parameters& p,
                            const ObjectChoice& meant, const FieldOfView* view) {
  const std::optional<ObjectModel> model = findObject(volume, queryOf(clicks, p), view);
  if (!model) return {};
  return {model->candidates,
          model->isCloseChoice && isItselfABoundary(*model) && isSameObject(volume, meant, clicks, *model)};
}

//! What else the clicks may mean is looked for at once unless it is beyond doubt, so that it is told.
ClickedObject clearObject(const Volume& volume, const std::vector<Seed>& clicks, const Parameters& p,
                          const ObjectChoice& meant, const std::shared_ptr<const FieldOfView>& view,
                          bool isBeyondDoubt) {
  ClickedObject out;
  takeBoundary(out, meant, imageOf(meant));
  out.choices = std::make_shared<const AskedChoices>(
      [=] { return choicesBeside(volume, clicks, p, meant, view.get()); });
  out.smoothing = out.image->volume().sigma();
  if (!isBeyondDoubt) out.choices->get();
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
                                                       const std::shared_ptr<const FieldOfView>& view,
                                                       const std::shared_ptr<const RegionInCells>& given) {
  const auto findWith = [&](ObjectFinder& finder) {
    ObjectQuery query = queryOf({seed}, p);
    query.given = given;
    const std::optional<ObjectModel> model = finder.find(volume, query, view);
    return std::make_shared<const FirstObject>(model ? firstObjectOf(volume, seed, p, *model)
                                                     : FirstObject());
  };
  const std::unique_lock lock(guard_, std::try_to_lock);
  if (!lock) {
    ObjectFinder own;
    return findWith(own);
  }
  const bool isKnown = first_ && first_->voxels == volume.voxels && first_->seed == seed &&
                       chooseSameImage(first_->parameters, p) && isSame(first_->given.get(), given.get());
  if (!isKnown) {
    first_.reset();
    first_ = KnownFirst{volume.voxels, seed, p, given, findWith(finder_)};
  }
  return first_->object;
}

namespace {

//! There is nothing but one intensity at the first click.
ClickedObject withoutModel(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& p) {
  const Boundary boundary = strongestBoundary(volume, seeds, p);
  if (!boundary.choice) throw Told<SeedError>(boundary.why);
  ClickedObject out;
  takeBoundary(out, *boundary.choice, imageOf(*boundary.choice));
  out.choices = std::make_shared<const AskedChoices>(ObjectChoices{});
  return out;
}

//! What is told of a model. Of a given one no bounds of intensity are known.
ClickedObject described(const ObjectModel& model) {
  ClickedObject out;
  out.candidate = model.chosen;
  out.choices = std::make_shared<const AskedChoices>(ObjectChoices{model.candidates, model.isCloseChoice});
  out.kind = model.rise > 0 ? ObjectKind::dark : ObjectKind::bright;
  out.range = {model.low, model.high};
  if (model.isGiven) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    out.kind = levelsOn(*model.work, model.region, model.work->cells().grid).kind;
    out.range = {-kInfinity, kInfinity};
  }
  out.neckRadius = model.neckRadius;
  out.isCutOff = model.isCutOff;
  return out;
}

//! The likeliest region, or the boundary next to it, corrected by further clicks. `plausible`: a boundary
//! that is better than both where it is of the same object; may be null. `given`: what the first click means,
//! where that is known; else null.
ClickedObject likeliestObject(const Volume& volume, const std::vector<Seed>& clicks, const Parameters& p,
                              const std::shared_ptr<const FieldOfView>& view, ObjectMemory& memory,
                              const ObjectChoice* plausible,
                              const std::shared_ptr<const RegionInCells>& given) {
  const std::vector<Seed> seeds = seedsOfSide(clicks, false);
  const auto first = memory.first(volume, seeds[0], p, view, given);
  std::optional<ObjectModel> model = first->model;
  if (clicks.size() > 1 || !model) {
    ObjectQuery query = queryOf(clicks, p);
    query.given = given;
    // A boundary that is shown lies up to a cell beside the region that it was found next to. A region's own
    // cells are better than those of its smooth surface: they would be smoothed once more.
    if (first->boundary)
      query.shown = std::make_shared<const RegionInCells>(shownCells(*first->image, *model));
    model = memory.find(volume, query, view);
  }
  if (!model) return withoutModel(volume, seeds, p);
  ClickedObject out = described(*model);
  if (plausible && isSameObject(volume, *plausible, clicks, *model)) {
    takeBoundary(out, *plausible, imageOf(*plausible));
    out.neckRadius = 0;
    out.isCutOff = false;
  } else if (!first->boundary) {
    out.image = imageOfRegion(volume, *model, p.smoothing, view);
  } else if (model->isCorrected) {
    out.image = imageOfCorrected(first->image, *model);
  } else {
    takeBoundary(out, *first->boundary, first->image);
    out.neckRadius = 0;
  }
  return out;
}

ClickedObject objectInRange(const Volume& volume, const std::vector<Seed>& seeds, const Parameters& p) {
  ClickedObject out;
  const ObjectChoice choice = chooseObject(volume, seeds, p);
  takeBoundary(out, choice, imageOf(choice));
  out.choices = std::make_shared<const AskedChoices>(ObjectChoices{});
  out.smoothing = out.image->volume().sigma();
  return out;
}

}  // namespace

ClickedObject findClickedObject(const Volume& volume, const std::vector<Seed>& asked, const Parameters& p,
                                ObjectMemory* memory, const StartSurface* start) {
  const Phase phase(kFindingPhase);
  std::vector<Seed> clicks = asked;
  const bool isStartAlone = start && seedsOfSide(asked, false).empty();
  if (isStartAlone) clicks.push_back(seedWithin(*start));
  const std::vector<Seed> seeds = seedsOfSide(clicks, false);
  requireClicksInside(volume.grid, clicks);
  requireNoContradiction(volume.grid, asked, isStartAlone ? start : nullptr);
  if (p.range) {
    if (seeds.size() != clicks.size()) throw Told<UsageError>(Finding(FindingKind::rangeAndBackground));
    return objectInRange(volume, seeds, p);
  }
  requireSeedsInside(volume.grid, seeds);
  std::shared_ptr<const FieldOfView> view = FieldOfView::find(volume);
  if (view && view->isPaddingNear(volume.grid.toIndex(seeds[0].centre))) view = nullptr;
  Boundary boundary;
  if (mayMeanBoundary(clicks, p)) boundary = strongestBoundary(volume, seeds, p);
  const BoundaryEvidence evidence =
      boundary.choice ? evidenceOf(*boundary.choice, seeds) : BoundaryEvidence();
  if (evidence.isClear() && !(isStartAlone && outlinesPart(*start, *boundary.choice)))
    return clearObject(volume, clicks, p, *boundary.choice, view, evidence.isBeyondDoubt());
  std::shared_ptr<const RegionInCells> given;
  if (start && p.candidate == 1) {
    given = cellsWithin(*start, volume.grid);
    if (!isStartAlone) clicks.insert(clicks.begin(), seedWithin(*start));
  }
  ObjectMemory own;
  ClickedObject out = likeliestObject(volume, clicks, p, view, memory ? *memory : own,
                                      evidence.isPlausible() ? &*boundary.choice : nullptr, given);
  out.smoothing = out.image->volume().sigma();
  return out;
}

}  // namespace handlebody
