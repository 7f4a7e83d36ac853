#pragma once
// Objects from label maps, for `compare` and `mesh`.

#include <optional>
#include <string>
#include <vector>

#include "core/io/volume_io.h"
#include "core/solid/mask.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

//! The volume, with the warnings of its file added to `warnings`. Throws InputError, also if a voxel is no
//! whole number.
LoadedVolume readLabels(const std::string& path, std::vector<std::string>& warnings);

//! Adds an option that takes a label's value.
void addLabelOption(CLI::App& command, const std::string& name, std::optional<int>& label,
                    const std::string& help);

}  // namespace handlebody::cli
