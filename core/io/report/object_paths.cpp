#include "core/io/report/object_paths.h"

#include <set>

#include "core/io/lowered.h"

namespace handlebody {

namespace {

constexpr const char* kRefused = "/\\:*?\"<>|";  // Windows refuses all of them
constexpr std::size_t kLongest = 100;            // bytes; a file's name may have 255

//! Of UTF-8: no character is cut in two.
std::string cutOff(std::string name) {
  if (name.size() <= kLongest) return name;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end);
}

std::string partOfName(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool isControl = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    out += isControl || std::string_view(kRefused).find(c) != std::string_view::npos ? '_' : c;
  }
  return cutOff(std::move(out));
}

}  // namespace

std::vector<std::string> objectPaths(const std::string& path, const std::string& extension,
                                     const std::vector<std::string>& names) {
  const std::string stem = path.substr(0, path.size() - extension.size()), ending = path.substr(stem.size());
  std::vector<std::string> paths;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    const std::string part = partOfName(name);
    std::string unique = part;
    for (int n = 2; !taken.insert(lowered(unique)).second; ++n) unique = part + '_' + std::to_string(n);
    paths.push_back(stem + '_' + unique + ending);
  }
  return paths;
}

}  // namespace handlebody
