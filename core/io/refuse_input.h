#pragma once
// How readers refuse a file.

#include <string>

#include "core/finding.h"

namespace handlebody {

//! Throws InputError: "path: cause.", with the finding.
[[noreturn]] void refuseInput(const std::string& path, const Finding& cause);
//! The same for a cause that has no kind yet.
[[noreturn]] void refuseInput(const std::string& path, const std::string& cause);

}  // namespace handlebody
