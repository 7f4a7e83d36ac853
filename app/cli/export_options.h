#pragma once
// How meshes are written: what `segment`, `replay` and `mesh` share.

#include <optional>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_writer.h"
#include "core/polish/polish.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

//! Adds --creator, --description and --anonymous.
void addContent(CLI::App& command, DicomContent& content);

//! Adds --polish on|off.
void addPolish(CLI::App& command, std::optional<bool>& polish);

//! Adds --mesher-seconds.
void addMesherSeconds(CLI::App& command, std::optional<double>& seconds);

//! Throws UsageError for --creator, --description or --mesher-seconds where no result is of a format that it
//! says something of.
void checkEffect(const DicomContent& content, const std::optional<double>& mesherSeconds,
                 const std::vector<std::string>& results);

//! On standard error what is left, behind `name` if that is not empty; nothing where nothing is.
void warnOfPolish(const PolishReport& report, const std::string& name = {});

}  // namespace handlebody::cli
