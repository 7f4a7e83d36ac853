#pragma once
// How intensities become colours.

#include <array>
#include <cstdint>

#include "core/evolution/parameters.h"
#include "core/volume/volume.h"
#include "ui/view/view_state.h"

namespace handlebody::ui {

//! 0xffRRGGBB from the lower to the upper end of the window.
using ColourTable = std::array<std::uint32_t, 256>;

//! `contrast` runs through many hues (black, indigo, blue, green, yellow, white), so that small differences
//! of intensity are seen, as in the paper's Figure 9. All but `inverted` grow lighter with every step.
const ColourTable& colourTable(ColourMap map);

//! Intensity → entry of a colour table; below and above the window the ends.
struct WindowLevel {
  double window = 1;  //!< > 0
  double level = 0;   //!< the middle
  int entry(double intensity) const;
};

//! What a drag of the mouse makes of a window: to the right wider, upwards brighter. In logical pixels, y
//! down; 250 of them to the right widen it by a factor of e.
WindowLevel draggedWindow(const WindowLevel& start, double dx, double dy);

//! The 0.1 and 99.9 percentiles of at most about a million voxels spread evenly over the volume, so that it
//! takes milliseconds for any volume. Precondition: it has voxels, none of them NaN.
IntensityRange displayRange(const Volume& volume);
//! The window over a range; of width 1 about it if it is empty.
WindowLevel windowOver(const IntensityRange& range);

}  // namespace handlebody::ui
