#pragma once
// What a growth may be told: the options that `handlebody-cli segment` and the Python module share, each with
// its name, its help and what it sets.

#include <functional>
#include <string>
#include <vector>

#include "core/evolution/parameters.h"

namespace handlebody {

//! The kind of its value decides how it stands on a command line and in Python.
struct GrowthOption {
  std::string name;         //!< with dashes: "--edge-length"
  std::string type;         //!< as the help calls its value: "MM"
  std::string help;         //!< a sentence without a full stop
  bool isRepeated = false;  //!< it may be given several times
  //! Sets the parameter or adds the constraint that `text` says. A label map of walls gets its path alone
  //! (loadWalls). Throws UsageError that names the option.
  std::function<void(Parameters&, Constraints&, const std::string& text)> set{};
};

//! Parameters, in the order of the help.
const std::vector<GrowthOption>& parameterOptions();
//! Constraints, in the order of the help.
const std::vector<GrowthOption>& constraintOptions();
//! One of either; null if there is none of that name.
const GrowthOption* findGrowthOption(const std::string& name);

}  // namespace handlebody
