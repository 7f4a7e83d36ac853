// The man page of the command line has every option that the parser is given.

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/catch.h"

namespace {
namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::set<std::string> matches(const std::string& text, const std::string& pattern, int group) {
  const std::regex regex(pattern);
  return {std::sregex_token_iterator(text.begin(), text.end(), regex, group), std::sregex_token_iterator()};
}

//! Of literals that are an option's name and nothing else: "--seed", "-o,--output" (both), "--a{value}".
std::set<std::string> optionsOf(const std::string& source) {
  std::set<std::string> options;
  for (const std::string& names : matches(source, R"re("((?:-[A-Za-z],)?--[a-z][^"\s=]*)")re", 1))
    options.merge(matches(names, "(?:^|,)(--?[A-Za-z][A-Za-z-]*)", 1));
  return options;
}

//! What the page has not, each with a space behind it. In a man page a dash is `\-`, and `\fB` a font.
std::string missingOptions(const std::set<std::string>& options, const std::string& page) {
  const auto words = matches(std::regex_replace(page, std::regex(R"(\\(f.)?)"), ""), R"([\w-]+)", 0);
  std::string missing;
  for (const std::string& option : options)
    if (words.count(option) == 0) missing += option + " ";
  return missing;
}

}  // namespace

TEST_CASE("every option of the command line stands in its man page") {
  const fs::path root = HANDLEBODY_SOURCE_DIR;
  std::set<std::string> options = optionsOf(textOf(root / "core/io/report/growth_options.cpp"));
  for (const auto& source : fs::directory_iterator(root / "app/cli"))
    if (source.path().extension() == ".cpp" && source.path().filename() != "slurm.cpp")  // names sbatch's
      options.merge(optionsOf(textOf(source)));
  options.erase("--slurm-option");  // hidden: it hands on what follows --slurm
  CHECK(options.size() > 100);
  CHECK(missingOptions(options, textOf(root / "packaging/man/handlebody-cli.1")) == "");
}

TEST_CASE("an option that a man page lacks is told, however it is written") {
  const auto options = optionsOf(R"(add("--wall", "R"); f("-o,--output"); {"--a{1}"}; no("--walls: no");)");
  CHECK(options == std::set<std::string>{"--a", "--output", "--wall", "-o"});
  CHECK(missingOptions(options, R"("\-o, \-\-output" " OUT" \fB\-\-a\fR \-\-wall\-disc)") == "--wall ");
}
