#pragma once

#include <string>

namespace handlebody {

//! The whole file. Throws InputError that names it.
std::string readTextFile(const std::string& path);

//! Writes whole or not at all (temporary name in the same folder, then rename). Throws OutputError.
void writeTextFile(const std::string& text, const std::string& path);

}  // namespace handlebody
