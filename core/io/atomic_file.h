#pragma once
// Files that are written whole or not at all.

#include <functional>
#include <string>

#include "core/finding.h"

namespace handlebody {

//! Throws OutputError: "path: cannot be written: cause.", with the finding.
[[noreturn]] void refuseOutput(const std::string& path, const Finding& cause);

//! What an errno says, as the end of a sentence.
Finding systemFinding(int error);

//! Calls `write` with a temporary name in the folder of `path` (same ending in lower case, so that a
//! writer can choose its format by it) and then renames that file to `path`. If anything fails or throws, the
//! temporary file is removed and what was at `path` before stays. Throws OutputError (which names `path`) if
//! the file cannot be created or renamed, and whatever `write` throws.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write);

//! Writes `text` to `path`, whole or not at all. Throws OutputError.
void writeTextAtomically(const std::string& path, const std::string& text);

}  // namespace handlebody
