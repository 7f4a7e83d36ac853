#include "core/evolution/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/errors.h"
#include "core/evolution/step_report.h"

namespace handlebody {

std::vector<Seed> seedsOfSide(const std::vector<Seed>& seeds, bool background) {
  std::vector<Seed> out;
  std::copy_if(seeds.begin(), seeds.end(), std::back_inserter(out),
               [&](const Seed& s) { return s.background == background; });
  return out;
}

void requireSensible(const Parameters& p) {
  const auto require = [](bool ok, const char* message) {
    if (!ok) throw UsageError(message);
  };
  require(p.balloon > 0 && std::isfinite(p.balloon), "The balloon weight must be a number above 0.");
  require(p.curvature >= 0 && std::isfinite(p.curvature),
          "The curvature weight must be a number of at least 0.");
  require(p.maxIterations >= 0, "The number of iterations must not be negative.");
  require(p.threads >= 0 && p.threads <= 1024, "The number of threads must be between 0 and 1024.");
  require(!p.smoothing || (*p.smoothing >= 0 && std::isfinite(*p.smoothing)),
          "The smoothing must be at least 0 mm.");
  require(!p.edgeLength || (*p.edgeLength > 0 && std::isfinite(*p.edgeLength)),
          "The edge length must be above 0 mm.");
}

bool moveAlike(Parameters a, const Parameters& b) {
  a.maxIterations = b.maxIterations;
  a.threads = b.threads;
  a.broadPhase = b.broadPhase;
  return a == b;
}

bool haveSameForces(const Parameters& a, const Parameters& b) {
  return a.edgeLength == b.edgeLength && a.direction == b.direction && a.balloon == b.balloon &&
         a.curvature == b.curvature && a.resolution == b.resolution;
}

// What does not matter to the image is listed here, so that a parameter that nobody thought of does.
bool chooseSameImage(Parameters a, const Parameters& b) {
  a.edgeLength = b.edgeLength;
  a.direction = b.direction;
  a.balloon = b.balloon;
  a.curvature = b.curvature;
  a.resolution = b.resolution;
  return moveAlike(a, b);
}

Request changed(const Request& before, const ParameterChange& change) {
  return {change.seeds.value_or(before.seeds), change.parameters,
          change.constraints.value_or(before.constraints)};
}

const char* stopReasonName(StopReason reason) {
  switch (reason) {
    case StopReason::converged:
      return "converged";
    case StopReason::maxIterations:
      return "max-iterations";
    case StopReason::empty:
      return "empty";
    case StopReason::frozen:
      return "frozen";
    case StopReason::stuck:
      return "stuck";
    case StopReason::given:
      return "given";
    default:
      return "running";
  }
}

}  // namespace handlebody
