#include "app/cli/summary.h"

#include <nlohmann/json.hpp>

#include "app/cli/csv.h"
#include "tests/support/catch.h"

using namespace handlebody::cli;

namespace {

const std::string kEvil = "</td><script>alert('x')</script>\"&";

Summary evilSummary() {
  SummaryRow done;
  done.line = 2;
  done.name = kEvil;
  done.volume = kEvil;
  done.status = CaseStatus::done;
  done.folder = "cases/" + kEvil + " %#?";
  done.files = {"mesh.stl"};
  done.thumbnail = "ABCD";
  done.measures = CaseMeasures{};
  done.measures->volume = 1234.5;
  done.measures->largestDiameter = 12.25;
  done.measures->extents = {12, 7.5, 3};
  done.measures->meanIntensity = -4.5;
  done.measures->genus = {1, 0};
  done.measures->stopped = "converged";
  done.measures->warnings = {kEvil, "second"};
  SummaryRow refused;
  refused.line = 3;
  refused.name = "b";
  refused.status = CaseStatus::refused;
  refused.message = "line 3: " + kEvil;
  return {kEvil + ".csv", "1.2.3", {done, refused}};
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("no text of a study becomes markup of the page", "[summary]") {
  const std::string page = summaryPage(evilSummary());
  CHECK(occurrences(page, "<script>") == 1);
  CHECK(occurrences(page, "</script>") == 1);
  CHECK(page.find("alert('") == std::string::npos);
  CHECK(page.find("&lt;script&gt;") != std::string::npos);
  CHECK(page.find("href=\"cases/%3C/td%3E%3Cscript%3E") != std::string::npos);
  CHECK(page.find("%20%25%23%3F/mesh.stl\"") != std::string::npos);
}

TEST_CASE("the page needs no network and shows measures with units and pictures", "[summary]") {
  const std::string page = summaryPage(evilSummary());
  CHECK(page.find("http:") == std::string::npos);
  CHECK(page.find("https:") == std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(page.find("data:image/png;base64,QUJDRA==") != std::string::npos);
  CHECK(page.find("Volume, ml") != std::string::npos);
  CHECK(page.find(">1.234<") + page.find(">1.235<") != 2 * std::string::npos);
  CHECK(occurrences(page, "<tr class=") == 2);
  // As many cells as heads, for those without a result, too: else sorting compares different things.
  CHECK(occurrences(page, "<td") == 2 * occurrences(page, "<th scope"));
}

TEST_CASE("table and JSON of a summary say the same", "[summary]") {
  const Summary summary = evilSummary();
  const auto rows = parseCsv(summaryCsv(summary), "summary.csv");
  const auto json = nlohmann::json::parse(summaryJson(summary));
  REQUIRE(rows.size() == 3);
  for (const CsvRow& row : rows) CHECK(row.cells.size() == rows[0].cells.size());
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < rows[0].cells.size(); ++i) cells[rows[0].cells[i].text] = rows[1].cells[i].text;
  CHECK(cells["case"] == kEvil);
  CHECK(cells["volume_mm3"] == "1234.5");
  CHECK(cells["genus"] == "1;0");
  CHECK(cells["unsupported_surface"].empty());  // it was not compared with the image
  CHECK(cells["largest_diameter_mm"] == "12.25");
  CHECK(cells["principal_extents_mm"] == "12.0;7.5;3.0");
  CHECK(cells["mean_intensity"] == "-4.5");
  CHECK(cells["warnings"] == kEvil + ";second");
  CHECK(json["cases"][0]["case"] == kEvil);
  CHECK(json["cases"][0]["measures"]["volume_mm3"] == 1234.5);
  CHECK(json["counts"]["done"] == 1);
  CHECK(json["counts"]["refused"] == 1);
  CHECK(json["cases"][1]["message"] == summary.rows[1].message);
  CHECK_FALSE(json["cases"][1].contains("measures"));
}
