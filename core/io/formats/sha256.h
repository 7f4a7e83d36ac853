#pragma once

#include <cstddef>
#include <string>

namespace handlebody {

//! SHA-256 of a text; lower-case hex. Those of files: sha256OfPath in volume_io.h.
std::string sha256OfText(const std::string& text);
//! The same of a text and what follows it.
std::string sha256OfBytes(const std::string& head, const void* bytes, std::size_t count);

}  // namespace handlebody
