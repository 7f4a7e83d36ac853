#include "app/cli/csv.h"

#include "core/errors.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::cli;

namespace {

std::vector<std::vector<std::string>> texts(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  for (const CsvRow& row : parseCsv(text, "s.csv")) {
    rows.emplace_back();
    for (const CsvCell& cell : row.cells) {
      CHECK(cell.fault == "");
      rows.back().push_back(cell.text);
    }
  }
  return rows;
}

using Rows = std::vector<std::vector<std::string>>;

}  // namespace

TEST_CASE("cells are read as RFC 4180 has them", "[csv]") {
  CHECK(texts("a,b\r\n1,2\r\n") == Rows{{"a", "b"}, {"1", "2"}});
  CHECK(texts("a,b\n1,2") == Rows{{"a", "b"}, {"1", "2"}});
  CHECK(texts("\"a,b\",\"say \"\"x\"\"\",\"\"\n") == Rows{{"a,b", "say \"x\"", ""}});
  CHECK(texts("a,,\n") == Rows{{"a", "", ""}});
  CHECK(texts("\xef\xbb\xbf"
              "a,\xc3\xa4\n") == Rows{{"a", "\xc3\xa4"}});
  CHECK(texts(" a , b c\t,\" d \" \n") == Rows{{"a", "b c", " d "}});
  CHECK(texts("a\n\n,,\r\nb\n") == Rows{{"a"}, {"b"}});
  CHECK(texts("").empty());
}

TEST_CASE("what csvLine writes is read back", "[csv]") {
  const std::vector<std::string> cells{"a", "b,c", "\"", "say \"x\", y", "", "-5.5", "\xc3\xa4"};
  CHECK(texts(csvLine(cells)) == Rows{cells});
}

TEST_CASE("a spreadsheet does not take a written text for a formula", "[csv]") {
  CHECK(csvLine({"=1+1", "-5", "--seed", "@a", "+x"}) == "'=1+1,-5,'--seed,'@a,'+x\r\n");
}

TEST_CASE("rows know the line on which they begin", "[csv]") {
  const auto rows = parseCsv("a\r\n\r\n\"x\ny\"\nb\n", "s.csv");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].line == 1);
  CHECK(rows[1].line == 3);
  CHECK(rows[2].line == 5);
}

TEST_CASE("what is wrong within a cell is that cell's fault alone", "[csv]") {
  for (const std::string bad : {"\"a\"b", "a\"b", "\xff", "\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80",
                                "\xc3", "a\x01", "\"a\nb\"", "a\rb"}) {
    INFO(bad);
    const auto rows = parseCsv("x," + bad + ",y\nz\n", "s.csv");
    REQUIRE(rows.size() == 2);
    REQUIRE(rows[0].cells.size() == 3);
    CHECK(rows[0].cells[0].fault == "");
    CHECK(rows[0].cells[1].fault != "");
    CHECK(rows[0].cells[2].text == "y");
    CHECK(rows[1].cells[0].text == "z");
  }
}

TEST_CASE("a cell of a megabyte is a fault, and messages quote long texts in part", "[csv]") {
  const auto rows = parseCsv("a,\"" + std::string(1000000, 'x') + "\"\nb,c\n", "t.csv");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].cells[0].fault.empty());
  CHECK(rows[0].cells[1].fault == "is longer than 100000 bytes");
  CHECK(rows[0].cells[1].text.empty());
  CHECK(rows[1].cells[1].text == "c");
  CHECK(shortened("abc", 3) == "abc");
  CHECK(shortened("abcdef", 4) == "ab … ef");
  CHECK(shortened("a\u00e4\u00e4\u00e4\u00e4b", 4) == "a … \u00e4b");  // whole characters
}

TEST_CASE("a table without end of its rows is refused with the line", "[csv]") {
  CHECK_THROWS_WITH(parseCsv("a\n\"b\nc\n", "s.csv"), "s.csv: line 2: a quotation mark is not closed.");
  CHECK_THROWS_AS(parseCsv("a\n\"b\"\"", "s.csv"), InputError);
  CHECK_THROWS_AS(parseCsv(std::string("\xff\xfe"
                                       "a\0",
                                       4),
                           "s.csv"),
                  InputError);
}
