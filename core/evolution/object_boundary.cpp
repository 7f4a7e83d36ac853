#include "core/evolution/object_boundary.h"

#include <algorithm>
#include <cmath>

#include "core/evolution/edge_profile.h"
#include "core/evolution/object_region.h"
#include "core/evolution/word_flood.h"

namespace handlebody {

namespace {

// Edges of this part of the typical step around them count most.
constexpr double kLowerEdges = 0.5;

constexpr int kMaxPasses = 6;
// Levels that change by less than this part of the contrast in a pass stay: a fiftieth of the half-step is a
// hundredth of a voxel on an edge of one voxel.
constexpr double kStays = 0.02;
// From the third pass on a change must be less than this part of the one before.
constexpr double kContracts = 0.6;
// A region of so many times the size of the one before looks like a leak; of so many it is one.
constexpr double kLooksLikeLeak = 1.5;
constexpr double kIsLeak = 2;
// A region of so many times the size of the last one in which a hole was looked for may have another.
constexpr double kIsNew = 1.03;
// Smaller parts of the way to new levels are not tried.
constexpr double kMinFraction = 0.1;

// A flood ends when it is this many times what was expected, but within these numbers of voxels.
constexpr double kEnough = 25;
constexpr double kMinVoxels = 500'000, kMaxVoxels = 3'000'000;

// Parts of the way from the object's level to that of the boundary at which a neck is looked for.
constexpr double kNeckLevels[] = {1, 0.7, 0.5, 0.35, 0.25, 0.18, 0.12};

//! 1 for edges of a typical height: noise counts less by the square of its steps, and so does, more quickly,
//! what is much higher.
double weightOf(double step, double typical) {
  const double x = step / (kLowerEdges * typical), square = x * x;
  return square / (1 + square * square * square);
}

//! Which edges say where the levels lie, where edges of different height meet.
enum class Edges { lowerDecide, higherDecide };

//! What a search came to.
struct Found {
  ObjectBoundary boundary;
  bool converged;  // else the boundary is that of the levels it began with
};

class BoundarySearch {
 public:
  using Read = std::optional<ImageEdge> (EdgeReader::*)(const ObjectRegion::Voxel&,
                                                        const ObjectRegion::Face&) const;

  BoundarySearch(const ObjectSearch& s, Edges edges, Read read = &EdgeReader::halfWay)
      : s_(s), edges_(edges), read_(read), expected_(s.expectedVoxels) {}

  Found run() {
    LevelField trial = s_.levels;
    const double contrast = std::abs(trial.at(s_.seeds[0]) - s_.object);
    std::optional<ObjectBoundary> best, first;
    double part = 1, lastChange = 0;
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      Candidate c = grow(trial, best && best->neck);
      if (best && isLeak(c, *best)) {
        part *= 0.5;
        if (part < kMinFraction) break;
        trial = LevelField::between(best->levels, trial, 0.5);
        continue;
      }
      expected_ = c.voxels;
      LevelField next = levelsAt(c, trial, read_);
      const double change = meanChange(c.region, next, trial);
      const bool isConverged = change <= kStays * contrast;
      if (pass >= 2 && change > kContracts * lastChange) return {*std::move(first), false};
      lastChange = change;
      // A neck belongs to the levels at which it was found.
      const bool hasNeck = c.neck.has_value();
      best = ObjectBoundary{isConverged && !hasNeck ? levelsOfShape(c, next) : trial,
                            withoutMarks(std::move(c.neck))};
      if (!first) first = best;
      if (isConverged) break;
      trial = LevelField::between(trial, next, part);
    }
    return {*std::move(best), true};
  }

 private:
  struct Candidate {
    ObjectRegion region;
    std::optional<NeckCut> neck;
    double voxels = 0;  // of the region, up to the neck
  };

  //! `wasHeld`: at a neck or hole before, which is looked for again whatever the region's size.
  Candidate grow(const LevelField& levels, bool wasHeld) {
    if (s_.isWhole) return growWhole(levels);
    const double most = std::clamp(kEnough * expected_, kMinVoxels, std::max(2 * expected_, kMaxVoxels));
    Candidate c;
    c.region = floodObject(s_.volume, s_.seeds, s_.sign, levels, static_cast<std::size_t>(most));
    c.voxels = static_cast<double>(c.region.voxels.size());
    const bool looksLikeLeak = c.voxels > kLooksLikeLeak * expected_;
    const bool isNew = c.voxels > kIsNew * looked_;
    if (!looksLikeLeak && !wasHeld && !isNew) return c;
    looked_ = std::max(looked_, c.voxels);
    c.neck = findNeck(s_.volume.grid(), c.region, s_.seeds, looksLikeLeak ? Passages::both : Passages::holes);
    if (c.neck) c.voxels = c.neck->keptVolume / s_.volume.grid().voxelVolume();
    return c;
  }

  //! Without a neck; its rim alone. A leak needs no more than to be seen as one.
  Candidate growWhole(const LevelField& levels) const {
    WordFlood flood(s_.volume, s_.seeds, s_.sign, levels);
    flood.run(static_cast<std::size_t>(std::max(kMinVoxels, kIsLeak * expected_)));
    return {flood.rim(), {}, static_cast<double>(flood.count())};
  }

  //! Far larger than before, or somewhat larger and the neck that held it is lost.
  bool isLeak(const Candidate& c, const ObjectBoundary& before) const {
    const bool lost = before.neck && !c.neck;
    return c.voxels > (lost ? kLooksLikeLeak : kIsLeak) * expected_;
  }

  LevelField levelsAt(const Candidate& c, const LevelField& fallback, Read read) const {
    const EdgeReader reader(s_.volume, s_.sign);
    std::vector<ImageEdge> edges;
    LevelField::Samples steps(s_.volume.grid()), levels(s_.volume.grid());
    for (const ObjectRegion::Face& face : c.region.faces) {
      const auto voxel = static_cast<std::size_t>(face.voxel);
      if (c.neck && !c.neck->kept[voxel]) continue;
      const auto edge = (reader.*read)(c.region.voxels[voxel], face);
      if (!edge) continue;
      edges.push_back(*edge);
      steps.add(edge->place, edge->step, edge->weight * edge->step * edge->step);
    }
    if (edges.empty()) return fallback;
    const LevelField typical = steps.spread();
    for (const ImageEdge& e : edges)
      levels.add(e.place, s_.sign * e.level,
                 e.weight * (edges_ == Edges::lowerDecide ? weightOf(e.step, typical.at(e.place))
                                                          : e.step * e.step));
    return levels.empty() ? fallback : levels.spread();
  }

  //! The levels of the boundary itself, where half-way levels have converged; those if the region would
  //! leak within the others.
  LevelField levelsOfShape(const Candidate& c, const LevelField& halfWay) {
    LevelField levels = levelsAt(c, halfWay, &EdgeReader::ofShape);
    const Candidate within = grow(levels, false);
    return within.neck || within.voxels > kLooksLikeLeak * expected_ ? halfWay : levels;
  }

  //! Mean of |a - b| over the region's faces.
  static double meanChange(const ObjectRegion& region, const LevelField& a, const LevelField& b) {
    constexpr std::size_t kEvery = 16;
    double sum = 0, n = 0;
    for (std::size_t i = 0; i < region.faces.size(); i += kEvery, n += 1) {
      const ObjectRegion::Voxel& v = region.voxels[region.faces[i].voxel];
      const Vec3 at(v[0], v[1], v[2]);
      sum += std::abs(a.at(at) - b.at(at));
    }
    return n > 0 ? sum / n : 0;
  }

  static std::optional<NeckCut> withoutMarks(std::optional<NeckCut> neck) {
    if (neck) neck->kept = {};
    return neck;
  }

  const ObjectSearch& s_;
  Edges edges_;
  Read read_;
  double expected_;    // voxels
  double looked_ = 0;  // voxels of the largest region in which a hole was looked for
};

}  // namespace

ObjectBoundary findBoundary(const ObjectSearch& search) {
  Found found = BoundarySearch(search, Edges::lowerDecide).run();
  if (!found.converged) found = BoundarySearch(search, Edges::higherDecide).run();
  if (!found.converged) {
    // On a small object half-way levels creep up with the lines that cross it at a slant.
    Found shaped = BoundarySearch(search, Edges::lowerDecide, &EdgeReader::halfWayAlong).run();
    if (shaped.converged && !shaped.boundary.neck) found = std::move(shaped);
  }
  return std::move(found.boundary);
}

std::optional<ObjectBoundary> findBoundaryAtNeck(const ObjectSearch& s) {
  const LevelField object(s.volume.grid(), s.object);
  for (double part : kNeckLevels) {
    LevelField level = LevelField::between(object, s.levels, part);
    const ObjectRegion region =
        floodObject(s.volume, s.seeds, s.sign, level, static_cast<std::size_t>(kMinVoxels));
    std::optional<NeckCut> neck = findNeck(s.volume.grid(), region, s.seeds);
    if (!neck) continue;
    neck->kept = {};
    return ObjectBoundary{std::move(level), std::move(neck)};
  }
  return {};
}

}  // namespace handlebody
