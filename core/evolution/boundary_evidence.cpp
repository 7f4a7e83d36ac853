#include "core/evolution/boundary_evidence.h"

#include <algorithm>
#include <cmath>

#include "core/evolution/object_region.h"
#include "core/evolution/seed_statistics.h"
#include "core/volume/intensity_statistics.h"

namespace handlebody {

namespace {

// Measured (docs/object.md, 8). On 23 phantoms, with noise and gain, it is at least 0.64. Of 108 boundaries
// in labelled real volumes twelve have more than kClear with no more noise and border than below; ten are
// about right, and the two others, of up to 0.53, no worse than what a click finds there.
constexpr double kBeyondDoubt = 0.58;
constexpr double kClear = 0.47;
constexpr double kPlausible = 0.4;
// A boundary no higher above the noise than three standard deviations may be noise; the phantoms come up to
// 0.23.
constexpr double kNoise = 0.35;
constexpr double kUnseen = 0.02;

constexpr std::size_t kVoxels = 3'000'000;
constexpr std::size_t kFaces = 100'000;  // evenly spread: enough for quantiles
constexpr double kOneInTen = 0.1;

//! Out of the region at a voxel with these faces: along their sum, so that a line along the boundary counts
//! for nothing; indices.
Vec3 outwards(const ObjectRegion::Face* first, const ObjectRegion::Face* last) {
  Vec3 sum(0, 0, 0);
  for (const ObjectRegion::Face* f = first; f != last; ++f) sum[f->axis] += f->step;
  if (sum.squaredNorm() > 0) return sum.normalized();
  sum[first->axis] = first->step;  // as thin as a voxel
  return sum;
}

//! Steps of intensity across the boundary, outwards, positive where they have the sense of the object: one
//! for each voxel on it. Precondition: the faces of a voxel follow each other.
std::vector<double> stepsAcross(const ObjectRegion& region, const SmoothedVolume& volume, double sign) {
  std::vector<double> steps;
  const std::size_t every = std::max<std::size_t>(1, region.faces.size() / kFaces);
  const ObjectRegion::Face *face = region.faces.data(), *end = face + region.faces.size();
  for (std::size_t n = 0; face != end; ++n) {
    const ObjectRegion::Face* next =
        std::find_if(face, end, [&](const auto& f) { return f.voxel != face->voxel; });
    if (n % every == 0) {
      const auto& voxel = region.voxels[static_cast<std::size_t>(face->voxel)];
      const Vec3 inner(voxel[0], voxel[1], voxel[2]), out = outwards(face, next);
      // A wall of one or two voxels is left again a voxel and a half away.
      const double outer =
          std::max(sign * volume.sample(inner + out), sign * volume.sample(inner + 1.5 * out));
      steps.push_back(outer - sign * volume.sample(inner - 0.5 * out));
    }
    face = next;
  }
  return steps;
}

bool isShown(const BoundaryEvidence& e, double least) {
  return e.weakest >= least && e.noise <= kNoise && e.unseen <= kUnseen;
}

}  // namespace

bool BoundaryEvidence::isBeyondDoubt() const { return isShown(*this, kBeyondDoubt); }
bool BoundaryEvidence::isClear() const { return isShown(*this, kClear); }
bool BoundaryEvidence::isPlausible() const { return isShown(*this, kPlausible); }

BoundaryEvidence evidenceOf(const ObjectChoice& choice, const std::vector<Seed>& seeds) {
  std::vector<Vec3> indices;
  for (const Seed& s : seeds) indices.push_back(choice.volume->grid().toIndex(s.centre));
  const double sign = choice.object == ObjectKind::dark ? 1 : -1;
  const ObjectRegion region = floodObject(*choice.volume, indices, sign, *choice.levels, kVoxels,
                                          choice.neck ? choice.neck->barrier.get() : nullptr);
  BoundaryEvidence out;
  const double radius = statisticsRadius(choice.volume->grid(), seeds);
  out.noise = robustDeviation(valuesNear(*choice.volume, seeds, radius)) / choice.contrast;
  const auto unseen = static_cast<double>(region.atBorder + region.againstPadding);
  if (unseen > 0) out.unseen = unseen / (unseen + static_cast<double>(region.faces.size()));
  const std::vector<double> steps = stepsAcross(region, *choice.volume, sign);
  const double median = steps.empty() ? 0 : quantile(steps, 0.5);
  if (median > 0) out.weakest = quantile(steps, kOneInTen) / median;
  return out;
}

}  // namespace handlebody
