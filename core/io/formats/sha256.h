#pragma once

#include <string>

namespace handlebody {

//! SHA-256 of a text; lower-case hex. Those of files: sha256OfPath in volume_io.h.
std::string sha256OfText(const std::string& text);

}  // namespace handlebody
