#pragma once
// The volume of an object over time, and what cardiologists read from it.

#include <optional>
#include <vector>

namespace handlebody {

//! Volume in one frame.
struct VolumePoint {
  int frame = 0;                   //!< time point of the sequence, from 0
  std::optional<double> time{};    //!< ms; none: not known
  std::optional<double> volume{};  //!< mm³; none: there is no surface
  bool isTrusted = true;           //!< false: something went wrong there (FrameFault)
};

struct VolumeCurve {
  std::vector<VolumePoint> points;  //!< in the order of frames
  //! Indices into `points`: the largest and the smallest volume of those that are trusted, the first of equal
  //! ones. None if fewer than two are.
  std::optional<std::size_t> endDiastole{}, endSystole{};
  double strokeVolume = 0;      //!< mm³: largest minus smallest
  double ejectionFraction = 0;  //!< of the largest, 0 … 1
};

//! `points` in the order of frames.
VolumeCurve volumeCurve(std::vector<VolumePoint> points);

}  // namespace handlebody
