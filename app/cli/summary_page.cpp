#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "app/cli/summary.h"
#include "core/io/report/json.h"

namespace handlebody::cli {

namespace {

// The policy forbids whatever would go to the network, should a text ever escape its quotes.
constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width">
<style>
body { font: 14px/1.4 sans-serif; margin: 1.5em; color: #1c2128; background: #fff; }
table { border-collapse: collapse; }
th, td { padding: .35em .6em; border-bottom: 1px solid #d0d4da; text-align: left; vertical-align: top; }
th { position: sticky; top: 0; background: #eef0f3; }
th button { all: unset; cursor: pointer; font-weight: bold; }
th button:focus-visible { outline: 2px solid #1460aa; }
th[aria-sort=ascending] button::after { content: " \25b2"; }
th[aria-sort=descending] button::after { content: " \25bc"; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
td img { width: 240px; height: 200px; display: block; }
tr.failed td, tr.refused td { background: #fdf0ee; }
ul { margin: 0; padding-left: 1.1em; }
p.notice { color: #555; }
</style>
)";

constexpr const char* kScript = R"(<script>
document.querySelectorAll("th button").forEach((button, column) => button.addEventListener("click", () => {
  const head = button.parentNode, up = head.getAttribute("aria-sort") !== "ascending";
  document.querySelectorAll("th").forEach(h => h.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", up ? "ascending" : "descending");
  const body = document.querySelector("tbody"), key = row => row.cells[column].dataset.key;
  const compare = (a, b) => isNaN(a) || isNaN(b) ? a.localeCompare(b) : a - b;
  [...body.rows].sort((a, b) => {
    const x = key(a), y = key(b);
    if (x === "" || y === "") return (x === "") - (y === "");  // what has no value comes last
    return up ? compare(x, y) : compare(y, x);
  }).forEach(row => body.append(row));
}));
</script>
)";

std::string escaped(const std::string& text) {
  std::string safe;
  for (char c : text) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  return safe;
}

//! A relative path as the value of an attribute that is a link.
std::string link(const std::string& path) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  static const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string safe;
  for (char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain.find(c) != std::string::npos)
      safe += c;
    else
      safe += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
  }
  return safe;
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const unsigned group = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
  }
  return text;
}

//! With so many decimals, a full stop before them.
std::string fixed(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return error == std::errc() ? std::string(buffer.data(), end) : "";
}

std::string cell(const std::string& html, const std::string& key) {
  return "<td data-key=\"" + escaped(key) + "\">" + html + "</td>";
}
std::string number(double value, int decimals) {
  return "<td class=\"number\" data-key=\"" + fixed(value, 6) + "\">" + fixed(value, decimals) + "</td>";
}

std::string anchor(const std::string& path, const std::string& html) {
  return "<a href=\"" + link(path) + "\">" + html + "</a>";
}

std::string pictureCell(const SummaryRow& row) {
  if (row.thumbnail.empty()) return cell("", "");
  const std::string image = "<img alt=\"Picture of " + escaped(row.name) + "\" src=\"data:image/png;base64," +
                            base64(row.thumbnail) + "\">";
  return cell(anchor(row.folder + "/picture.png", image), row.name);
}

std::string listed(const std::vector<std::string>& items) {
  if (items.empty()) return "";
  std::string list = "<ul>";
  for (const std::string& item : items) list += "<li>" + escaped(item) + "</li>";
  return list + "</ul>";
}

std::string linksOf(const SummaryRow& row) {
  std::string links;
  for (const std::string& file : row.files)
    links += (links.empty() ? "" : " ") + anchor(row.folder + "/" + file, escaped(file));
  if (!row.log.empty()) links += anchor(row.log, "log");
  return links;
}

constexpr std::array kColumns{"Picture",    "Case",         "Line",           "Status",     "Volume, ml",
                              "Area, cm²",  "Diameter, mm", "Mean intensity", "Components", "Genus",
                              "Iterations", "Ended",        "No edge, %",     "Time, s",    "Memory, MB",
                              "Notes",      "Files"};

std::string genusCell(const std::vector<int>& genus) {
  std::string text;
  int sum = 0;
  for (int g : genus) {
    text += (text.empty() ? "" : ", ") + std::to_string(g);
    sum += g;
  }
  return "<td class=\"number\" data-key=\"" + std::to_string(sum) + "\">" + text + "</td>";
}

std::string measureCells(const std::optional<CaseMeasures>& m) {
  std::string cells;
  if (!m) {
    for (int i = 0; i < 11; ++i) cells += cell("", "");
    return cells;
  }
  cells += number(m->volume / 1000, 3) + number(m->area / 100, 2) + number(m->largestDiameter, 1) +
           (m->meanIntensity ? number(*m->meanIntensity, 1) : cell("", "")) + number(m->components, 0) +
           genusCell(m->genus);
  cells += number(m->iterations, 0) + cell(escaped(m->stopped), m->stopped) +
           (m->unsupportedSurface ? number(100 * *m->unsupportedSurface, 1) : cell("", ""));
  return cells + number(m->seconds, 1) + number(m->peakMegabytes, 0);
}

//! Only where some case is carried over time.
constexpr std::array kTimeColumns{"Stroke volume, ml", "Ejection fraction, %", "Frames failed"};

std::string timeCells(const std::optional<CaseMeasures>& m) {
  const auto& time = m ? m->overTime : std::nullopt;
  if (!time) return cell("", "") + cell("", "") + cell("", "");
  const std::string failed = std::to_string(time->failed) + " of " + std::to_string(time->frames);
  return (time->strokeVolume ? number(*time->strokeVolume / 1000, 1) : cell("", "")) +
         (time->ejectionFraction ? number(100 * *time->ejectionFraction, 1) : cell("", "")) +
         cell(failed, std::to_string(time->failed));
}

std::string rowOf(const SummaryRow& row, bool hasTime) {
  std::vector<std::string> notes;
  if (!row.message.empty()) notes.push_back(row.message);
  if (row.measures) notes.insert(notes.end(), row.measures->warnings.begin(), row.measures->warnings.end());
  const std::string count = notes.empty() ? "" : std::to_string(notes.size());
  const std::string status = statusName(row.status);
  return "<tr class=\"" + status + "\">" + pictureCell(row) + cell(escaped(row.name), row.name) +
         number(row.line, 0) + cell(status, status) + measureCells(row.measures) +
         (hasTime ? timeCells(row.measures) : "") + cell(listed(notes), count) + cell(linksOf(row), count) +
         "</tr>\n";
}

std::string counts(const Summary& summary) {
  std::string text;
  for (CaseStatus status : {CaseStatus::done, CaseStatus::failed, CaseStatus::refused, CaseStatus::notRun})
    text += (text.empty() ? "" : ", ") + std::to_string(summary.count(status)) + " " + statusName(status);
  return text;
}

}  // namespace

std::string summaryPage(const Summary& summary) {
  const std::string study = escaped(summary.study);
  std::string page = kHead;
  page += "<title>" + study + "</title>\n</head>\n<body>\n<h1>" + study + "</h1>\n<p>" + counts(summary) +
          ". handlebody-cli " + escaped(summary.version) + ".</p>\n<p class=\"notice\">" + kNotice +
          "</p>\n<table>\n<thead><tr>";
  const bool hasTime = std::any_of(summary.rows.begin(), summary.rows.end(), [](const SummaryRow& row) {
    return row.measures && row.measures->overTime;
  });
  const auto head = [&page](const char* column) {
    page += std::string("<th scope=\"col\"><button>") + column + "</button></th>";
  };
  const auto notes = std::find(kColumns.begin(), kColumns.end(), std::string("Notes"));
  std::for_each(kColumns.begin(), notes, head);
  if (hasTime) std::for_each(kTimeColumns.begin(), kTimeColumns.end(), head);
  std::for_each(notes, kColumns.end(), head);
  page += "</tr></thead>\n<tbody>\n";
  for (const SummaryRow& row : summary.rows) page += rowOf(row, hasTime);
  return page + "</tbody>\n</table>\n" + kScript + "</body>\n</html>\n";
}

}  // namespace handlebody::cli
