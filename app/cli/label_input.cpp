#include "app/cli/label_input.h"

#include <CLI/CLI.hpp>
#include <limits>

#include "core/io/meshes/mesh_io.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace {
constexpr int kLargestValue = 1 << 24;  // whole numbers up to here are exact in every voxel type
}

void addLabelOption(CLI::App& command, const std::string& name, std::string& label, const std::string& help) {
  const auto set = [&label, name](const std::string& text) {
    label = parseLabel(name, text, -kLargestValue, kLargestValue);
  };
  command.add_option_function<std::string>(name, set, help)->type_name("N|NAME");
}

void addLabelFrame(CLI::App& command, std::optional<int>& frame) {
  const auto set = [&frame](const std::string& text) {
    frame = parseInteger("--frame", text, 0, std::numeric_limits<int>::max());
  };
  command.add_option_function<std::string>("--frame", set, "Time point of a 4D label map, from 0")
      ->type_name("N");
}

LabelFile openLabels(const std::string& path, const std::optional<int>& frame) {
  LabelFile file(path, {}, frame);
  if (frame && file.info().layers > 1)
    throw OptionError("--frame", path + " has layers, not time points; --label chooses.");
  return file;
}

std::optional<int> labelOf(const std::string& path, const std::string& label) {
  return label.empty() || isMeshInputPath(path) ? std::nullopt : std::optional(labelCalled(path, label));
}

}  // namespace handlebody::cli
