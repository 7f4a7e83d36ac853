#pragma once
// Errors of the engine carry a finding (core/told_error.h): words alone are English in every language. Works
// on source text, as include_rules.h.

#include <string>
#include <vector>

#include "tests/layering/include_rules.h"

namespace handlebody::test {

//! One sentence, "FILE:LINE: …", for each error of core/errors.h in core that has words alone, but for a few
//! files that no window tells of.
std::vector<std::string> plainErrors(const SourceTree& sources);

}  // namespace handlebody::test
