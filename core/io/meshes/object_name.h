#pragma once
// Which names objects may have in the files of all formats.

#include <cstddef>
#include <optional>
#include <string>

namespace handlebody {

enum class NameFault { none, empty, notUtf8, tooLong, controlCharacter, separator };

//! Separators are characters that separate in some of the formats: see kNameSeparators.
NameFault nameFaultOf(const std::string& name);

inline constexpr const char* kNameSeparators = "\"\\|~^";
inline constexpr std::size_t kLongestName = 64;  //!< characters, of DICOM's LO

//! The number of characters; nothing if the bytes are not UTF-8.
std::optional<std::size_t> charactersOf(const std::string& text);

}  // namespace handlebody
