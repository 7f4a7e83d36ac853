#pragma once
// What a session says of a growth that is carried through the frames of a 4D volume.

#include <optional>
#include <vector>

#include "core/sequence/drift.h"
#include "core/sequence/over_time.h"

namespace handlebody {

struct OverTimeRequest {
  //! Frames, both ends included, with that of the session's volume among them; none: all of the volume.
  struct Range {
    int first = 0, last = 0;
    bool operator==(const Range&) const = default;
  };
  std::optional<Range> frames{};
  bool holdTopology = true;
  DriftCheck drift = DriftCheck::back;
  std::vector<FrameCorrection> corrections{};  //!< in ascending order of frames
  std::optional<double> frameTime{};           //!< ms between frames, instead of what the file says
  bool operator==(const OverTimeRequest&) const = default;
};

}  // namespace handlebody
