#include "core/io/formats/file_labels.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

#include "core/errors.h"
#include "core/io/formats/nrrd_header.h"

namespace handlebody {

namespace {

using Keys = std::map<std::string, std::string>;

//! The part of `text` at place i between separators; empty if there is none.
std::string_view part(std::string_view text, char separator, std::size_t i) {
  for (; i > 0; --i) {
    const auto at = text.find(separator);
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at + 1);
  }
  return text.substr(0, text.find(separator));
}

template <typename T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

//! "0.8 0.4 0.1", each from 0 to 1.
std::optional<Colour> colourIn(std::string_view text) {
  Colour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const std::optional<double> share = number<double>(part(text, ' ', i));
    if (!share || !std::isfinite(*share)) return std::nullopt;
    colour[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(*share, 0.0, 1.0)));
  }
  return colour;
}

//! Of "key:value|key:value|": the type, third part of a terminology entry, "scheme^value^meaning".
std::string termIn(std::string_view tags) {
  constexpr std::string_view kKey = "TerminologyEntry:";
  const auto at = tags.find(kKey);
  if (at == std::string_view::npos) return {};
  const std::string_view entry = part(tags.substr(at + kKey.size()), '|', 0), type = part(entry, '~', 2);
  return termOfCode(std::string(part(type, '^', 0)), std::string(part(type, '^', 1)));
}

Keys keysOf(const std::string& path) {
  constexpr std::string_view kMagic = "NRRD0";
  std::array<char, kMagic.size()> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  if (std::string_view(start.data(), start.size()) != kMagic) return {};
  try {
    return readNrrdFields(path).keys;
  } catch (const InputError&) {
    return {};  // whoever reads its voxels says what is wrong
  }
}

}  // namespace

std::string termOfCode(const std::string& scheme, const std::string& value) {
  const auto& all = terms();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Term& t) { return t.type.value == value; });
  return scheme != "SCT" || found == all.end() ? std::string() : found->name;
}

ObjectLabel labelledAs(const FileLabel& said, ObjectLabel label) {
  if (objectNameFault(said.name).empty()) label.name = said.name;
  if (const Term* term = termFromName(said.term)) {
    label.term = term->name;
    label.colour = term->colour;
  }
  if (said.colour) label.colour = *said.colour;
  return label;
}

FileLabels readSlicerLabels(const std::string& path) {
  const Keys keys = keysOf(path);
  FileLabels labels;
  for (const auto& [key, text] : keys) {
    if (!key.starts_with("Segment") || !key.ends_with("_LabelValue")) continue;
    const std::string segment = key.substr(0, key.find('_') + 1);
    const auto said = [&, segment](const char* what) {
      const auto found = keys.find(segment + what);
      return found == keys.end() ? std::string() : found->second;
    };
    const std::optional<int> value = number<int>(text);
    if (!value || number<int>(said("Layer")).value_or(0) > 0) continue;
    labels[*value] = {said("Name"), colourIn(said("Color")), termIn(said("Tags"))};
  }
  return labels;
}

}  // namespace handlebody
