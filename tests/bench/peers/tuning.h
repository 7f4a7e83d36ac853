#pragma once
// What the peers are told unless `bench_peers --tune` looks for better settings first.

#include <string>

#include "tests/bench/peers/peer.h"

namespace handlebody::bench {

//! Smoothing and weights for the named phantom (its own noise, no bias), by hand where nothing else is said;
//! the general ones for phantoms that are not listed. Iterations and threshold are left open: bench_peers
//! finds them with the truth before every timed run.
PeerSettings tunedSettings(Peer peer, const std::string& phantom);

}  // namespace handlebody::bench
