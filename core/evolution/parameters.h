#pragma once

#include <optional>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! Where the surface starts: a ball inside the object.
struct Seed {
  Vec3 centre{0, 0, 0};            //!< mm, LPS
  std::optional<double> radius{};  //!< mm; none: what fits
  bool operator==(const Seed&) const = default;
};

enum class ObjectKind { automatic, dark, bright };
enum class Direction { outward, both };

//! Intensities of the object, both ends included; infinite ends are allowed.
struct IntensityRange {
  double low = 0;
  double high = 0;
  bool operator==(const IntensityRange&) const = default;
};

//! What a user may choose. Empty optionals are chosen from the image; `ResolvedParameters` says what was
//! used.
struct Parameters {
  ObjectKind object = ObjectKind::automatic;
  std::optional<IntensityRange> range{};
  std::optional<double> smoothing{};   //!< standard deviation of the Gaussian, mm; 0 = none
  std::optional<double> edgeLength{};  //!< target edge length, mm
  Direction direction = Direction::outward;
  double balloon = 1.0;    //!< weight of the balloon force, > 0
  double curvature = 0.2;  //!< weight of the curvature regularisation, >= 0
  int maxIterations = 3000;
  int threads = 1;
  bool operator==(const Parameters&) const = default;
};

//! Parameters that hold from the step after `iteration` on.
struct ParameterChange {
  int iteration = 0;
  Parameters parameters{};
};

//! Every parameter as used.
struct ResolvedParameters {
  ObjectKind object = ObjectKind::dark;
  IntensityRange range{};
  double smoothing = 0;   //!< mm
  double edgeLength = 0;  //!< mm
  Direction direction = Direction::outward;
  double balloon = 1.0;
  double curvature = 0.2;
  int maxIterations = 3000;
  int threads = 1;
  std::vector<Seed> seeds;  //!< with their radii as used
};

}  // namespace handlebody
