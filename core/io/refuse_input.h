#pragma once
// How readers refuse a file.

#include <string>

#include "core/errors.h"
#include "core/finding.h"

namespace handlebody {

//! Throws InputError: "path: cause.", with the finding.
[[noreturn]] void refuseInput(const std::string& path, const Finding& cause);
//! The same for a cause that has no kind yet.
[[noreturn]] void refuseInput(const std::string& path, const std::string& cause);
//! Throws InputError: "path: it …" with what making a surface of its mask threw, which is told without a
//! subject.
[[noreturn]] void refuseSurface(const std::string& path, const InputError& why);

}  // namespace handlebody
