#pragma once
// Internal: files of a folder that are one volume together.

#include <initializer_list>
#include <string>
#include <vector>

namespace handlebody {

//! Names with one of these endings (lower case, any case in the folder), in the order of their names, numbers
//! by value: "frame2" before "frame10". Nothing if there is a file that is none; data files, notes and hidden
//! files are passed over. Throws std::filesystem::filesystem_error.
std::vector<std::string> filesOf(const std::string& folder, std::initializer_list<const char*> endings);

}  // namespace handlebody
