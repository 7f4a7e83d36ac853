#include "tests/layering/told_errors.h"

#include <algorithm>
#include <array>
#include <regex>

namespace handlebody::test {

namespace {

// What a user of the window does not see, or sees in words that are translated where they are caught.
constexpr std::array<const char*, 3> kAllowed{
    "core/handles/",                    // a research tool of the command line
    "core/io/report/option_error.h",    // names an option of the command line
    "core/io/dicom/dicom_dataset.cpp",  // what DCMTK says in English
};

bool isAllowed(const std::string& path) {
  return std::any_of(kAllowed.begin(), kAllowed.end(),
                     [&path](const char* start) { return path.rfind(start, 0) == 0; });
}

}  // namespace

std::vector<std::string> plainErrors(const SourceTree& sources) {
  // As it is thrown, as the base of another error, and as the text of a cause.
  static const std::regex plain(
      "(throw\\s+|[:,]\\s*)(Usage|Input|Output|Seed)Error\\s*[({]|refuseInput\\([^;]*,\\s*\"");
  static const std::regex comment("//[^\\n]*");
  std::vector<std::string> found;
  for (const auto& [path, source] : sources) {
    if (path.rfind("core/", 0) != 0 || isAllowed(path)) continue;
    const std::string text = std::regex_replace(source, comment, "");
    for (std::sregex_iterator at(text.begin(), text.end(), plain), end; at != end; ++at) {
      const auto line = 1 + std::count(text.begin(), text.begin() + at->position(), '\n');
      found.push_back(path + ":" + std::to_string(line) + ": " + at->str() + " without a finding");
    }
  }
  return found;
}

}  // namespace handlebody::test
