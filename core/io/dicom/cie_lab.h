#pragma once
// Internal: colours as DICOM has them.

#include <array>
#include <cstdint>

#include "core/io/meshes/exported_object.h"

namespace handlebody::dicom {

//! CIELab under D50, as DICOM scales it to 16 bits (PS3.3 C.10.7.1.1).
using CieLab = std::array<std::uint16_t, 3>;

CieLab cieLab(const Colour& colour);
//! The nearest in sRGB; what cieLab has made comes back as it was.
Colour colourOf(const CieLab& lab);

}  // namespace handlebody::dicom
