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
    // Found by --tune: the best of smoothings 0.7, 1, 1.5 with weights 0.05, 0.5, 1, 2 on the gap of 3 voxels
    // (geodesic: of the first two weights at 0.7 and of two more at 1; region growing: of 0.7 to 2.5).
    {"wall", Peer::thresholdLevelSet, 0.7, 0.5},
    {"wall", Peer::geodesicLevelSet, 0.7, 0.5},
    {"wall", Peer::regionGrowing, 1.0, 0},
    // Of 0.7 and 1 with 0.05 and 0.2; region growing of 0.7 to 2.5.
    {"tree", Peer::thresholdLevelSet, 0.7, 0.05},
    {"tree", Peer::regionGrowing, 0.7, 0},
    {"cube", Peer::regionGrowing, 0.7, 0},
    {"torus", Peer::regionGrowing, 0.7, 0},
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
