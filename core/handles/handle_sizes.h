#pragma once
// Shared by the sources that list and count handles.

#include <span>

#include "core/handles/handle_enumeration.h"

namespace handlebody {

//! Throws UsageError unless there are handles to speak of: k and every size in range for the family.
void checkSizes(std::span<const int> sizes, Family family);

//! Each face with its least vertex first, orientation kept; faces sorted.
Handle normalised(Handle handle);

}  // namespace handlebody
