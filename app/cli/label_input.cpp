#include "app/cli/label_input.h"

#include <CLI/CLI.hpp>

#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace {
constexpr int kLargestValue = 1 << 24;  // whole numbers up to here are exact in every voxel type
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
