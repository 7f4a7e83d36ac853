#include "tests/bench/peers/tuning.h"

namespace handlebody::bench {

namespace {

struct Tuned {
  const char* phantom;
  Peer peer;
  double sigma, curvature;
};

constexpr Tuned kTuned[] = {
    {"cyst", Peer::thresholdLevelSet, 1.5, 0.3},
    {"cyst", Peer::geodesicLevelSet, 2.0, 0.3},
    {"cyst", Peer::regionGrowing, 2.0, 0},
};

}  // namespace

PeerSettings tunedSettings(Peer peer, const std::string& phantom) {
  PeerSettings settings;
  for (const Tuned& t : kTuned)
    if (t.peer == peer && t.phantom == phantom) {
      settings.sigma = t.sigma;
      settings.curvature = t.curvature;
    }
  return settings;
}

}  // namespace handlebody::bench
