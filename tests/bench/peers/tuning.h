#pragma once
// What the peers are told: found once with `bench_peers --tune`, for each image.

#include <string>

#include "tests/bench/peers/peer.h"

namespace handlebody::bench {

//! The smoothing and weights with the best overlap on the named phantom (its own noise, no bias); the general
//! ones for phantoms that are not listed. Iterations and threshold are left open: bench_peers finds them
//! before every timed run.
PeerSettings tunedSettings(Peer peer, const std::string& phantom);

}  // namespace handlebody::bench
