#include "core/evolution/edge_profile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handlebody {

namespace {

using Voxel = ObjectRegion::Voxel;

// Voxels on either side of a face that say how high the edge is.
constexpr int kReach = 1;
constexpr std::size_t kProfile = 2 * kReach + 2;
// Variance of a voxel's own width, voxels².
constexpr double kVoxelVariance = 1.0 / 12;
// Curvature (sum of the principal ones, per voxel) at which a place counts half: a radius of one and a half
// voxels is a corner, or noise, and no smooth boundary.
constexpr double kCorner = 0.7;

Vec3 placeOf(const Voxel& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

}  // namespace

//! What a voxel says; signed intensities.
struct EdgeReader::Look {
  double value = 0;
  double rise = 0;         // what a second smoothing would add
  Vec3 gradient{0, 0, 0};  // per mm
};

EdgeReader::EdgeReader(const SmoothedVolume& volume, double sign) : volume_(volume), sign_(sign) {
  for (int a = 0; a < 3; ++a) {
    const double sigma = volume.sigma() / volume.grid().spacing[a];
    again_[a] = 0.5 * (sigma * sigma + kVoxelVariance);
  }
  perCurvature_ = again_.mean() * volume.grid().meanSpacing();
}

//! At the border of the volume no further.
Voxel EdgeReader::moved(Voxel v, std::size_t axis, int steps) const {
  v[axis] = std::clamp(v[axis] + steps, 0, volume_.grid().size[axis] - 1);
  return v;
}

EdgeReader::Look EdgeReader::lookAt(const Voxel& v) const {
  Look look;
  look.value = value(v);
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double before = value(moved(v, axis, -1)), after = value(moved(v, axis, 1));
    look.rise += again_[a] * (before + after - 2 * look.value);
    look.gradient[a] = (after - before) / (2 * volume_.grid().spacing[a]);
  }
  return look;
}

std::optional<ImageEdge> EdgeReader::halfWay(const Voxel& inner, const ObjectRegion::Face& face) const {
  const auto axis = static_cast<std::size_t>(face.axis);
  double weight = 0, sum = 0, largest = 0;
  double before = value(moved(inner, axis, -kReach * face.step));
  for (int t = 1; t < static_cast<int>(kProfile); ++t) {
    const double here = value(moved(inner, axis, (t - kReach) * face.step));
    const double step = std::max(0.0, here - before);
    weight += step * step;
    sum += step * step * 0.5 * (here + before);
    largest = std::max(largest, step);
    before = here;
  }
  if (!(weight > 0)) return {};
  return ImageEdge{placeOf(inner), sum / weight, largest};
}

std::optional<ImageEdge> EdgeReader::halfWayAlong(const Voxel& inner, const ObjectRegion::Face& face) const {
  return read(inner, face, 0);
}

std::optional<ImageEdge> EdgeReader::ofShape(const Voxel& inner, const ObjectRegion::Face& face) const {
  return read(inner, face, 1);
}

std::optional<ImageEdge> EdgeReader::read(const Voxel& inner, const ObjectRegion::Face& face,
                                          double again) const {
  const auto axis = static_cast<std::size_t>(face.axis);
  double weight = 0, sum = 0, largest = 0, aligned = 0, rise = 0, slope = 0;
  Look before = lookAt(moved(inner, axis, -kReach * face.step));
  for (int t = 1; t < static_cast<int>(kProfile); ++t) {
    const Look here = lookAt(moved(inner, axis, (t - kReach) * face.step));
    const double step = std::max(0.0, here.value - before.value), square = step * step;
    const Vec3 gradient = here.gradient + before.gradient;
    const double steepness = gradient.squaredNorm();
    weight += square;
    sum += square * (here.value + before.value);
    rise += square * (here.rise + before.rise);
    slope += square * std::sqrt(steepness);
    if (square > 0 && steepness > 0)
      aligned += square * gradient[face.axis] * gradient[face.axis] / steepness;
    largest = std::max(largest, step);
    before = here;
  }
  if (!(aligned > 0)) return {};
  aligned /= weight;  // cos² of the angle between the line and the normal
  const double corner = rise / (kCorner * perCurvature_ * slope);
  return ImageEdge{placeOf(inner), 0.5 * (sum + again * rise) / weight, largest / std::sqrt(aligned),
                   aligned * aligned / (1 + corner * corner)};
}

}  // namespace handlebody
