#pragma once
// How many decimals lengths in mm need, so that a voxel can be told from the next one.

#include "core/volume/volume.h"

namespace handlebody::ui {

//! Of places: 1, or as many as the finest spacing needs.
int placeDecimals(const Grid& grid);
//! Of lengths that are entered: one more.
int lengthDecimals(double voxel);
int lengthDecimals(const Grid& grid);

}  // namespace handlebody::ui
