#include "tests/references/forbidden_words.h"

#include <filesystem>
#include <regex>

namespace handlebody::test {

namespace {

struct Rule {
  std::string word;  // in the glossary
  std::string instead;
  std::regex pattern;
  bool inTests;
};

//! What no pattern can tell is left to the reader: `before` and `behind` are right where no loop is meant.
const std::vector<Rule>& rules() {
  static const std::vector<Rule> kRules{
      {"`kMost…`", "`kMax…`", std::regex("\\bkMost([A-Z]\\w*)?\\b"), true},
      {"`kLeast…`", "`kMin…`", std::regex("\\bkLeast([A-Z]\\w*)?\\b"), true},
      {"nought", "zero", std::regex("\\b[Nn]ought"), false},
      {"hunger", "memory use", std::regex("\\b[Hh]unger"), true},
      {"`v[static_cast<std::size_t>(i)]`", "`v[i]`, idx() or indexOf()",
       std::regex("\\[static_cast<std::size_t>\\([\\w.\\[\\]*]+\\)( [+-] \\w+)?\\]"), true}};
  return kRules;
}

bool isRead(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  return (ending == ".h" || ending == ".cpp" || ending == ".py") && path.rfind("tests/references/", 0) != 0;
}

}  // namespace

std::vector<std::string> wordsLookedFor() {
  std::vector<std::string> words;
  for (const Rule& rule : rules()) words.push_back(rule.word);
  return words;
}

std::vector<std::string> forbiddenWords(const Project& project) {
  std::vector<std::string> found;
  for (const auto& [path, lines] : project.linesOf) {
    if (!isRead(path)) continue;
    const bool isTest = path.rfind("tests/", 0) == 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Rule& rule : rules()) {
        std::smatch match;
        if ((isTest && !rule.inTests) || !std::regex_search(lines[i], match, rule.pattern)) continue;
        found.push_back(path + ":" + std::to_string(i + 1) + ": " + match.str() + ": write " + rule.instead);
      }
  }
  return found;
}

}  // namespace handlebody::test
