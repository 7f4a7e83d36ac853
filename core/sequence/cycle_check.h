#pragma once
// Whether a surface that was carried through the frames comes back as it was.

#include <functional>
#include <vector>

#include "core/sequence/drift.h"
#include "core/sequence/over_time.h"

namespace handlebody {

//! `frames`: those of the range, in its order, with `start`'s among them. Carries the surfaces back to
//! `start`'s frame from the last one on each side that is trusted, or from the last frame to the first
//! (DriftCheck::wrap). `edgeLength`: mm. `told` is called with each frame on the way. Throws as
//! FrameCarrier::carry.
std::vector<Drift> checkCycle(const FrameCarrier& carrier, const std::vector<FrameResult>& frames,
                              const FrameResult& start, DriftCheck check, double edgeLength,
                              const std::function<void(const FrameResult&)>& told = {});

}  // namespace handlebody
