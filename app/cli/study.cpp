#include "app/cli/study.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

#include "app/cli/csv.h"
#include "app/cli/segment.h"
#include "core/errors.h"
#include "core/io/atomic_file.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"

namespace handlebody::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestSaid = 400;  // bytes of a message; a cell may be much longer
constexpr std::size_t kLongestName = 200;  // bytes; file systems take 255, temporary names are longer

enum class ColumnKind { none, name, volume, output, timeLimit, memoryLimit, input, option };

struct Column {
  std::string header;
  ColumnKind kind = ColumnKind::none;
  SegmentOption option;  //!< of ColumnKind::option
};

//! What is wrong with a cell; becomes the fault of its row.
struct CellFault {
  std::size_t column;
  std::string message;
};

//! Where the results of a case go is the batch's business, and so is what it says.
bool isForBatch(const std::string& option) {
  static const std::vector<std::string> own{
      "output", "report", "session", "trace", "picture", "label-description", "quiet", "sensitivity-surface",
      "curve"};
  return std::find(own.begin(), own.end(), option) != own.end();
}

const std::map<std::string, ColumnKind>& ownColumns() {
  static const std::map<std::string, ColumnKind> columns{{"case", ColumnKind::name},
                                                         {"name", ColumnKind::name},
                                                         {"volume", ColumnKind::volume},
                                                         {"output", ColumnKind::output},
                                                         {"time-limit", ColumnKind::timeLimit},
                                                         {"memory-limit", ColumnKind::memoryLimit},
                                                         {"walls", ColumnKind::input},
                                                         {"start", ColumnKind::input},
                                                         {"given", ColumnKind::input}};
  return columns;
}

std::string place(const CsvRow& row, std::size_t column) {
  return "line " + std::to_string(row.line) + ", column " + std::to_string(column + 1);
}

Column columnOf(const std::string& header) {
  if (const auto own = ownColumns().find(header); own != ownColumns().end()) return {header, own->second, {}};
  for (const SegmentOption& option : segmentOptions())
    if (option.name == header && !isForBatch(header)) return {header, ColumnKind::option, option};
  return {header, ColumnKind::none, {}};
}

//! What tells columns of one kind apart.
std::string optionOf(const Column& column) {
  return column.kind == ColumnKind::input ? column.header : column.option.name;
}

bool mayRepeat(const Column& column) {
  return column.kind == ColumnKind::output || column.kind == ColumnKind::none || column.option.isRepeated;
}

//! Throws InputError for the second of a kind of which there is one, and if there is none for the volume.
void requireColumns(const std::vector<Column>& columns, const CsvRow& row, const std::string& path) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (columns[i].kind == columns[j].kind && optionOf(columns[i]) == optionOf(columns[j]) &&
          !mayRepeat(columns[i]))
        throw InputError(path + ": " + place(row, i) + ": '" + columns[i].header +
                         "' says the same as column " + std::to_string(j + 1) + ".");
  const auto isVolume = [](const Column& c) { return c.kind == ColumnKind::volume; };
  if (std::none_of(columns.begin(), columns.end(), isVolume))
    throw InputError(path + ": line " + std::to_string(row.line) + ": there is no column 'volume'.");
}

std::vector<Column> readHeader(const CsvRow& row, const std::string& path) {
  std::vector<Column> columns;
  for (const CsvCell& cell : row.cells) {
    const std::string where = path + ": " + place(row, columns.size()) + ": ";
    if (!cell.fault.empty()) throw InputError(where + "the name of the column " + cell.fault + ".");
    columns.push_back(columnOf(cell.text));
    if (columns.back().kind != ColumnKind::none || cell.text.empty()) continue;
    if (row.cells.size() == 1 && cell.text.find(';') != std::string::npos)
      throw InputError(where + "its columns are separated by semicolons; commas are needed.");
    throw InputError(where + "'" + shortened(cell.text, kLongestName) + "' is no column; there are " +
                     studyColumns() + ".");
  }
  requireColumns(columns, row, path);
  return columns;
}

std::vector<std::string> splitAtSemicolons(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(' ', begin), end);
    if (first < end) parts.push_back(text.substr(first, text.find_last_not_of(' ', end - 1) - first + 1));
    begin = end + 1;
  }
  return parts;
}

//! Why it cannot be the name of a file or folder of ours; empty: it can.
std::string nameFault(const std::string& name) {
  if (name.empty()) return "it is empty";
  if (name.size() > kLongestName) return "it is longer than " + std::to_string(kLongestName) + " bytes";
  if (name.find_first_of("/\\") != std::string::npos) return "it has a slash in it";
  // Hidden and temporary files begin with a full stop; the others mean something to a shell or a spreadsheet.
  if (std::string(".-=+@~ ").find(name[0]) != std::string::npos)
    return std::string("it begins with '") + name[0] + "'";
  if (name.back() == ' ' || name.back() == '.') return "it ends in a space or a full stop";
  return {};
}

bool isOurs(const std::string& file) {
  return file == "report.json" || file == "session.json" || file == "picture.png" ||
         file == "thumbnail.png" || file == "log.txt" || file == "case.json" || file == "curve.csv" ||
         file == "curve.svg";
}

//! Path of an input; throws UsageError unless it can be read.
std::string inputPath(const std::string& text, const fs::path& folder) {
  std::string path = inRealFolder((folder / text).string());
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (!fs::exists(status)) throw UsageError(path + ": there is no such file or folder");
  if (!fs::is_regular_file(status) && !fs::is_directory(status))
    throw UsageError(path + ": it is neither a file nor a folder");
  if (::access(path.c_str(), R_OK) != 0)
    throw UsageError(path + ": it cannot be read (" + std::strerror(errno) + ")");
  return path;
}

//! The name of a volume without what says its format, which that of a folder does not.
std::string stem(const std::string& volume, const fs::path& folder) {
  fs::path name = fs::path(volume).lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  name = name.filename();
  std::error_code failed;
  if (fs::is_directory(folder / volume, failed)) return name.string();
  if (name.extension() == ".gz") name = name.stem();
  return name.stem().string();
}

bool isNo(const std::string& text) { return text == "0" || text == "no" || text == "false"; }

bool parseFlag(const std::string& text) {
  for (const char* yes : {"1", "yes", "true"})
    if (text == yes) return true;
  if (isNo(text)) return false;
  throw UsageError("'" + text + "' is not yes or no");
}

constexpr const char* kAnonymous = "anonymous";  // the column

//! One row on its way to a case.
class RowReader {
 public:
  RowReader(const std::vector<Column>& columns, const fs::path& folder, const StudyDefaults& defaults)
      : columns_(columns), folder_(folder), outputs_{"mesh." + defaults.format, "labels.nii.gz"} {
    case_.limits = defaults.limits;
  }

  StudyCase read(const CsvRow& row) {
    case_.line = row.line;
    try {
      hideFirst(row);
      nameFirst(row);
      requireCells(row);
      for (at_ = 0; at_ < columns_.size(); ++at_)
        if (at_ < row.cells.size()) take(columns_[at_], row.cells[at_].text);
      finish();
    } catch (const OptionError& error) {
      refuse(row, at_, error.reason());
    } catch (const UsageError& error) {
      refuse(row, at_, error.what());
    } catch (const CellFault& fault) {
      refuse(row, fault.column, fault.message);
    }
    if (case_.isAnonymous) case_.volume.clear();
    return case_;
  }

 private:
  //! Whatever is wrong with the rest, and where the cell is not understood, too.
  void hideFirst(const CsvRow& row) {
    for (std::size_t i = 0; i < std::min(row.cells.size(), columns_.size()); ++i) {
      const CsvCell& cell = row.cells[i];
      if (columns_[i].header == kAnonymous &&
          (!cell.fault.empty() || (!cell.text.empty() && !isNo(cell.text))))
        case_.isAnonymous = true;
    }
  }

  //! Whatever is wrong with the rest: the summary names the case and its volume.
  void nameFirst(const CsvRow& row) {
    for (std::size_t i = 0; i < std::min(row.cells.size(), columns_.size()); ++i) {
      if (columns_[i].kind == ColumnKind::name && row.cells[i].fault.empty()) case_.name = row.cells[i].text;
      if (columns_[i].kind == ColumnKind::volume && row.cells[i].fault.empty())
        case_.volume = row.cells[i].text;
    }
    const auto isName = [](const Column& c) { return c.kind == ColumnKind::name; };
    if (std::any_of(columns_.begin(), columns_.end(), isName)) return;
    case_.name = case_.isAnonymous ? "line-" + std::to_string(row.line) : stem(case_.volume, folder_);
  }

  void requireCells(const CsvRow& row) const {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (!row.cells[i].fault.empty()) throw CellFault{i, "the cell " + row.cells[i].fault};
      const bool isExtra = i >= columns_.size() || columns_[i].header.empty();
      if (isExtra && !row.cells[i].text.empty())
        throw CellFault{i, "there is no column of a name over '" + row.cells[i].text +
                               "' (values with commas must be quoted)"};
    }
  }

  void take(const Column& column, const std::string& text) {
    if (column.kind == ColumnKind::volume && text.empty()) throw UsageError("there is no volume");
    if (text.empty()) return;
    switch (column.kind) {
      case ColumnKind::volume:
        case_.volumePath = inputPath(text, folder_);
        break;
      case ColumnKind::input:
        case_.inputs.push_back({column.header, inputPath(text, folder_)});
        break;
      case ColumnKind::output:
        takeOutputs(text);
        break;
      case ColumnKind::timeLimit:
        case_.limits.seconds = parseTimeLimit(column.header, text);
        break;
      case ColumnKind::memoryLimit:
        case_.limits.bytes = parseMemoryLimit(column.header, text);
        break;
      case ColumnKind::option:
        takeOption(column, text);
        break;
      case ColumnKind::name:
      case ColumnKind::none:
        break;
    }
  }

  void takeOutputs(const std::string& text) {
    for (const std::string& file : splitAtSemicolons(text)) {
      if (const std::string fault = nameFault(file); !fault.empty())
        throw UsageError("'" + file + "' is no name of a file: " + fault);
      if (isOurs(file)) throw UsageError("'" + file + "' is written anyway");
      if (std::find(case_.outputs.begin(), case_.outputs.end(), file) != case_.outputs.end())
        throw UsageError("'" + file + "' is named twice");
      case_.outputs.push_back(file);
    }
  }

  void takeOption(const Column& column, const std::string& text) {
    const std::string option = "--" + column.header;
    if (column.option.isFlag) {
      if (parseFlag(text)) case_.options.push_back(option);
      return;
    }
    const std::vector<std::string> values =
        column.option.isRepeated ? splitAtSemicolons(text) : std::vector{text};
    for (const std::string& value : values) case_.options.push_back(option + "=" + value);
  }

  void finish() {
    at_ = columnOfKind(ColumnKind::volume);
    if (case_.volumePath.empty()) throw UsageError("there is no volume");
    if (case_.outputs.empty()) case_.outputs = outputs_;
    at_ = columnOfKind(ColumnKind::name);
    if (const std::string fault = nameFault(case_.name); !fault.empty())
      throw UsageError("'" + case_.name + "' cannot name the case: " + fault);
    checkArguments();
  }

  //! With the column of the option that is wrong.
  void checkArguments() {
    std::vector<std::string> arguments{case_.volumePath};
    for (const StudyInput& input : case_.inputs) arguments.push_back(argumentOf(input));
    arguments.insert(arguments.end(), case_.options.begin(), case_.options.end());
    for (const std::string& file : case_.outputs) arguments.push_back("--output=" + file);
    try {
      checkSegmentArguments(arguments);
    } catch (const OptionError& error) {
      const std::size_t column = columnOfOption(error.option());
      throw CellFault{column, column < columns_.size() ? error.reason() : error.what()};
    } catch (const UsageError& error) {
      throw CellFault{columns_.size(), error.what()};
    }
  }

  //! With its dashes. As many as there are: none.
  std::size_t columnOfOption(const std::string& option) const {
    if (option == "--output") return columnOfKind(ColumnKind::output);
    const auto found = std::find_if(columns_.begin(), columns_.end(), [&option](const Column& c) {
      return !c.header.empty() && "--" + c.header == option;
    });
    return static_cast<std::size_t>(found - columns_.begin());
  }

  //! As many as there are: none.
  std::size_t columnOfKind(ColumnKind kind) const {
    const auto found =
        std::find_if(columns_.begin(), columns_.end(), [kind](const Column& c) { return c.kind == kind; });
    return static_cast<std::size_t>(found - columns_.begin());
  }

  void refuse(const CsvRow& row, std::size_t column, const std::string& why) {
    std::string text = "line " + std::to_string(row.line);
    if (column < columns_.size() || column < row.cells.size()) text = place(row, column);
    if (column < columns_.size() && !columns_[column].header.empty())
      text += " (" + columns_[column].header + ")";
    case_.name = shortened(case_.name, kLongestName);
    case_.volume = shortened(case_.volume, kLongestSaid);
    case_.fault = text + ": " + shortened(why, kLongestSaid) + (why.back() == '.' ? "" : ".");
    const bool isHarmless = column < columns_.size() && columns_[column].header == kAnonymous;
    case_.toldFault = case_.isAnonymous && !isHarmless
                          ? text + ": why is told on standard error alone, as the case is anonymous."
                          : case_.fault;
  }

  const std::vector<Column>& columns_;
  fs::path folder_;
  std::vector<std::string> outputs_;
  StudyCase case_;
  std::size_t at_ = 0;
};

void refuseNamesakes(std::vector<StudyCase>& cases) {
  std::map<std::string, int> lines;
  for (StudyCase& c : cases) {
    const auto [first, isNew] = lines.emplace(c.name, c.line);
    if (!isNew && c.fault.empty())
      c.fault = c.toldFault = "line " + std::to_string(c.line) + ": '" + c.name +
                              "' is the name of the case of line " + std::to_string(first->second) + ", too.";
  }
}

}  // namespace

std::string argumentOf(const StudyInput& input) { return "--" + input.option + "=" + input.path; }

bool StudyCase::isOverTime() const {
  return std::any_of(options.begin(), options.end(),
                     [](const std::string& option) { return option.rfind("--frames=", 0) == 0; });
}

std::string studyColumns() {
  std::string text =
      "volume, case (or name), output, time-limit, memory-limit, and of the options of segment ";
  bool isFirst = true;
  for (const SegmentOption& option : segmentOptions()) {
    if (isForBatch(option.name)) continue;
    text += (isFirst ? "" : ", ") + option.name;
    isFirst = false;
  }
  return text;
}

std::string folderOfPaths(const std::string& path, const StudyDefaults& defaults) {
  const fs::path folder =
      defaults.folder.empty() ? fs::absolute(path).parent_path() : fs::absolute(defaults.folder);
  return folder.string();
}

std::vector<StudyCase> readStudy(const std::string& text, const std::string& path,
                                 const StudyDefaults& defaults) {
  const std::vector<CsvRow> rows = parseCsv(text, path);
  if (rows.empty()) throw InputError(path + ": it is empty; its first line names the columns.");
  const std::vector<Column> columns = readHeader(rows[0], path);
  if (rows.size() == 1) throw InputError(path + ": it has no rows under the names of the columns.");
  const fs::path folder = folderOfPaths(path, defaults);
  std::vector<StudyCase> cases;
  for (std::size_t i = 1; i < rows.size(); ++i)
    cases.push_back(RowReader(columns, folder, defaults).read(rows[i]));
  refuseNamesakes(cases);
  return cases;
}

double parseTimeLimit(const std::string& option, const std::string& text) {
  const double seconds = parseNumber(option, text);
  if (!(seconds >= 0) || !std::isfinite(seconds))
    throw OptionError(option, "'" + text + "' is below 0 or infinite.");
  return seconds;
}

std::uint64_t parseMemoryLimit(const std::string& option, const std::string& text) {
  constexpr int kMaxMegabytes = 1 << 30;  // a petabyte
  return static_cast<std::uint64_t>(parseInteger(option, text, 0, kMaxMegabytes)) << 20U;
}

}  // namespace handlebody::cli
