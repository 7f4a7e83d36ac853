#pragma once

#include <functional>
#include <string>

namespace handlebody::ui {

//! Writes a file at a path, on whichever thread; throws where it fails. Has a name, as moc cannot read the
//! type.
using FileWriter = std::function<void(const std::string& path)>;

}  // namespace handlebody::ui
