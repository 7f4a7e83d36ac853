#include "sample_volumes/beating.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "core/errors.h"
#include "sample_volumes/rendering.h"

namespace handlebody {
namespace {

using std::numbers::pi;

constexpr double kAcross = 23, kAlong = 38;     // mm: half axes of the cavity at end diastole
constexpr double kWall = 9;                     // mm, the same
constexpr double kLobes = 0.1;                  // of the radius
constexpr double kSurroundings = 0.45;          // contrasts: between cavity (0) and wall (1)
constexpr double kMargin = 4;                   // mm around the wall
constexpr double kSystole = 0.35, kFull = 0.8;  // of the period
constexpr double kWidest = 4;                   // mm, spacing: half of the thinnest wall
constexpr double kNoise = 0.1, kSpeckle = 0.2;  // of the contrast: as in the phantom cyst
constexpr double kMaxFrames = 10000;

const Vec3 kHalf(kAcross*(1 + kLobes) + kWall + kMargin, kAcross*(1 + kLobes) + kWall + kMargin,
                 kAlong + kWall + kMargin);

void require(bool good, const std::string& message) {
  if (!good) throw UsageError(message);
}

void check(const BeatingOptions& o) {
  const PhantomOptions& i = o.image;
  require(o.frames >= 2 && o.frames <= kMaxFrames, "The beating phantom has 2 to 10000 frames (--frames).");
  require(o.ejection >= 0 && o.ejection <= 0.8, "The ejection fraction (--ejection) is 0 to 80 per cent.");
  require(std::isfinite(o.period) && o.period > 0, "The period (--period) is above 0 ms.");
  require(std::isfinite(o.torsion) && std::abs(o.torsion) <= 90,
          "The torsion (--torsion) is at most 90 degrees.");
  require(i.gapVoxels == 0 && i.bias == 1, "The phantom beating has no --gap and no --bias.");
  require(std::isfinite(i.noise), "The phantom's noise (--noise) must be a number.");
  require((i.spacing.array() > 0).all() && i.spacing.maxCoeff() <= kWidest,
          "The spacing (--spacing) of the phantom beating is above 0 and at most 4 mm.");
  require(i.rotationDegrees.allFinite(),
          "The phantom's rotation (--rotate) must be three angles in degrees.");
  phantoms::requirePhantomType(i.type);
}

Grid gridOf(const PhantomOptions& o) {
  constexpr double kMaxVoxels = 1e9;
  Grid grid;
  grid.spacing = o.spacing;
  double voxels = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double own = std::ceil(2 * kHalf[static_cast<int>(a)] / o.spacing[static_cast<int>(a)]);
    require(o.size[a] == 0 || o.size[a] >= own - 2 * kMargin / o.spacing[static_cast<int>(a)],
            "The size (--size) of the phantom beating is too small for its wall.");
    voxels *= o.size[a] > 0 ? o.size[a] : own;
    require(voxels <= kMaxVoxels,
            "The phantom would have more than 1e9 voxels; a larger --spacing is needed.");
    grid.size[a] = o.size[a] > 0 ? o.size[a] : static_cast<int>(own);
  }
  const Vec3 r = o.rotationDegrees * (pi / 180);
  grid.direction = (Eigen::AngleAxisd(r.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(r.y(), Vec3::UnitY()) *
                    Eigen::AngleAxisd(r.x(), Vec3::UnitX()))
                       .toRotationMatrix();
  return grid;
}

//! 0 at end diastole, 1 at end systole; `phase` of the period.
double contraction(double phase) {
  if (phase < kSystole) return 0.5 - 0.5 * std::cos(pi * phase / kSystole);
  if (phase < kFull) return 0.5 + 0.5 * std::cos(pi * (phase - kSystole) / (kFull - kSystole));
  return 0;
}

double ellipsoid(double across, double along) { return 4.0 / 3 * pi * across * across * along; }

//! How much thicker than the cavity the outer ellipsoid is, so that the wall keeps its volume.
double wallThickness(double across, double along, double volume) {
  double low = 0, high = 4 * kWall;
  for (int i = 0; i < 60; ++i) {
    const double d = 0.5 * (low + high);
    (ellipsoid(across + d, along + d) - ellipsoid(across, along) < volume ? low : high) = d;
  }
  return low;
}

}  // namespace

//! The shape at one time.
struct BeatingPhantom::Moment {
  double across, along, wall;  // mm
  double twist;                // radians per mm along z

  //! 0 on the surface that is `out` mm outside of the cavity's, negative within.
  double implicit(const Vec3& p, double out) const {
    const double angle = 3 * (std::atan2(p.y(), p.x()) - twist * p.z());
    const double radius = across * (1 + kLobes * std::cos(angle)) + out;
    const double r = std::hypot(p.x(), p.y());
    return std::hypot(r / radius, p.z() / (along + out)) - 1;
  }
  //! First-order signed distance, mm, and the normal.
  double distance(const Vec3& p, double out, Vec3& normal) const {
    constexpr double kStep = 1e-3;  // mm
    for (int a = 0; a < 3; ++a)
      normal[a] =
          (implicit(p + kStep * Vec3::Unit(a), out) - implicit(p - kStep * Vec3::Unit(a), out)) / (2 * kStep);
    const double slope = std::max(normal.norm(), 1e-9);
    normal /= slope;
    return implicit(p, out) / slope;
  }
};

BeatingPhantom::BeatingPhantom(const BeatingOptions& options) : options_(options) {
  check(options_);
  if (options_.image.noise < 0) options_.image.noise = options_.speckle ? kSpeckle : kNoise;
  grid_ = gridOf(options_.image);
  centre_ = kHalf;
  Vec3 corner;
  for (int a = 0; a < 3; ++a) corner[a] = 0.5 * (grid_.size[a] - 1) * grid_.spacing[a];
  grid_.origin = centre_ - grid_.direction * corner;
}

BeatingPhantom::Moment BeatingPhantom::moment(int frame) const {
  const double s = contraction(static_cast<double>(frame) / options_.frames);
  const double part = 1 - options_.ejection * s;
  Moment m{};
  m.across = kAcross * std::pow(part, 0.4);
  m.along = kAlong * std::pow(part, 0.2);
  const double wall = ellipsoid(kAcross + kWall, kAlong + kWall) - ellipsoid(kAcross, kAlong);
  m.wall = wallThickness(m.across, m.along, wall);
  m.twist = s * options_.torsion * (pi / 180) / (2 * kAlong);
  return m;
}

Vec3 BeatingPhantom::seed() const { return centre_; }

double BeatingPhantom::time(int frame) const { return options_.period * frame / options_.frames; }

double BeatingPhantom::volume(int frame) const {
  const Moment m = moment(frame);
  return ellipsoid(m.across, m.along) * (1 + kLobes * kLobes / 2);
}

double BeatingPhantom::sampledEjection() const {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (int f = 0; f < options_.frames; ++f) {
    least = std::min(least, volume(f));
    most = std::max(most, volume(f));
  }
  return (most - least) / most;
}

double BeatingPhantom::distance(int frame, const Vec3& world) const {
  Vec3 normal;
  return moment(frame).distance(grid_.direction.transpose() * (world - centre_), 0, normal);
}

Volume BeatingPhantom::image(int frame) const {
  const Moment m = moment(frame);
  std::vector<float> signal(grid_.voxelCount());
  std::size_t i = 0;
  for (int z = 0; z < grid_.size[2]; ++z)
    for (int y = 0; y < grid_.size[1]; ++y)
      for (int x = 0; x < grid_.size[0]; ++x, ++i) {
        const Vec3 p = grid_.direction.transpose() * (grid_.toWorld(Vec3(x, y, z)) - centre_);
        const auto inside = [&](double out) {
          Vec3 normal;
          const double d = m.distance(p, out, normal);
          return phantoms::coveredPart(d, normal, grid_.spacing);
        };
        signal[i] = static_cast<float>(1 - inside(0) - (1 - kSurroundings) * (1 - inside(m.wall)));
      }
  const PhantomOptions& o = options_.image;
  const auto kind = options_.speckle ? phantoms::NoiseKind::speckle : phantoms::NoiseKind::white;
  const std::uint64_t seed =
      static_cast<std::uint64_t>(o.randomSeed) * 100'003 + static_cast<std::uint64_t>(frame);
  if (o.noise > 0) phantoms::addNoise(kind, grid_, o.noise, seed, signal);
  return phantoms::toVolume(grid_, o.type, signal);
}

Volume BeatingPhantom::truth(int frame) const {
  const Moment m = moment(frame);
  void* buffer = nullptr;
  Volume truth = makeVolume(grid_, VoxelType::uint8, &buffer);
  auto* to = static_cast<std::uint8_t*>(buffer);
  for (int z = 0; z < grid_.size[2]; ++z)
    for (int y = 0; y < grid_.size[1]; ++y)
      for (int x = 0; x < grid_.size[0]; ++x)
        *to++ = m.implicit(grid_.direction.transpose() * (grid_.toWorld(Vec3(x, y, z)) - centre_), 0) < 0;
  return truth;
}

}  // namespace handlebody
