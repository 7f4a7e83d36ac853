#pragma once
// Internal: GIPL volumes.

#include <string>

#include "core/io/formats/volume_source.h"

namespace handlebody {

//! Throws InputError with one sentence that begins with the path.
SourcePointer openGipl(const std::string& path);

}  // namespace handlebody
