#include "app/cli/csv.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/errors.h"
#include "core/io/trimmed.h"

namespace handlebody::cli {

namespace {

// A longer one is no value of anything, and the system starts no process with such an argument.
constexpr std::size_t kLongestCell = 100000;  // bytes

//! Length of the UTF-8 sequence at `at`; 0 if there is none. Overlong forms, surrogates and what lies beyond
//! U+10FFFF do not count.
std::size_t sequenceLength(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned char>(at + i < text.size() ? text[at + i] : 0);
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
  if (length == 0 || first > 0xF4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  const unsigned second = byte(1);
  const bool bad = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                   (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return bad ? 0 : length;
}

bool isUtf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequenceLength(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

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
