#include "core/io/formats/file_labels.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <set>
#include <string_view>

#include "core/errors.h"
#include "core/io/formats/label_map.h"
#include "core/io/formats/nrrd_header.h"
#include "core/io/trimmed.h"

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

//! Of "key:value|key:value|": the value; empty if there is none.
std::string tagIn(std::string_view tags, std::string_view key) {
  while (!tags.empty()) {
    const std::string_view tag = part(tags, '|', 0);
    if (part(tag, ':', 0) == key && tag.size() > key.size()) return std::string(tag.substr(key.size() + 1));
    tags.remove_prefix(std::min(tags.size(), tag.size() + 1));
  }
  return {};
}

//! "scheme^value^meaning".
CodedTerm codeIn(std::string_view text) {
  const auto piece = [&](std::size_t i) { return std::string(trimmed(part(text, '^', i))); };
  return {piece(1), piece(0), piece(2)};
}

std::vector<CodedTerm> modifiersIn(std::string_view text) {
  const CodedTerm code = codeIn(text);
  return code.value.empty() ? std::vector<CodedTerm>() : std::vector{code};
}

//! Of a terminology entry: context, category, type, its modifier, context of regions, region, its modifier.
Terminology terminologyIn(std::string_view entry) {
  const auto code = [&](std::size_t i) { return codeIn(part(entry, '~', i)); };
  const auto modifiers = [&](std::size_t i) { return modifiersIn(part(entry, '~', i)); };
  return {code(1), {code(2), modifiers(3)}, {code(5), modifiers(6)}};
}

FileLabel labelOf(std::string name, const std::string& colour, const std::string& tags) {
  FileLabel label{std::move(name), colourIn(colour), {}, {}};
  label.take(terminologyIn(tagIn(tags, slicer::kTerminologyTag)));
  label.source.algorithm =
      algorithmSaid(tagIn(tags, slicer::kAlgorithmTypeTag), tagIn(tags, slicer::kAlgorithmNameTag));
  return label;
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

constexpr int kMaxLayers = 10000;
constexpr int kLargestValue = 1 << 16;  // of a segment; larger ones are nobody's

//! Of a .seg.nrrd.
struct Segment {
  std::size_t layer = 0;
  int value = 0;
  FileLabel label{};
};

//! The number of the segment that a key speaks of, "Segment3_Name".
std::optional<int> segmentOf(std::string_view key) {
  constexpr std::string_view kBegin = "Segment";
  if (!key.starts_with(kBegin)) return std::nullopt;
  const std::string_view digits = part(key.substr(kBegin.size()), '_', 0);
  const std::optional<int> found = number<int>(digits);
  return found && std::to_string(*found) == digits ? found : std::nullopt;
}

//! Older files say neither value nor layer: each segment is 1 in a layer of its own.
std::optional<Segment> segmentIn(const Keys& keys, int segment) {
  const std::string begin = "Segment" + std::to_string(segment) + '_';
  const auto said = [&](const char* what) {
    const auto found = keys.find(begin + what);
    return found == keys.end() ? std::string() : found->second;
  };
  const bool isOld = !keys.contains(begin + "LabelValue");
  const std::optional<int> value = isOld ? 1 : number<int>(said("LabelValue"));
  const int layer = number<int>(said("Layer")).value_or(isOld ? segment : 0);
  if (!value || std::abs(*value) > kLargestValue || layer < 0 || layer > kMaxLayers) return std::nullopt;
  return Segment{static_cast<std::size_t>(layer), *value, labelOf(said("Name"), said("Color"), said("Tags"))};
}

std::vector<Segment> segmentsIn(const std::string& path) {
  const Keys keys = keysOf(path);
  std::set<int> numbers;
  for (const auto& [key, text] : keys)
    if (const std::optional<int> segment = segmentOf(key)) numbers.insert(*segment);
  std::vector<Segment> segments;
  for (const int number : numbers)
    if (std::optional<Segment> segment = segmentIn(keys, number)) segments.push_back(*std::move(segment));
  return segments;
}

//! The largest values of the layers before, together.
std::vector<int> shiftsOf(const std::vector<Segment>& segments) {
  std::vector<int> largest{0}, shifts{0};
  for (const Segment& s : segments) {
    largest.resize(std::max(largest.size(), s.layer + 1));
    largest[s.layer] = std::max(largest[s.layer], s.value);
  }
  for (std::size_t l = 1; l < largest.size(); ++l) shifts.push_back(shifts[l - 1] + largest[l - 1]);
  return shifts;
}

}  // namespace

std::string termOfCode(const std::string& scheme, const std::string& value) {
  const auto& all = terms();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Term& t) { return t.type.value == value; });
  return scheme != kSnomed || found == all.end() ? std::string() : found->name;
}

void FileLabel::take(Terminology said) {
  term = termOfCode(said.type.term.scheme, said.type.term.value);
  source.terminology = usable(std::move(said));
  const Term* known = termFromName(term);
  if (known && source.terminology == terminologyOf(*known)) source.terminology.reset();
}

ObjectLabel labelledAs(const FileLabel& said, ObjectLabel label) {
  if (objectNameFault(said.name).empty()) label.name = said.name;
  if (const Term* term = termFromName(said.term)) {
    label.term = term->name;
    label.colour = term->colour;
  }
  if (said.colour) label.colour = *said.colour;
  if (!said.term.empty() || said.source.terminology) label.source.terminology = said.source.terminology;
  if (said.term.empty() && said.source.terminology) label.term = plainTerm().name;
  // That of what we wrote needs no word: it is written so again.
  if (said.source.algorithm && said.source.algorithm != ownAlgorithm())
    label.source.algorithm = said.source.algorithm;
  return label;
}

std::vector<int> slicerLayerShifts(const std::string& path) { return shiftsOf(segmentsIn(path)); }

FileLabels readSlicerLabels(const std::string& path) {
  const std::vector<Segment> segments = segmentsIn(path);
  const std::vector<int> shifts = shiftsOf(segments);
  FileLabels labels;
  for (const Segment& s : segments) labels[s.value + shifts[s.layer]] = s.label;
  return labels;
}

}  // namespace handlebody
