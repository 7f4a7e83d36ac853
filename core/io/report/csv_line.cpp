#include "core/io/report/csv_line.h"

#include <charconv>

namespace handlebody {

namespace {

bool isNumber(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    const bool isFormula =
        !cell.empty() && std::string("=+-@\t\r").find(cell[0]) != std::string::npos && !isNumber(cell);
    const std::string text = isFormula ? "'" + cell : cell;
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
      line += text;
      continue;
    }
    line += '"';
    for (char c : text) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\r\n";
}

}  // namespace handlebody
