#include "core/evolution/local_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstdio>

#include "core/evolution/object_region.h"

namespace handlebody {

namespace {

constexpr int kReach = 1;
double kWeaker = getenv("WK") ? atof(getenv("WK")) : 0.5;
constexpr int kMostPasses = 6;
// Levels that change by less than this part of the contrast in a pass stay: a fiftieth of the half-step is a
// hundredth of a voxel on an edge of one voxel.
constexpr double kStays = 0.02;
constexpr double kMostVoxels = 3'000'000, kLeastEnough = 500'000;
constexpr std::size_t kLeakVoxels = 500'000;
constexpr double kParts[] = {1, 0.7, 0.5, 0.35, 0.25, 0.18, 0.12};
constexpr double kEnough = 25;
constexpr double kSudden = 1.5;
constexpr double kExplosion = 2;
constexpr double kLeastPart = 0.1;
constexpr double kContracts = 0.6;

//! Signed intensities along a line of voxels through a face of the region, from kReach voxels within to
//! kReach beyond the outer neighbour.
using Profile = std::array<double, 2 * kReach + 2>;

Profile profileAt(const SmoothedVolume& volume, const ObjectRegion& region, const ObjectRegion::Face& face,
                  double sign) {
  const auto axis = static_cast<std::size_t>(face.axis);
  const int last = volume.grid().size[axis] - 1;
  const ObjectRegion::Voxel& inner = region.voxels[static_cast<std::size_t>(face.voxel)];
  ObjectRegion::Voxel v = inner;
  Profile profile;
  for (int t = 0; t < static_cast<int>(profile.size()); ++t) {
    v[axis] = std::clamp(inner[axis] + face.step * (t - kReach), 0, last);
    profile[static_cast<std::size_t>(t)] = sign * static_cast<double>(volume.at(v[0], v[1], v[2]));
  }
  return profile;
}

double largestStep(const Profile& p) {
  double step = 0;
  for (std::size_t t = 1; t < p.size(); ++t) step = std::max(step, p[t] - p[t - 1]);
  return step;
}

LevelField levelsOf(const SmoothedVolume& volume, const ObjectRegion& region,
                    const std::vector<unsigned char>* kept, double sign, const LevelField& fallback) {
  std::vector<Profile> profiles;
  std::vector<Vec3> places;
  LevelField::Samples steps(volume.grid()), levels(volume.grid());
  for (const ObjectRegion::Face& face : region.faces) {
    const auto voxel = static_cast<std::size_t>(face.voxel);
    if (kept && !(*kept)[voxel]) continue;
    const ObjectRegion::Voxel& v = region.voxels[voxel];
    profiles.push_back(profileAt(volume, region, face, sign));
    places.emplace_back(v[0], v[1], v[2]);
    const double step = largestStep(profiles.back());
    steps.add(places.back(), step, step * step);
  }
  if (steps.empty()) return fallback;
  const LevelField typical = steps.spread();
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const Profile& p = profiles[i];
    double weight = 0, sum = 0;
    for (std::size_t t = 1; t < p.size(); ++t) {
      const double step = std::max(0.0, p[t] - p[t - 1]);
      weight += step * step;
      sum += step * step * 0.5 * (p[t] + p[t - 1]);
    }
    const double relative = largestStep(p) / (kWeaker * typical.at(places[i])), square = relative * relative;
    const double faceWeight = square / (1 + square * square * square);
    if (weight > 0) levels.add(places[i], sign * sum / weight, faceWeight);
  }
  return levels.empty() ? fallback : levels.spread();
}

//! Mean difference at the faces.
double meanChange(const ObjectRegion& region, const LevelField& a, const LevelField& b) {
  double sum = 0, n = 0;
  for (std::size_t i = 0; i < region.faces.size(); i += 16, n += 1) {
    const ObjectRegion::Voxel& v = region.voxels[static_cast<std::size_t>(region.faces[i].voxel)];
    const Vec3 at(v[0], v[1], v[2]);
    sum += std::abs(a.at(at) - b.at(at));
  }
  return n > 0 ? sum / n : 0;
}

}  // namespace

//! Number of voxels at which a flood may end: enough to see that it leaks.
std::size_t enoughVoxels(double expected) {
  return static_cast<std::size_t>(std::clamp(kEnough * expected, kLeastEnough, std::max(2 * expected, kMostVoxels)));
}

//! Out of all proportion to the place of the seeds the region has leaked, though no level tells where. The
//! neck shows at the one nearest to the object that still leaks.
std::optional<ObjectBoundary> boundaryWithNeck(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                                    double object, double level) {
  for (double part : kParts) {
    const double trial = object + part * (level - object);
    const ObjectRegion region = floodObject(volume, seeds, sign, LevelField(volume.grid(), trial), kLeakVoxels);
    std::optional<NeckCut> neck = findNeck(volume.grid(), region, seeds);
    if (getenv("DBG")) fprintf(stderr, "level %g voxels %zu neck %g of %g kept %g\n", trial, region.voxels.size(), neck ? neck->neckRadius : -1., neck ? neck->structureRadius : -1., neck ? neck->keptVolume : -1.);
    if (neck) return ObjectBoundary{LevelField(volume.grid(), trial), std::move(neck)};
  }
  return {};
}

ObjectBoundary findObjectBoundary(const SmoothedVolume& volume, const std::vector<Vec3>& seeds, double sign,
                                  double level, double contrast, double expectedVoxels) {
  ObjectBoundary out{LevelField(volume.grid(), level), {}};
  LevelField trial = out.levels;
  ObjectBoundary first = out;
  double expected = expectedVoxels, part = 1, lastChange = 0;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const ObjectRegion region = floodObject(volume, seeds, sign, trial, enoughVoxels(expected));
    std::optional<NeckCut> neck;
    if (static_cast<double>(region.voxels.size()) > kSudden * expected)
      neck = findNeck(volume.grid(), region, seeds);
    const double kept = neck ? neck->keptVolume / volume.grid().voxelVolume()
                             : static_cast<double>(region.voxels.size());
    if (getenv("DBG"))
      fprintf(stderr, "pass %d part %g expected %g voxels %zu kept %g neck %g levels %g..%g\n", pass, part, expected, region.voxels.size(), kept, neck ? neck->neckRadius : -1.0, trial.lowest(), trial.highest());
    if (pass > 0 && kept > kExplosion * expected) {
      // The new levels open a leak that no neck can stop: half the way to them.
      part *= 0.5;
      if (part < kLeastPart) break;
      trial = LevelField::between(out.levels, trial, 0.5);
      continue;
    }
    out.levels = trial;
    out.neck = neck;
    expected = kept;
    LevelField next = levelsOf(volume, region, neck ? &neck->kept : nullptr, sign, trial);
    const double change = meanChange(region, next, trial);
    if (getenv("DBG")) fprintf(stderr, "  change %g\n", change / contrast);
    if (pass >= 2 && change > kContracts * lastChange) {
      // No fixed point near: what changes along the boundary are the surroundings, not the gain.
      out = first;
      break;
    }
    lastChange = change;
    if (pass == 0) first = out;
    if (change <= kStays * contrast) {
      if (!neck) out.levels = next;
      break;
    }
    trial = LevelField::between(trial, next, part);
  }
  return out;
}

}  // namespace handlebody
