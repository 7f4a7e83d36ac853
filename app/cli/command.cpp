#include "app/cli/command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "core/io/report/json.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace {

constexpr std::array<std::string_view, 12> kPathTypes{"OUT",      "DIR",           "FOLDER",   "F",
                                                      "DIST.vtp", "LABEL",         "LABELMAP", "MESH",
                                                      "MESH2",    "MESH|LABELMAP", "PATH",     "VOLUME"};

}  // namespace

CLI::App* addCommand(CLI::App& app, const std::string& name, const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->footer(kNotice);
  return command;
}

namespace {

//! By what the help calls its value.
bool isPath(const CLI::Option& option) {
  const std::string& type = option.get_type_name();
  return type.starts_with("F.") || std::find(kPathTypes.begin(), kPathTypes.end(), type) != kPathTypes.end();
}

std::string nameOf(const CLI::Option& option) {
  const auto& shorter = option.get_snames();
  return shorter.empty() ? "--" + option.get_lnames().at(0) : "-" + shorter[0];
}

}  // namespace

void checkPaths(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      option->check([name = option->get_name()](const std::string& text) -> std::string {
        if (text.empty()) throw OptionError(name, "it is empty.");
        return {};
      });
      continue;
    }
    if (!isPath(*option)) continue;
    option->check([&command, name = nameOf(*option)](const std::string& text) -> std::string {
      if (text.empty()) throw OptionError(name, "the path is empty.");
      if (text.starts_with("--") || (text.starts_with("-") && command.get_option_no_throw(text)))
        throw OptionError(name,
                          "'" + text + "' is no path but an option; a file of that name is ./" + text + ".");
      return {};
    });
  }
}

void addAnonymous(CLI::App& command, bool& isAnonymous) {
  command.add_flag("--anonymous", isAnonymous,
                   "Leave names, dates and identifiers of the source out of every file, and of what is "
                   "printed: paths, and names of objects that are those of their files");
}

void addMovedFiles(CLI::App& command, InputPaths& inputs) {
  const auto add = [&](const char* name, const char* type, const char* what,
                       std::vector<std::string>& paths) {
    command
        .add_option(name, paths,
                    std::string(what) + ", if the session does not say where that is now (repeatable)")
        ->type_name(type)
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
  };
  add("--walls", "LABELMAP", "The label map of its walls", inputs.walls);
  add("--start", "MESH|LABELMAP", "The mesh or label map that it begins with", inputs.starts);
}

void addSelection(CLI::App& command, VolumeSelection& selection) {
  const auto set = [&selection](const std::string& text) {
    selection.frame = parseInteger("--frame", text, 0, std::numeric_limits<int>::max());
  };
  command
      .add_option("--series", selection.series,
                  "SeriesInstanceUID if a folder holds several, with #N for one of its stacks")
      ->type_name("UID");
  command.add_option_function<std::string>("--frame", set, "Time point of a 4D volume, from 0")
      ->type_name("N");
  const auto setSpacing = [&selection](const std::string& text) {
    selection.spacing = parseVector("--spacing", text);
    if (selection.spacing->minCoeff() <= 0) throw OptionError("--spacing", "'" + text + "' is not above 0.");
  };
  command
      .add_option_function<std::string>("--spacing", setSpacing,
                                        "Voxel size in mm, for a file that does not give it")
      ->type_name("X,Y,Z");
  const auto setUneven = [&selection](const std::string& text) {
    if (text != "resample" && text != "refuse")
      throw OptionError("--uneven", "'" + text + "' is not resample or refuse.");
    selection.uneven = text == "refuse" ? UnevenSlices::refuse : UnevenSlices::resample;
  };
  command
      .add_option_function<std::string>(
          "--uneven", setUneven, "Unevenly spaced DICOM slices: interpolate an even grid (default) or refuse")
      ->type_name("resample|refuse");
}

}  // namespace handlebody::cli
