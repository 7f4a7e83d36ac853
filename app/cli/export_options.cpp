#include "app/cli/export_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"
#include "core/io/tetrahedra/tetrahedra.h"

namespace handlebody::cli {

void addContent(CLI::App& command, DicomContent& content) {
  const auto add = [&command](const std::string& name, std::string& text, const std::string& type,
                              const std::string& help) {
    const auto set = [&text, name](const std::string& given) {
      if (const Finding fault = dicomTextFinding(given); fault.any())
        throw OptionError(name, sentence(fault) + ".");
      text = given;
    };
    command.add_option_function<std::string>(name, set, help)->type_name(type);
  };
  add("--creator", content.creator, "FAMILY^GIVEN",
      "Who made it, for .seg.dcm (default: nobody is named); .stl.dcm has no place for it");
  command.add_flag(
      "--anonymous", content.anonymous,
      "Leave names, dates and identifiers of the source out of every file: paths, series, and in DICOM "
      "files patient, study and references");
  add("--description", content.description, "TEXT", "What it is for, for DICOM files");
}

void addPolish(CLI::App& command, std::optional<bool>& polish) {
  const auto set = [&polish](const std::string& text) {
    if (text != "on" && text != "off") throw OptionError("--polish", "'" + text + "' is not on or off.");
    polish = text == "on";
  };
  command
      .add_option_function<std::string>(
          "--polish", set,
          "Better triangles with an angle under 15 degrees and edges whose faces meet at less than 20, with "
          "the surface kept within a tenth of a voxel; what is good stays bit for bit (default: on; replay: "
          "as the session says)")
      ->type_name("on|off");
}

void addMesherSeconds(CLI::App& command, std::optional<double>& seconds) {
  const auto set = [&seconds](const std::string& text) {
    seconds = parseNumber("--mesher-seconds", text);
    if (!(*seconds > 0)) throw OptionError("--mesher-seconds", "'" + text + "' is not above 0.");
  };
  command
      .add_option_function<std::string>(
          "--mesher-seconds", set,
          "How long gmsh or TetGen may work on an object's tetrahedra before it is killed (default 1800)")
      ->type_name("S");
}

void checkEffect(const DicomContent& content, const std::optional<double>& mesherSeconds,
                 const std::vector<std::string>& results) {
  const auto isAny = [&results](auto&& is) { return std::any_of(results.begin(), results.end(), is); };
  const auto refuse = [](const char* option, const char* needed) {
    throw OptionError(option, std::string("has no effect without -o of a ") + needed + ".", " ");
  };
  const bool isSegmentation = isAny(isDicomSegmentationPath);
  if (!content.creator.empty() && !isSegmentation) refuse("--creator", ".seg.dcm");
  if (!content.description.empty() && !isSegmentation && !isAny(isDicomStlPath))
    refuse("--description", ".seg.dcm or .stl.dcm");
  if (mesherSeconds && !isAny(isTetrahedraPath)) refuse("--mesher-seconds", ".msh, .vtu or .inp");
}

void warnOfPolish(const PolishReport& report, const std::string& name) {
  if (const std::string warning = sentence(polishWarning(report)); !warning.empty())
    std::fprintf(stderr, "handlebody-cli: warning: %s%s\n", name.empty() ? "" : (name + ": ").c_str(),
                 warning.c_str());
}

}  // namespace handlebody::cli
