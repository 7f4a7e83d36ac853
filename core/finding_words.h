#pragma once
// Internal: the table of words of findings, which is in four sources.

#include <span>

#include "core/finding.h"

namespace handlebody {

struct FindingWords {
  FindingKind kind;
  const char* name;
  const char* text;
};

//! Of the kinds from fileRefused to onlyFrame, but for those of the next two, from startAndGiven to badList
//! and from fieldMissing on.
std::span<const FindingWords> wordsOfFiles();

//! Of the kinds from dicomDamaged to decodingFailed.
std::span<const FindingWords> wordsOfDicom();

//! Of the kinds from colourAsLuminance to noCavity.
std::span<const FindingWords> wordsOfWarnings();

//! The inverse of findingName; FindingKind::none for what is no name.
FindingKind findingKindOf(std::string_view name);

}  // namespace handlebody
