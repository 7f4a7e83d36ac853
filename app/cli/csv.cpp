#include "app/cli/csv.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/errors.h"
#include "core/io/trimmed.h"
#include "core/io/utf8.h"

namespace handlebody::cli {

namespace {

// A longer one is no value of anything, and the system starts no process with such an argument.
constexpr std::size_t kLongestCell = 100000;  // bytes

bool isControl(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

constexpr const char* kBlanks = " \t";  // around a cell; the ends of lines are the reader's

class CsvReader {
 public:
  CsvReader(const std::string& text, const std::string& path) : text_(text), path_(path) {
    if (text.rfind("\xff\xfe", 0) == 0 || text.rfind("\xfe\xff", 0) == 0)
      throw InputError(path + ": it is UTF-16; save it as CSV in UTF-8.");
    if (text.rfind("\xef\xbb\xbf", 0) == 0) at_ = 3;
  }

  bool atEnd() const { return at_ >= text_.size(); }

  CsvRow row() {
    CsvRow row{line_, {}};
    do row.cells.push_back(cell());
    while (skip(","));
    if (skip("\r\n") || skip("\n")) ++line_;
    return row;
  }

 private:
  bool isNext(const char* word) const {
    return text_.compare(at_, std::char_traits<char>::length(word), word) == 0;
  }
  bool skip(const char* word) {
    if (!isNext(word)) return false;
    at_ += std::char_traits<char>::length(word);
    return true;
  }
  bool atCellEnd() const { return atEnd() || isNext(",") || isNext("\n") || isNext("\r\n"); }

  std::string toCellEnd() {
    const std::size_t begin = at_;
    while (!atCellEnd()) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  CsvCell cell() {
    CsvCell cell;
    const std::size_t begin = at_;
    while (!atCellEnd() && (isNext(" ") || isNext("\t"))) ++at_;
    if (skip("\"")) {
      cell.text = quoted();
      if (!trimmed(toCellEnd(), kBlanks).empty()) cell.fault = "goes on behind its closing quotation mark";
    } else {
      at_ = begin;
      cell.text = trimmed(toCellEnd(), kBlanks);
      if (cell.text.find('"') != std::string::npos)
        cell.fault = "has a quotation mark in it: the whole cell must be quoted, and that mark doubled";
    }
    if (!isUtf8(cell.text)) cell.fault = "is not UTF-8";
    if (std::any_of(cell.text.begin(), cell.text.end(), isControl))
      cell.fault = "has a control character or a line break in it";
    if (cell.text.size() > kLongestCell) {
      cell.fault = "is longer than " + std::to_string(kLongestCell) + " bytes";
      cell.text.clear();
    }
    return cell;
  }

  std::string quoted() {
    const int begin = line_;
    std::string content;
    for (; !atEnd(); ++at_) {
      if (isNext("\"") && ++at_ && !isNext("\"")) return content;
      if (atEnd()) break;
      if (text_[at_] == '\n') ++line_;
      content += text_[at_];
    }
    throw InputError(path_ + ": line " + std::to_string(begin) + ": a quotation mark is not closed.");
  }

  const std::string& text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1;
};

//! The same, not in the middle of a character.
std::size_t characterBefore(const std::string& text, std::size_t at) {
  while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80) --at;
  return at;
}

}  // namespace

std::string readFile(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) throw InputError(path + ": there is no such file.");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": it cannot be opened (" + std::strerror(errno) + ").");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string shortened(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  const std::size_t half = longest / 2;
  return text.substr(0, characterBefore(text, half)) + " … " +
         text.substr(characterBefore(text, text.size() - half));
}

std::vector<CsvRow> parseCsv(const std::string& text, const std::string& path) {
  CsvReader reader(text, path);
  std::vector<CsvRow> rows;
  while (!reader.atEnd()) {
    CsvRow row = reader.row();
    const auto isEmpty = [](const CsvCell& cell) { return cell.text.empty() && cell.fault.empty(); };
    if (!std::all_of(row.cells.begin(), row.cells.end(), isEmpty)) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace handlebody::cli
