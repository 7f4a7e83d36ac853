#include "core/finding.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/number_text.h"

namespace handlebody {

const FindingValue* Finding::find(std::string_view name) const {
  const auto at = std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
  return at == values.end() ? nullptr : &at->second;
}

double Finding::number(std::string_view name) const {
  const FindingValue* value = find(name);
  if (!value || !std::holds_alternative<double>(*value))
    throw std::logic_error("A finding has no number of that name.");
  return std::get<double>(*value);
}

namespace {

std::string listed(const std::vector<Finding>& entries, const char* between, const CauseWriter& told) {
  std::string text;
  for (const Finding& entry : entries) text += (&entry == &entries.front() ? "" : between) + told(entry);
  return text;
}

}  // namespace

std::string dashed(std::string_view option) { return "--" + std::string(option); }

std::string filled(std::string_view text, const Finding& finding, const ValueWriter& written,
                   const CauseWriter& told, OptionSpelling spelled) {
  std::string out;
  while (!text.empty()) {
    const auto open = text.find('{'), close = text.find('}', open);
    out += text.substr(0, open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    const std::string_view hole = text.substr(open + 1, close - open - 1);
    const auto colon = hole.find(':');
    const std::string_view name = hole.substr(0, colon);
    const std::string_view format = colon == std::string_view::npos ? "" : hole.substr(colon + 1);
    if (name == "option")
      out += spelled(format);
    else if (const FindingValue* value = finding.find(name))
      out += written(name, *value, format);
    else if (name == "cause" && !finding.causes.empty())
      out += told(finding.causes.front());
    else if (name == "list" || name == "choices")
      out += listed(finding.causes, name == "list" ? ", " : "; ", told);
    else
      out += text.substr(open, close - open + 1);
    text.remove_prefix(close + 1);
  }
  return out;
}

namespace {

constexpr double kPlain = 1e15;  // what is larger has an exponent, not hundreds of digits

std::string number(double value, const std::string& format) {
  if (format.empty() || std::abs(value) >= kPlain) return numberText(value);
  if (format.back() == 'm') return std::abs(value) >= 100 ? fixedText(value, 0) : numberText(value, 3);
  if (format.back() == 'f') return fixedText(value, std::stoi(format));
  return numberText(value, std::stoi(format));
}

std::string inEnglish(const FindingValue& value, std::string_view format) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* x = std::get_if<double>(&value)) return number(*x, std::string(format));
  const auto& place = std::get<std::array<double, 3>>(value);
  const bool isWide = !format.empty() && format.front() == ' ';
  const std::string each(format.substr(isWide ? 1 : 0)), comma = isWide ? ", " : ",";
  return number(place[0], each) + comma + number(place[1], each) + comma + number(place[2], each);
}

}  // namespace

std::string sentence(const Finding& finding) { return sentence(finding, &dashed); }

std::string sentence(const Finding& finding, OptionSpelling spelled) {
  return filled(
      findingText(finding.kind), finding,
      [](std::string_view, const FindingValue& value, std::string_view format) {
        return inEnglish(value, format);
      },
      [spelled](const Finding& cause) { return sentence(cause, spelled); }, spelled);
}

std::string sentence(const std::vector<Finding>& findings) {
  return listed(findings, "; ", [](const Finding& f) { return sentence(f); });
}

std::vector<std::string> sentences(const std::vector<Finding>& findings) {
  return sentences(findings, &dashed);
}

std::vector<std::string> sentences(const std::vector<Finding>& findings, OptionSpelling spelled) {
  std::vector<std::string> all;
  for (const Finding& f : findings) all.push_back(sentence(f, spelled));
  return all;
}

}  // namespace handlebody
