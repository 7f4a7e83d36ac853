#pragma once
// How meshes are written: what `segment`, `replay` and `mesh` share.

#include <optional>
#include <string>

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
void addMesherSeconds(CLI::App& command, double& seconds);

//! On standard error what is left, behind `name` if that is not empty; nothing where nothing is.
void warnOfPolish(const PolishReport& report, const std::string& name = {});

}  // namespace handlebody::cli
