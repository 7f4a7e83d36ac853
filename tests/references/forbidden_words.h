#pragma once
// What the glossary says is not to be written in code.

#include <string>
#include <vector>

#include "tests/references/references.h"

namespace handlebody::test {

//! The entries of the glossary's column "not" that a look at the text can tell, as they stand there.
std::vector<std::string> wordsLookedFor();

//! One sentence, "FILE:LINE: …", for each place in C++ and Python that holds one of them.
std::vector<std::string> forbiddenWords(const Project& project);

}  // namespace handlebody::test
