#include "core/evolution/first_object.h"

#include <cmath>

#include "core/evolution/region_image.h"
#include "core/evolution/region_levels.h"
#include "core/evolution/word_flood.h"

namespace handlebody {

namespace {

// A boundary and a region are of one object if they share this part of what either holds.
constexpr double kSameObject = 0.75;
constexpr std::size_t kMaxVoxels = 20'000'000;  // of a boundary that is compared

//! The boundary next to a region, between two intensities, if there is one.
std::optional<ObjectChoice> boundaryNextTo(const ObjectModel& model, const Volume& volume, const Seed& seed,
                                           const Parameters& p) {
  const RegionLevels levels = levelsOn(*model.work, model.region, volume.grid);
  if (!(levels.halfStep > 0)) return {};
  ObjectKind kind = levels.kind;
  if (std::isfinite(model.low) != std::isfinite(model.high))
    kind = std::isfinite(model.high) ? ObjectKind::dark : ObjectKind::bright;
  const auto& factor = model.work->cells().factor;
  const double perCell = static_cast<double>(factor[0]) * factor[1] * factor[2];
  return objectNextTo({kind, kind == ObjectKind::dark ? *levels.high : *levels.low,
                       static_cast<double>(model.region.count()) * perCell, model.neckRadius > 0},
                      volume, {seed}, p);
}

}  // namespace

bool isSameObject(const Volume& volume, const ObjectChoice& choice, const std::vector<Seed>& clicks,
                  const ObjectModel& model) {
  std::vector<Vec3> indices, outside;
  for (const Seed& s : clicks) (s.background ? outside : indices).push_back(volume.grid.toIndex(s.centre));
  const double sign = choice.object == ObjectKind::dark ? 1 : -1;
  WordFlood flooded(*choice.volume, indices, sign, *choice.levels);
  flooded.run(kMaxVoxels);
  const CellGrid& cells = model.work->cells();
  double both = 0, in = 0;
  bool holdsOutside = false;
  flooded.forEachRun([&](int first, int last, int y, int z) {
    for (int x = first; x <= last; ++x) {
      const Vec3 index(x, y, z);
      if (choice.neck && choice.neck->barrier->openness(index) <= 0) continue;
      for (const Vec3& click : outside) holdsOutside |= (click - index).cwiseAbs().maxCoeff() <= 0.5;
      in += 1;
      const Vec3 world = volume.grid.toWorld(index);
      both += cells.contains(world) && model.region.inside[cells.at(cells.nearest(world))] != 0;
    }
  });
  if (holdsOutside) return false;
  const double perCell = static_cast<double>(cells.factor[0]) * cells.factor[1] * cells.factor[2];
  const double any = in + static_cast<double>(model.region.count()) * perCell - both;
  return both >= kSameObject * any;
}

bool isItselfABoundary(const ObjectModel& model) {
  return !model.isCorrected && !model.scale.isLogarithmic();
}

FirstObject firstObjectOf(const Volume& volume, const Seed& seed, const Parameters& parameters,
                          const ObjectModel& model) {
  FirstObject out{model, {}, {}};
  if (isItselfABoundary(model)) out.boundary = boundaryNextTo(model, volume, seed, parameters);
  if (out.boundary && !isSameObject(volume, *out.boundary, {seed}, model)) out.boundary.reset();
  if (out.boundary) out.image = imageOfBoundary(*out.boundary, model);
  return out;
}

}  // namespace handlebody
