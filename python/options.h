#pragma once
// Keyword arguments as the options of the command line: the same names, with underscores, and the same
// checks, since their values go through the same text.

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "core/evolution/parameters.h"
#include "core/io/report/clicks.h"

namespace handlebody::python {

//! What a contour is asked for.
struct Asked {
  ClickTexts clicks{};
  Parameters parameters{};
  Constraints constraints{};
  std::vector<std::string> given{};  //!< what was set, as on the command line: "--edge-length"
};

//! None is as if the option were not given. What may be given several times is one value or a sequence of
//! them. Numbers are written so that they read back to the same bits. `walls` is a path. Throws TypeError for
//! a name that is no option and a value of the wrong type, UsageError, also for what can have no effect.
void readOptions(const pybind11::kwargs& options, Asked& asked);

//! All that readOptions knows.
std::vector<std::string> optionNames();

}  // namespace handlebody::python
