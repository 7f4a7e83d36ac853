#pragma once
// Internal: what the headers that are text (NRRD, MetaImage) have in common.

#include <charconv>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace handlebody {

inline std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

//! The number that the whole word is, in the C locale; it may begin with a plus.
template <typename T>
std::optional<T> parsed(const std::string& word) {
  T value{};
  const char* first = word.data() + (word.size() > 1 && word[0] == '+');
  const auto [end, error] = std::from_chars(first, word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace handlebody
