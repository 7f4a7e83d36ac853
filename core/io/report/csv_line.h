#pragma once
// Tables as comma-separated values (RFC 4180).

#include <string>
#include <vector>

namespace handlebody {

//! One line with its CRLF. Cells that a spreadsheet would take for a formula get an apostrophe in front,
//! unless they are numbers.
std::string csvLine(const std::vector<std::string>& cells);

}  // namespace handlebody
