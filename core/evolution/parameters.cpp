#include "core/evolution/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/evolution/step_report.h"
#include "core/told_error.h"

namespace handlebody {

std::vector<Seed> seedsOfSide(const std::vector<Seed>& seeds, bool background) {
  std::vector<Seed> out;
  std::copy_if(seeds.begin(), seeds.end(), std::back_inserter(out),
               [&](const Seed& s) { return s.background == background; });
  return out;
}

void requireSensible(const Parameters& p) {
  using K = FindingKind;
  const auto require = [](bool ok, K kind) {
    if (!ok) throw Told<UsageError>(kind);
  };
  require(p.balloon > 0 && std::isfinite(p.balloon), K::balloonNotPositive);
  require(p.curvature >= 0 && std::isfinite(p.curvature), K::curvatureNegative);
  require(p.maxIterations >= 0, K::iterationsNegative);
  require(p.threads >= 0 && p.threads <= 1024, K::threadsOutside);
  require(!p.smoothing || (*p.smoothing >= 0 && std::isfinite(*p.smoothing)), K::smoothingNegative);
  require(!p.edgeLength || (*p.edgeLength > 0 && std::isfinite(*p.edgeLength)), K::edgeNotPositive);
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
