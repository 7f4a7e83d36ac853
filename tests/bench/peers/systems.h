#pragma once
// Runs the systems on a phantom, each in a child process.

#include "core/evolution/parameters.h"
#include "tests/bench/peers/outcome.h"
#include "tests/bench/peers/peer.h"

namespace handlebody::bench {

//! Our engine. With default parameters nothing is tuned.
Outcome runOurs(const Phantom& phantom, const PhantomOptions& options, const Parameters& parameters,
                int repeat);

//! A peer; `settings` complete but for the iterations and the threshold, which are found here with the truth
//! in hand and not timed: the threshold with the best overlap of region growing, the fewest iterations whose
//! overlap is the best to 0.0005.
Outcome runPeer(Peer peer, PeerSettings settings, const Phantom& phantom, const PhantomOptions& options,
                int repeat);

//! Tries smoothings and curvature weights and returns those of the best overlap.
PeerSettings tune(Peer peer, const Phantom& phantom);

}  // namespace handlebody::bench
