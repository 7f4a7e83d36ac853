// The glossary's words for code, in the project itself and in small ones.

#include "tests/references/forbidden_words.h"

#include <fstream>
#include <sstream>

#include "tests/support/catch.h"

using namespace handlebody::test;

namespace {

std::vector<std::string> wordsIn(const std::string& path, const std::string& line) {
  Project project;
  project.linesOf[path] = {"// first", line};
  return forbiddenWords(project);
}

}  // namespace

TEST_CASE("no source writes what the glossary says is not to be written") {
  const Project project = readProject(HANDLEBODY_SOURCE_DIR);
  REQUIRE(project.linesOf.count("core/mesh/mesh.h") == 1);
  REQUIRE(project.linesOf.count("ui/window/grow/grow_panel.cpp") == 1);
  std::string all;
  for (const std::string& one : forbiddenWords(project)) all += one + "\n";
  CHECK(all == "");
}

TEST_CASE("each word that is looked for stands in the glossary's column of what not to write") {
  std::ifstream page(std::string(HANDLEBODY_SOURCE_DIR) + "/docs/glossary.md");
  std::string column;
  bool isThere = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) isThere = line == "## Words for code";
    const auto second = line.find(" | ");
    if (isThere && second != std::string::npos) column += line.substr(second) + "\n";
  }
  for (const std::string& word : wordsLookedFor()) {
    INFO(word);
    CHECK(column.find(word) != std::string::npos);
  }
}

TEST_CASE("a word that is not to be written is told with file, line and what to write") {
  const auto found = wordsIn("core/a.cpp", "constexpr int kMostFronts = 3;");
  REQUIRE(found.size() == 1);
  CHECK(found[0] == "core/a.cpp:2: kMostFronts: write `kMax…`");
  CHECK(wordsIn("core/a.h", "constexpr double kLeast = 3;").size() == 1);
  CHECK(wordsIn("ui/a.cpp", "// nought of it").size() == 1);
  CHECK(wordsIn("tests/a.cpp", "TEST_CASE(\"it is nought\")").empty());
  CHECK(wordsIn("core/a.cpp", "// its hunger for memory").size() == 1);
}

TEST_CASE("an int needs no cast to be an index, a product of ints does") {
  for (const char* cast : {"v[static_cast<std::size_t>(i)]", "v[static_cast<std::size_t>(i) + 1]",
                           "v[static_cast<std::size_t>(c[2])]", "v[static_cast<std::size_t>(e.low) - n]"}) {
    INFO(cast);
    CHECK(wordsIn("core/a.cpp", cast).size() == 1);
  }
  for (const char* right : {"v[i]", "v[idx(y) * row + idx(x)]", "v[indexOf(kind)]",
                            "v[static_cast<std::size_t>(part * n)]", "v[static_cast<std::size_t>(i) % n]"}) {
    INFO(right);
    CHECK(wordsIn("core/a.cpp", right).empty());
  }
}
