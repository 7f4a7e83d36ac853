#pragma once
// The options that choose a label and a time point, for `compare` and `mesh`.

#include <optional>
#include <string>

#include "core/io/report/label_file.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

//! Adds an option that takes a label's number or name.
void addLabelOption(CLI::App& command, const std::string& name, std::string& label, const std::string& help);

//! Adds --frame: the time point of label maps that have several.
void addLabelFrame(CLI::App& command, std::optional<int>& frame);

//! A label map, or that time point of it. Throws as LabelFile, and UsageError for a time point of layers.
LabelFile openLabels(const std::string& path, const std::optional<int>& frame);

//! Its number; none if none was given, and of a mesh. Throws InputError (labelCalled).
std::optional<int> labelOf(const std::string& path, const std::string& label);

}  // namespace handlebody::cli
