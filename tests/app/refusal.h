#pragma once
// What every refusal of bad input looks like.

#include <algorithm>

#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

namespace handlebody::test {

//! The right exit code, one sentence that names the file or the option, and a folder whose contents stay as
//! they are.
inline void requireRefusal(const TempFolder& folder, const std::vector<std::string>& arguments, int exitCode,
                           const std::string& named) {
  const auto before = folder.names();
  const Outcome outcome = runCli(arguments);
  INFO("error line: " << outcome.err);
  CHECK(outcome.exitCode == exitCode);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains(named) && Catch::Matchers::EndsWith(".\n"));
  CHECK(folder.names() == before);
}

}  // namespace handlebody::test
