#pragma once
// What `compare` found, as text, JSON and CSV.

#include <optional>
#include <string>
#include <vector>

#include "core/solid/comparison.h"

namespace handlebody::cli {

struct ComparedObject {
  std::string path;
  std::optional<int> label;  //!< asked for, of a label map
  Solid solid;
};

struct ComparedPair {
  ComparedObject a, b;
  Comparison found;
  std::vector<std::string> warnings;  //!< of the files, then those of the comparison
};

//! A table for the eye, with units.
std::string comparisonText(const ComparedPair& pair);
std::string comparisonJson(const ComparedPair& pair);
//! A line of names and one of values.
std::string comparisonCsv(const ComparedPair& pair);

}  // namespace handlebody::cli
