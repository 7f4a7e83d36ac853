#pragma once
// Runs the systems on a phantom, each in a child process.

#include "core/evolution/parameters.h"
#include "tests/bench/peers/outcome.h"
#include "tests/bench/peers/peer.h"

namespace handlebody::bench {

//! Our engine. With default parameters nothing is tuned.
Outcome runOurs(const Phantom& phantom, const PhantomOptions& options, const Parameters& parameters,
                int repeat);

//! The settings with threshold and iterations, found with the truth in hand: the threshold with the best
//! overlap of region growing, the fewest iterations whose overlap is the best to 0.0005.
PeerSettings completed(Peer peer, PeerSettings settings, const Phantom& phantom);

//! A peer with complete settings.
Outcome runPeer(Peer peer, const PeerSettings& settings, const Phantom& phantom,
                const PhantomOptions& options, int repeat);

//! What tune() tries: every smoothing (voxels) with every curvature weight.
struct Trials {
  std::vector<double> smoothings{0.7, 1.0, 1.5, 2.0, 2.5};
  std::vector<double> curvatures{0.05, 0.2, 0.5, 1.0, 2.0};
};

//! Returns the settings of the best overlap.
PeerSettings tune(Peer peer, const Phantom& phantom, const Trials& trials);

}  // namespace handlebody::bench
