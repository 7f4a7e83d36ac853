#include "app/cli/label_input.h"

#include <CLI/CLI.hpp>

#include "app/cli/parse.h"

namespace handlebody::cli {

namespace {
constexpr int kLargestValue = 1 << 24;  // whole numbers up to here are exact in every voxel type
}

LoadedVolume readLabels(const std::string& path, std::vector<std::string>& warnings) {
  auto loaded = loadVolume(path);
  for (const std::string& w : loaded->info.warnings) warnings.push_back(path + ": " + w);
  if (!holdsWholeNumbers(loaded->volume))
    throw InputError(path + ": it is no label map: it has voxels whose values are no whole numbers.");
  return std::move(*loaded);
}

void addLabelOption(CLI::App& command, const std::string& name, std::optional<int>& label,
                    const std::string& help) {
  command
      .add_option_function<std::string>(
          name,
          [&label, name](const std::string& t) {
            label = parseInteger(name, t, -kLargestValue, kLargestValue);
          },
          help)
      ->type_name("N");
}

}  // namespace handlebody::cli
