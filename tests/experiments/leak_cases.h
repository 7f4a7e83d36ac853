#pragma once
// Random runs that leak, and that do not, on the phantoms.

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/evolution/history.h"
#include "sample_volumes/phantom.h"

namespace handlebody::testing {

//! A run: a phantom of random size, place, noise and direction, and a click in it.
struct LeakCase {
  std::string name;
  PhantomOptions options;
  Parameters parameters;
  Seed seed;
};

class RandomCases {
 public:
  explicit RandomCases(unsigned seed) : engine_(seed) {}
  double uniform(double a, double b) { return a + (b - a) * static_cast<double>(engine_()) / 4294967296.0; }

  //! With what lies behind the passage. `gap`: voxels, of the wall.
  LeakCase leaking(const std::string& name) {
    LeakCase c = any(name, 0.15);
    if (name == "wall") c.options.gapVoxels = uniform(1, 8);
    c.parameters.range = IntensityRange{0, 120};
    c.seed.centre = inside(c, name == "wall" ? 11 : 6);
    return c;
  }
  LeakCase tight(const std::string& name) {
    LeakCase c = any(name, name == "cyst" ? 0.25 : 0.2);
    const Phantom p = makePhantom(name, c.options);
    c.seed = {p.seed, p.seedRadius};
    return c;
  }

 private:
  LeakCase any(const std::string& name, double mostNoise) {
    LeakCase c{name, {}, {}, {}};
    const double voxel = uniform(0.8, 1.25);
    c.options.spacing = Vec3::Constant(voxel);
    c.options.noise = uniform(0, mostNoise);
    for (int a = 0; a < 3; ++a) c.options.rotationDegrees[a] = uniform(-90, 90);
    c.options.randomSeed = static_cast<std::uint32_t>(uniform(1, 1e6));
    return c;
  }
  //! A click at least so many mm within the first chamber or ball, with a radius of 4 mm.
  Vec3 inside(LeakCase& c, double deep) {
    const Phantom p = makePhantom(c.name, c.options);
    c.seed.radius = 4;
    for (;;) {
      const Vec3 away(uniform(-20, 20), uniform(-20, 20), uniform(-20, 20));
      const Vec3 place = p.seed + away;
      if (along(p, place) < -15 && phantomDistance(c.name, c.options, place) < -deep) return place;
    }
  }

 public:
  //! mm along the line from the first chamber or ball to the second, from the middle between the two.
  static double along(const Phantom& p, const Vec3& world) {
    const Grid& g = p.volume.grid;
    const Vec3 middle = g.toWorld(0.5 * Vec3(g.size[0] - 1, g.size[1] - 1, g.size[2] - 1));
    return (world - middle).dot(g.direction.col(0));
  }
  //! The same, where the passage opens into the second.
  static double mouth(const std::string& name) {
    if (name == "wall") return 1;
    return name == "dumbbell" ? 26 - std::sqrt(16.0 * 16 - 6 * 6) : 24 - std::sqrt(16.0 * 16 - 2.5 * 2.5);
  }

 private:
  std::mt19937 engine_;
};

}  // namespace handlebody::testing
