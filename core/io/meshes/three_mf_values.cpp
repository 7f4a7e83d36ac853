#include "core/io/meshes/three_mf_values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "core/io/trimmed.h"

namespace handlebody::three_mf {
namespace {

std::string_view plain(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

template <typename T>
std::errc parse(std::string_view text, T& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr != end ? std::errc::invalid_argument : result.ec;
}

}  // namespace

std::string_view nextWord(std::string_view& text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
  text.remove_prefix(word.size());
  return word;
}

std::optional<float> coordinate(const char* text) {
  if (!text) return std::nullopt;
  float value = 0;
  const std::errc failed = parse(plain(text), value);
  double fine = 0;
  // Too small for a float is a number all the same.
  if (failed == std::errc::result_out_of_range && parse(plain(text), fine) == std::errc() &&
      std::abs(fine) < 1)
    return static_cast<float>(fine);
  return failed == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<int> index(const char* text) {
  int value = 0;
  if (!text || parse(plain(text), value) != std::errc() || value < 0) return std::nullopt;
  return value;
}

std::optional<Eigen::Affine3d> transform(std::string_view text, double unit) {
  std::array<double, 12> numbers{};
  for (double& n : numbers)
    if (parse(plain(nextWord(text)), n) != std::errc() || !std::isfinite(n)) return std::nullopt;
  if (!trimmed(text).empty()) return std::nullopt;
  Eigen::Affine3d all = Eigen::Affine3d::Identity();
  // The rows of theirs are the columns of ours, and these lie one behind the other.
  all.linear() = Eigen::Map<const Eigen::Matrix3d>(numbers.data());
  all.translation() = unit * Eigen::Map<const Eigen::Vector3d>(numbers.data() + 9);
  return all;
}

std::optional<double> unitCalled(const std::string& name) {
  static const std::map<std::string, double> kUnits{{"micron", 1e-3}, {"millimeter", 1}, {"centimeter", 10},
                                                    {"inch", 25.4},   {"foot", 304.8},   {"meter", 1e3}};
  const auto found = kUnits.find(name);
  return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace handlebody::three_mf
