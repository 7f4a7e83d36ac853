#include "core/io/meshes/terminology.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/io/meshes/object_name.h"

namespace handlebody {

namespace {

constexpr std::size_t kLongestCode = 16;      // characters, of DICOM's SH
constexpr const char* kSeparators = "\\|~^";  // of DICOM and 3D Slicer, which escape nothing
constexpr std::array kTypes{AlgorithmType::manual, AlgorithmType::semiautomatic, AlgorithmType::automatic};

bool isUsable(const std::string& text, std::size_t longest) {
  const std::optional<std::size_t> characters = charactersOf(text);
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  return characters && *characters <= longest && text.find_first_not_of(' ') != std::string::npos &&
         std::none_of(text.begin(), text.end(), isControl) &&
         text.find_first_of(kSeparators) == std::string::npos;
}

bool isUsable(const CodedTerm& term) {
  return isUsable(term.value, kLongestCode) && isUsable(term.scheme, kLongestCode) &&
         isUsable(term.meaning, kLongestName);
}

void keepUsable(std::vector<CodedTerm>& modifiers) {
  std::erase_if(modifiers, [](const CodedTerm& term) { return !isUsable(term); });
  if (modifiers.size() > kMaxModifiers) modifiers.resize(kMaxModifiers);
}

std::string meaningOf(const ModifiedTerm& term) {
  std::string text = term.term.meaning;
  for (const CodedTerm& modifier : term.modifiers) text += ", " + modifier.meaning;
  return text;
}

//! PS3.16 section 8: private designators begin with 99, and L is anybody's own.
bool isPrivate(const CodedTerm& term) { return term.scheme.starts_with("99") || term.scheme == "L"; }

bool isPrivate(const ModifiedTerm& term) {
  return isPrivate(term.term) || std::any_of(term.modifiers.begin(), term.modifiers.end(),
                                             [](const CodedTerm& modifier) { return isPrivate(modifier); });
}

//! Its first characters, as many as fit into `bytes`, and no part of one.
std::string beginning(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xc0) == 0x80) --bytes;
  return text.substr(0, bytes);
}

}  // namespace

std::optional<Terminology> usable(Terminology terminology) {
  if (!isUsable(terminology.category) || !isUsable(terminology.type.term)) return std::nullopt;
  keepUsable(terminology.type.modifiers);
  keepUsable(terminology.region.modifiers);
  if (!isUsable(terminology.region.term)) terminology.region = {};
  return terminology;
}

std::string meaningOf(const Terminology& terminology) {
  const std::string what = meaningOf(terminology.type), where = meaningOf(terminology.region);
  return where.empty() ? what : what + "; " + where;
}

const char* algorithmTypeName(AlgorithmType type) {
  switch (type) {
    case AlgorithmType::manual:
      return "MANUAL";
    case AlgorithmType::automatic:
      return "AUTOMATIC";
    case AlgorithmType::semiautomatic:
      break;
  }
  return "SEMIAUTOMATIC";
}

std::optional<SegmentAlgorithm> algorithmSaid(const std::string& type, const std::string& name) {
  const auto found = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](AlgorithmType known) { return type == algorithmTypeName(known); });
  if (found == kTypes.end()) return std::nullopt;
  // PS3.3 has a name where the type is not manual, and only there; some write one all the same.
  const bool isNamed = *found != AlgorithmType::manual && isUsable(name, kLongestName);
  return SegmentAlgorithm{*found, isNamed ? name : std::string()};
}

const SegmentAlgorithm& ownAlgorithm() {
  static const SegmentAlgorithm own{AlgorithmType::semiautomatic, "Handlebody"};
  return own;
}

SegmentAlgorithm writtenAlgorithm(const std::optional<SegmentAlgorithm>& source) {
  if (!source || source->type == AlgorithmType::manual) return source.value_or(ownAlgorithm());
  const std::string& own = ownAlgorithm().name;
  const std::string behind = ", " + own;
  if (source->name.empty() || source->name == own) return {source->type, own};
  if (source->name.ends_with(behind)) return *source;  // it was here before
  return {source->type, beginning(source->name, kLongestName - behind.size()) + behind};
}

SegmentSource withoutSite(SegmentSource source) {
  if (source.algorithm) source.algorithm->name.clear();
  const auto& t = source.terminology;
  if (t && (isPrivate(t->category) || isPrivate(t->type) || isPrivate(t->region))) source.terminology.reset();
  return source;
}

}  // namespace handlebody
