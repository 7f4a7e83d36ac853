#pragma once
// Internal: exceptions of the libraries below as ours. No type of a library appears here.

#include <functional>
#include <string>

#include "core/finding.h"

namespace handlebody {

//! Runs f; exceptions of ITK, GDCM and the standard library become InputErrors: `what`, with their
//! description as "reason".
void withItk(const std::string& path, const Finding& what, const std::function<void()>& f);

}  // namespace handlebody
