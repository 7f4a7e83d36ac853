#pragma once

#include <optional>
#include <vector>

#include "core/collision/broad_phase.h"
#include "core/evolution/constraints.h"
#include "core/geometry/vec.h"

namespace handlebody {

//! A click: a ball inside the object, where the surface starts, or one in the background, where it may not
//! go.
struct Seed {
  Vec3 centre{0, 0, 0};            //!< mm, LPS
  std::optional<double> radius{};  //!< mm; none: what fits
  bool background = false;         //!< outside of the object
  bool operator==(const Seed&) const = default;
};

//! Those in the background, or those inside, in their order.
std::vector<Seed> seedsOfSide(const std::vector<Seed>& seeds, bool background);

enum class ObjectKind { automatic, dark, bright };
enum class Direction { outward, both };
//! How the target edge length depends on the place: everywhere the same, or longer where the image shows no
//! boundary near by (size_field.h). Automatic: longer where that saves steps, in objects that are wide for
//! their edges; what was used is one of the others.
enum class Resolution { automatic, uniform, adaptive };

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
  int candidate = 1;                   //!< of the objects that the clicks may mean, 1 = the likeliest
  std::optional<double> smoothing{};   //!< standard deviation of the Gaussian, mm; 0 = none
  std::optional<double> edgeLength{};  //!< target edge length, mm
  Direction direction = Direction::outward;
  double balloon = 1.0;    //!< weight of the balloon force, > 0
  double curvature = 0.2;  //!< weight of the curvature regularisation, >= 0
  int maxIterations = 3000;
  int threads = 0;  //!< 0 = all that the machine has; the mesh does not depend on it
  BroadPhase broadPhase = BroadPhase::sorted;  //!< of the detection; the mesh does not depend on it
  Resolution resolution = Resolution::automatic;
  bool operator==(const Parameters&) const = default;
};

//! True if both see the object in the image in the same way: changing from one to the other takes no
//! preparation.
bool chooseSameImage(Parameters a, const Parameters& b);

//! Throws UsageError if a parameter has no meaning.
void requireSensible(const Parameters& parameters);

//! True if both move a surface in the same way: all but the number of iterations, threads and broad phase.
bool moveAlike(Parameters a, const Parameters& b);

//! True if they differ in nothing but what the image shows, iterations, threads and broad phase.
bool haveSameForces(const Parameters& a, const Parameters& b);

//! What a growth is made of, besides the volume.
struct Request {
  std::vector<Seed> seeds;
  Parameters parameters{};
  Constraints constraints{};
  bool operator==(const Request&) const = default;
};

//! What holds from the step after `iteration` on.
struct ParameterChange {
  int iteration = 0;
  Parameters parameters{};
  std::optional<std::vector<Seed>> seeds{};  //!< none: the same as before
  std::optional<Constraints> constraints{};  //!< the same
};

//! What holds after a change of `before`.
Request changed(const Request& before, const ParameterChange& change);

//! Every parameter as used.
struct ResolvedParameters {
  ObjectKind object = ObjectKind::dark;
  IntensityRange range{};
  int candidate = 1;      //!< of `ActiveContour::candidates()`, as used
  double smoothing = 0;   //!< mm
  double edgeLength = 0;  //!< mm
  Direction direction = Direction::outward;
  double balloon = 1.0;
  double curvature = 0.2;
  int maxIterations = 3000;
  int threads = 1;
  BroadPhase broadPhase = BroadPhase::sorted;
  Resolution resolution = Resolution::uniform;
  std::vector<Seed> seeds;  //!< with their radii as used
};

}  // namespace handlebody
