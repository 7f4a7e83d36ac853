#pragma once
// Comma-separated values as of RFC 4180, in UTF-8 with or without a byte order mark; lines may end in LF
// alone.

#include <string>
#include <vector>

#include "core/io/report/csv_line.h"

namespace handlebody::cli {

struct CsvCell {
  std::string text;   //!< spaces around a cell that is not quoted are left out
  std::string fault;  //!< why it cannot be used, without subject and full stop; empty: it can
};

struct CsvRow {
  int line = 1;  //!< of the file, where it begins
  std::vector<CsvCell> cells;
};

//! The bytes of a file. Throws InputError.
std::string readFile(const std::string& path);

//! For messages: begin and end of a text (valid UTF-8) that has more than `longest` bytes.
std::string shortened(const std::string& text, std::size_t longest);

//! The rows, those of empty cells alone left out. What is wrong within a row is a fault of its cell. Throws
//! InputError that begins with `path` if there is no telling where rows end (a quotation mark that is not
//! closed), or the text is UTF-16.
std::vector<CsvRow> parseCsv(const std::string& text, const std::string& path);

using handlebody::csvLine;

}  // namespace handlebody::cli
