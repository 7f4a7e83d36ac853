#pragma once
// The option that chooses a label, for `compare` and `mesh`.

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace handlebody::cli {

//! Adds an option that takes a label's value.
void addLabelOption(CLI::App& command, const std::string& name, std::optional<int>& label,
                    const std::string& help);

}  // namespace handlebody::cli
