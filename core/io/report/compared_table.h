#pragma once
// What `compare` found, as text and CSV; as JSON in core/io/report/compared.h.

#include <string>

#include "core/io/report/compared.h"

namespace handlebody {

//! A table for the eye, with units.
std::string comparisonText(const ComparedPair& pair);
//! A line of names and one of values.
std::string comparisonCsv(const ComparedPair& pair);

}  // namespace handlebody
