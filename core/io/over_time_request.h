#pragma once
// What a session says of a growth that is carried through the frames of a 4D volume.

#include <optional>

namespace handlebody {

//! How it is found out whether the surface drifts.
enum class DriftCheck {
  none,
  back,  //!< carried back from each end to the frame that was grown
  wrap   //!< the sequence is a cycle: carried from the last frame to the first
};

struct OverTimeRequest {
  //! Frames, both ends included, with that of the session's volume among them; none: all of the volume.
  struct Range {
    int first = 0, last = 0;
    bool operator==(const Range&) const = default;
  };
  std::optional<Range> frames{};
  bool holdTopology = true;
  DriftCheck drift = DriftCheck::back;
  std::optional<double> frameTime{};  //!< ms between frames, instead of what the file says
  bool operator==(const OverTimeRequest&) const = default;
};

}  // namespace handlebody
