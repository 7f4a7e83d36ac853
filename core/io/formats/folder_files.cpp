#include "core/io/formats/folder_files.h"

#include <algorithm>
#include <filesystem>

#include "core/io/lowered.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

bool endsWithAny(const std::string& name, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return name.ends_with(e); });
}

//! "frame2" before "frame10".
bool comesBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto number = [&](const std::string& s, std::size_t& at) {
    const std::size_t begin = s.find_first_not_of('0', at);
    std::size_t end = at;
    while (end < s.size() && isDigit(s[end])) ++end;
    at = end;
    return begin < end ? s.substr(begin, end - begin) : std::string();
  };
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const std::string m = number(a, i), n = number(b, j);
    if (m.size() != n.size()) return m.size() < n.size();
    if (m != n) return m < n;
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

}  // namespace

std::vector<std::string> filesOf(const std::string& folder, std::initializer_list<const char*> endings) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), lower = lowered(name);
    if (!entry.is_regular_file() || name.front() == '.' ||
        endsWithAny(lower, {".raw", ".raw.gz", ".zraw", ".img", ".img.gz", ".txt", ".json", ".csv"}))
      continue;
    if (!endsWithAny(lower, endings)) return {};
    names.push_back(name);
  }
  std::sort(names.begin(), names.end(), comesBefore);
  return names;
}

}  // namespace handlebody
