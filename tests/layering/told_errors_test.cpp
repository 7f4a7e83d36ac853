#include "tests/layering/told_errors.h"

#include "tests/support/catch.h"

using namespace handlebody::test;

TEST_CASE("every error of the engine carries a finding, so that the window can tell it in any language") {
  const SourceTree sources = readSources(HANDLEBODY_SOURCE_DIR);
  REQUIRE(sources.count("core/told_error.h") == 1);
  std::string all;
  for (const std::string& error : plainErrors(sources)) all += error + "\n";
  CHECK(all == "");
}

TEST_CASE("an error that has words alone is found, however it is thrown") {
  const auto found = [](const std::string& text) { return plainErrors({{"core/mesh/a.cpp", text}}); };
  CHECK(found("\nif (bad) throw UsageError(\"It is.\");").size() == 1);
  CHECK(found("\nif (bad) throw UsageError(\"It is.\");")[0].rfind("core/mesh/a.cpp:2: ", 0) == 0);
  CHECK(found("throw\n    InputError(path + text);").size() == 1);
  CHECK(found("throw OutputError{what};").size() == 1);
  CHECK(found("throw SeedError(text());").size() == 1);
  CHECK(found("Worse::Worse() : UsageError(text()) {}").size() == 1);
  CHECK(found("refuseInput(path, \"is damaged\");").size() == 1);
  CHECK(found("throw Told<UsageError>(K::noSeed);").empty());
  CHECK(found("//! Throws InputError, UsageError (a range), and what else there is to throw InputError (x).")
            .empty());
  CHECK(found("catch (const UsageError& error) {}").empty());
  CHECK(found("refuseInput(path, {K::noSeed, {{\"field\", 1}}});").empty());
  CHECK(plainErrors({{"app/cli/a.cpp", "throw UsageError(\"-o: it is.\");"}}).empty());
}
