#pragma once
// When the time points of a 4D volume were taken.

#include <string>
#include <vector>

#include "core/io/formats/volume_io.h"

namespace handlebody {

struct TimeAxis {
  std::vector<double> milliseconds{};  //!< one per time point, ascending; empty: the file does not say
  std::string source{};                //!< the tag or header field; "given"
};

//! Nothing of it if there are fewer than two time points, or the times are not one per time point, finite and
//! ascending.
TimeAxis checkedTimes(int frames, std::vector<double> milliseconds, const std::string& source);
//! From 0 on; nothing if the step is not above 0.
TimeAxis evenTimes(int frames, double step, const std::string& source);

//! The step between neighbours (ms) if they all are the same to a thousandth of it; else, and if nothing is
//! known, 0.
double evenStep(const TimeAxis& times);

//! Of a file or folder. Reads headers only. Throws as inspectVolume, and InputError where that would list
//! several series.
TimeAxis readTimeAxis(const std::string& path, const VolumeSelection& selection = {});

}  // namespace handlebody
