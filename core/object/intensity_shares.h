#pragma once
// How often intensities occur, for the odds of inside against outside.

#include <vector>

namespace handlebody {

//! A histogram of intensities, smoothed, as a share per bin; a bin in which nothing is has a little, too.
std::vector<double> intensityShares(const std::vector<double>& histogram);

}  // namespace handlebody
