#include "sample_volumes/placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/errors.h"

namespace handlebody::phantoms {
namespace {

constexpr double kMaxVoxels = 1e9;

// The message is a callable: distances are asked for by the million, and a text would cost more than they do.
template <typename Message>
void require(bool good, Message&& message) {
  if (!good) throw UsageError(message());
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void checkNumbers(const Shape& shape, const PhantomOptions& options) {
  require((options.spacing.array() > 0).all() && options.spacing.allFinite(),
          [&] { return "The phantom's spacing (--spacing) must be positive lengths in mm."; });
  require(options.spacing.maxCoeff() <= shape.thinnest / 2, [&] {
    return "A spacing (--spacing) of " + number(options.spacing.maxCoeff()) +
           " mm is too coarse for the phantom " + shape.name + ", whose thinnest part has " +
           number(shape.thinnest) + " mm; the most is " + number(shape.thinnest / 2) + " mm.";
  });
  require(options.rotationDegrees.allFinite(),
          [&] { return "The phantom's rotation (--rotate) must be three angles in degrees."; });
  require(std::isfinite(options.noise), [&] { return "The phantom's noise (--noise) must be a number."; });
  require(std::isfinite(options.bias) && options.bias >= 1, [&] {
    return "The phantom's bias (--bias) is the largest over the smallest gain and must be at least 1.";
  });
  require(std::isfinite(options.gapVoxels) && options.gapVoxels >= 0,
          [&] { return "The phantom's gap (--gap) must be a width in voxels, 0 or more."; });
  require(options.gapVoxels == 0 || shape.dark, [&] {
    return "The phantom " + shape.name +
           " has no wall that could have a gap (--gap); the phantom wall has one.";
  });
}

std::array<int, 3> gridSize(const Shape& shape, const PhantomOptions& options) {
  std::array<int, 3> size = options.size;
  double voxels = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const double h = options.spacing[axis];
    require(size[a] >= 0, [&] { return "The phantom's size (--size) must be three numbers of voxels."; });
    const double own = std::ceil(shape.extent[axis] / h - 1e-9);  // 1e-9: 100 mm at 0.1 mm are 1000 voxels
    voxels *= size[a] > 0 ? size[a] : own;
    require(voxels <= kMaxVoxels, [&] {
      return "The phantom would have more than " + number(kMaxVoxels) +
             " voxels; a larger --spacing or a smaller --size is needed.";
    });
    if (size[a] == 0) size[a] = static_cast<int>(own);
    // One voxel of background all round: the object's surface must be closed within the volume.
    const int least = static_cast<int>(std::ceil(2 * shape.objectHalf[axis] / h)) + 2;
    require(size[a] >= least, [&] {
      return "A size (--size) of " + number(size[a]) + " voxels of " + number(h) +
             " mm is too small for the phantom " + shape.name + "; axis " + number(axis) +
             " needs at least " + number(least) + ".";
    });
  }
  return size;
}

// A hole of whole voxels covers whole voxels, next to the centre of the wall.
Hole makeHole(const Shape& shape, const PhantomOptions& options, const Placement& place) {
  Hole hole;
  if (options.gapVoxels == 0) return hole;
  for (int side = 0; side < 2; ++side) {
    const int axis = side + 1;
    const double h = options.spacing[axis];
    const double first = std::floor((place.grid.size[axis] - std::ceil(options.gapVoxels)) / 2);
    hole.low[side] = place.corner[axis] + (first - 0.5) * h;
    hole.high[side] = hole.low[side] + options.gapVoxels * h;
    require(options.gapVoxels * h <= shape.objectHalf[axis], [&] {
      return "A gap (--gap) of " + number(options.gapVoxels) + " voxels is wider than half the wall.";
    });
  }
  return hole;
}

Eigen::Matrix3d rotation(const Vec3& degrees) {
  const Vec3 r = degrees * (std::numbers::pi / 180);
  return (Eigen::AngleAxisd(r.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(r.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(r.x(), Vec3::UnitX()))
      .toRotationMatrix();
}

}  // namespace

Placement placeShape(const Shape& shape, const PhantomOptions& options) {
  checkNumbers(shape, options);
  Placement place;
  place.grid.size = gridSize(shape, options);
  place.grid.spacing = options.spacing;
  if (!options.rotationDegrees.isZero(0)) place.grid.direction = rotation(options.rotationDegrees);
  // At 1 mm, without rotation and with the phantom's own size, voxel (0,0,0) lies at the world's 0.
  place.centre = (shape.extent - Vec3::Ones()) / 2;
  for (int a = 0; a < 3; ++a) place.corner[a] = -0.5 * (place.grid.size[a] - 1) * options.spacing[a];
  place.grid.origin = place.toWorld(place.corner);
  place.hole = makeHole(shape, options, place);
  return place;
}

}  // namespace handlebody::phantoms
