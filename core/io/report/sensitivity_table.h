#pragma once
// Sensitivity as a table.

#include <string>

#include "core/sensitivity/sensitivity.h"

namespace handlebody {

//! The runs as CSV (csvLine): run, volume_ml, components, genus, mean_distance_mm, failure.
//! Of one that left no surface only the last is filled.
std::string sensitivityCsv(const Sensitivity& s);

}  // namespace handlebody
