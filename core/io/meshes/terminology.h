#pragma once
// What the file of a segment says of it that our own list of terms has no word for: codes of any scheme, and
// how the segment was made.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace handlebody {

//! A coded concept as it was read: retired codes (SRT) and those of other schemes are not translated.
struct CodedTerm {
  std::string value{};    //!< 1 to 16 characters, of DICOM's SH
  std::string scheme{};   //!< its designator, "SCT"; 1 to 16 characters
  std::string meaning{};  //!< 1 to 64 characters, of DICOM's LO

  friend bool operator==(const CodedTerm&, const CodedTerm&) = default;
};

//! A concept and what qualifies it: "Kidney", "Left".
struct ModifiedTerm {
  CodedTerm term{};
  std::vector<CodedTerm> modifiers{};

  friend bool operator==(const ModifiedTerm&, const ModifiedTerm&) = default;
};

//! What a segment is, as DICOM (PS3.3 C.8.20.4) and 3D Slicer say it.
struct Terminology {
  CodedTerm category{};
  ModifiedTerm type{};
  ModifiedTerm region{};  //!< where it is; without a code value: not said

  friend bool operator==(const Terminology&, const Terminology&) = default;
};

inline constexpr std::size_t kMaxModifiers = 16;  //!< a file may hold any number

//! Without what DICOM or 3D Slicer's text could not hold: a code that is incomplete, too long, not UTF-8, or
//! holds a control character, backslash, bar, tilde or caret. Such modifiers, those beyond
//! kMaxModifiers and such a region are left out; nothing if it is the category or the type.
std::optional<Terminology> usable(Terminology terminology);

//! What it means, for lists: "Kidney, Left; Abdomen".
std::string meaningOf(const Terminology& terminology);

enum class AlgorithmType { manual, semiautomatic, automatic };

//! As DICOM calls it: "MANUAL" …
const char* algorithmTypeName(AlgorithmType type);

//! How a segment was made.
struct SegmentAlgorithm {
  AlgorithmType type = AlgorithmType::semiautomatic;
  std::string name{};  //!< empty: none, as of all that are manual

  friend bool operator==(const SegmentAlgorithm&, const SegmentAlgorithm&) = default;
};

//! Nothing for a type that DICOM does not have; a name that DICOM or 3D Slicer's text could not hold is none.
std::optional<SegmentAlgorithm> algorithmSaid(const std::string& type, const std::string& name);
//! That of what grew here.
const SegmentAlgorithm& ownAlgorithm();
//! How a segment of this source is written here: of its type, with both names; `ownAlgorithm` without one.
SegmentAlgorithm writtenAlgorithm(const std::optional<SegmentAlgorithm>& source);

struct SegmentSource {
  std::optional<Terminology> terminology{};     //!< goes before a term of our list
  std::optional<SegmentAlgorithm> algorithm{};  //!< holds for the surface as it is in the file alone

  friend bool operator==(const SegmentSource&, const SegmentSource&) = default;
};

//! For what is to name nobody: without the name of the algorithm and terms of private schemes, which may be a
//! site's own.
SegmentSource withoutSite(SegmentSource source);

}  // namespace handlebody
