// What the pages for developers name, in the project itself and in small ones.

#include "tests/references/references.h"

#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>

#include "tests/support/catch.h"

using namespace handlebody::test;

namespace {

const Project kSmall{
    {"core", "core/mesh.h", "tests", "tests/a_test.cpp", "tests/b_test.cpp", "docs", "docs/page.md"},
    {{"tests/a_test.cpp", {"a mesh is closed"}}, {"tests/b_test.cpp", {"a hole is open"}}},
    {"Mesh", "findEdge", "--seed"},
    {{"core/mesh", {"Mesh"}}},
    {{"core/mesh.h", {"class Mesh;", "int findEdge(const Mesh& mesh);", "// findEdges"}}}};

std::vector<std::string> broken(const std::string& text) {
  return brokenReferences(kSmall, "docs/page.md", text);
}

std::string pageOf(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(std::string(HANDLEBODY_SOURCE_DIR) + "/" + name).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("every file, test and name in the pages for developers is there") {
  const Project project = readProject(HANDLEBODY_SOURCE_DIR);
  REQUIRE(project.paths.count("core/mesh/mesh.h") == 1);
  REQUIRE(project.tests.count("tests/layering/layering_test.cpp") == 1);
  for (const char* page : {"docs/paper.md", "docs/architecture.md", "docs/formats.md", "docs/glossary.md",
                           "docs/reference.md", "CONTRIBUTING.md"}) {
    const std::string text = pageOf(page);
    CHECK(text.size() > 500);
    std::string all;
    for (const std::string& one : brokenReferences(project, page, text)) all += one + "\n";
    CHECK(all == "");
  }
}

TEST_CASE("a path that is not there is told with page and line") {
  CHECK(broken("`core/mesh.h` and `core/mesh` and `core`").empty());
  const auto found = broken("first\n\nsee `core/gone.h`\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0] == "docs/page.md:3: there is no file core/gone.h");
}

TEST_CASE("a test is looked for in the source that was named before it on the line") {
  CHECK(broken("`\"a mesh is closed\"`").empty());
  CHECK(broken("`tests/a_test.cpp`: `\"a mesh is closed\"`").empty());
  CHECK(broken("`\"a mesh is shut\"`").size() == 1);
  const auto found = broken("`tests/b_test.cpp`: `\"a mesh is closed\"`");
  REQUIRE(found.size() == 1);
  CHECK(found[0] == "docs/page.md:1: there is no test \"a mesh is closed\" in tests/b_test.cpp");
}

TEST_CASE("names of types, functions and options have to occur") {
  CHECK(broken("`Mesh`, `Mesh::findEdge`, `findEdge()`, `--seed`").empty());
  CHECK(broken("`Mash`").size() == 1);
  CHECK(broken("`Mesh::findEgde()`").size() == 1);
  CHECK(broken("`--sead`").size() == 1);
}

TEST_CASE("names in a list behind a source are looked for there") {
  CHECK(broken("`core/mesh.h`: `Mesh`").empty());
  CHECK(broken("`core/mesh.h` and `findEdge`").empty());
  CHECK(broken("`core/mesh.h`: `Mesh`; `findEdge`").empty());
  const auto found = broken("`core/mesh.h`: `Mesh`, `findEdge`");
  REQUIRE(found.size() == 1);
  CHECK(found[0] == "docs/page.md:1: nothing is called findEdge in core/mesh.h");
}

TEST_CASE("a line that is named holds the name that stands behind it") {
  CHECK(broken("`core/mesh.h:1` `Mesh`, `core/mesh.h:2` `Mesh::findEdge` | `findEdge`").empty());
  const auto moved = broken("`core/mesh.h:1` `findEdge`");
  REQUIRE(moved.size() == 1);
  CHECK(moved[0] == "docs/page.md:1: core/mesh.h:1 does not say findEdge, which stands on line 2");
  const auto beyond = broken("`core/mesh.h:9` `Mesh`");
  REQUIRE(beyond.size() == 1);
  CHECK(beyond[0] == "docs/page.md:1: core/mesh.h:9 does not say Mesh, which stands on line 1, 2");
  CHECK(broken("`core/mesh.h:0` `Mesh`").size() == 1);
  CHECK(broken("`core/gone.h:1` `Mesh`").size() == 1);
  CHECK(broken("`core/mesh.h:1`").size() == 1);
  CHECK(broken("`core/mesh.h:1`, `core/mesh.h:2` `findEdge`").size() == 1);
}

TEST_CASE("each of the twenty statements of the paper has a line and a test") {
  const std::string page = pageOf("docs/paper.md");
  const auto from = page.find("## Twenty statements");
  REQUIRE(from != std::string::npos);
  std::istringstream section(page.substr(from, page.find("\n## ", from) - from));
  const std::regex row(R"re(\| (\d+) \| .* \| `core/[\w./]+:\d+` `.* \| `tests/[\w./]+`: `".*"` \|)re");
  std::vector<int> rows, twenty(20);
  std::iota(twenty.begin(), twenty.end(), 1);
  std::smatch match;
  for (std::string line; std::getline(section, line);)
    if (std::regex_match(line, match, row)) rows.push_back(std::stoi(match[1]));
  CHECK(rows == twenty);
}

TEST_CASE("links lead to files of the project, from the page's folder") {
  CHECK(broken("[core](../core/mesh.h), [page](page.md#part), [web](https://example.org/a)").empty());
  CHECK(broken("[core](core/mesh.h)").size() == 1);
}

TEST_CASE("commands, formulas and blocks of code are left alone") {
  CHECK(broken("`cmake --build build` `2(k-1)` `m1 + m2`\n    `core/gone.h`\n```\n`core/gone.h`\n```\n")
            .empty());
}
