#include "core/evolution/first_object.h"

#include <cmath>

#include "core/evolution/region_levels.h"

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

//! The cells of which half the voxels are enclosed, and that may be: not far from the model's own region.
RegionInCells cellsWith(const std::vector<int>& enclosed, double perCell, const ObjectModel& model) {
  const CellGrid& cells = model.work->cells();
  const RegionField own(*model.work, model.region);
  const double reach = kNextTo * cells.grid.meanSpacing();
  RegionInCells out{cells, {std::vector<std::uint8_t>(cells.count(), 0)}};
  for (std::size_t i = 0; i < enclosed.size(); ++i) {
    if (2 * enclosed[i] < perCell) continue;
    const std::array<int, 3> c = cells.cellOf(i);
    out.region.inside[i] =
        model.region.inside[i] || own.at(cells.grid.toWorld(Vec3(c[0], c[1], c[2]))) > -reach;
  }
  return out;
}

}  // namespace

std::optional<RegionInCells> enclosedAs(const Volume& volume, const ObjectChoice& choice,
                                        const std::vector<Seed>& clicks, const ObjectModel& model) {
  std::vector<Vec3> indices, outside;
  for (const Seed& s : clicks) (s.background ? outside : indices).push_back(volume.grid.toIndex(s.centre));
  const double sign = choice.object == ObjectKind::dark ? 1 : -1;
  const ObjectRegion flooded = floodObject(*choice.volume, indices, sign, *choice.levels, kMaxVoxels);
  const CellGrid& cells = model.work->cells();
  std::vector<int> enclosed(cells.count(), 0);
  double both = 0, in = 0;
  for (const ObjectRegion::Voxel& v : flooded.voxels) {
    const Vec3 index(v[0], v[1], v[2]);
    if (choice.neck && choice.neck->barrier->openness(index) <= 0) continue;
    for (const Vec3& click : outside)
      if ((click - index).cwiseAbs().maxCoeff() <= 0.5) return {};
    in += 1;
    const Vec3 world = volume.grid.toWorld(index);
    if (!cells.contains(world)) continue;
    const std::size_t cell = cells.at(cells.nearest(world));
    ++enclosed[cell];
    both += model.region.inside[cell] != 0;
  }
  const double perCell = static_cast<double>(cells.factor[0]) * cells.factor[1] * cells.factor[2];
  const double any = in + static_cast<double>(model.region.count()) * perCell - both;
  if (both < kSameObject * any) return {};
  return cellsWith(enclosed, perCell, model);
}

bool isItselfABoundary(const ObjectModel& model) {
  return !model.isCorrected && !model.scale.isLogarithmic();
}

FirstObject findFirstObject(const Volume& volume, const Seed& seed, const ObjectQuery& query,
                            const Parameters& parameters, const FindModel& find) {
  FirstObject out;
  out.model = find(query);
  if (!out.model || !isItselfABoundary(*out.model)) return out;
  std::optional<ObjectChoice> boundary = boundaryNextTo(*out.model, volume, seed, parameters);
  if (!boundary) return out;
  std::optional<RegionInCells> shown = enclosedAs(volume, *boundary, {seed}, *out.model);
  if (!shown) return out;
  out.boundary = std::move(boundary);
  out.shown = std::make_shared<const RegionInCells>(std::move(*shown));
  return out;
}

}  // namespace handlebody
