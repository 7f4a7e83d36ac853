#include "core/io/report/parse.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/io/report/option_error.h"
#include "core/io/trimmed.h"

namespace handlebody {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& wanted) {
  throw OptionError(option, "'" + text + "' is not " + wanted + ".");
}

// The whole text as a T; false if anything is left over or it does not fit.
template <typename T>
bool convert(std::string_view text, T& value) {
  text = trimmed(text, " ");
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

std::vector<std::string_view> splitAtCommas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (auto comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
    parts.push_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  parts.push_back(text);
  return parts;
}

bool allFinite(const std::vector<double>& values) {
  for (double v : values)
    if (!std::isfinite(v)) return false;
  return true;
}

}  // namespace

double parseNumber(const std::string& option, const std::string& text) {
  double value = 0;
  if (!convert(text, value) || std::isnan(value)) refuse(option, text, "a number");
  return value;
}

int parseInteger(const std::string& option, const std::string& text, int lowest, int highest) {
  int value = 0;
  if (!convert(text, value) || value < lowest || value > highest) {
    const bool open = highest == std::numeric_limits<int>::max();
    refuse(option, text,
           "a whole number of at least " + std::to_string(lowest) +
               (open ? "" : " and at most " + std::to_string(highest)));
  }
  return value;
}

std::string parseLabel(const std::string& option, const std::string& text, int lowest, int highest) {
  if (text.empty()) throw OptionError(option, "'' is no label.");
  double number = 0;
  if (convert(text, number) && std::isfinite(number)) parseInteger(option, text, lowest, highest);
  return text;
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text) {
  std::vector<double> values;
  for (std::string_view part : splitAtCommas(text)) values.push_back(parseNumber(option, std::string(part)));
  return values;
}

Vec3 parseVector(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(option, text);
  if (v.size() != 3 || !allFinite(v)) refuse(option, text, "three numbers X,Y,Z");
  return {v[0], v[1], v[2]};
}

std::vector<int> parseIntegers(const std::string& option, const std::string& text, int lowest) {
  std::vector<int> values;
  for (std::string_view part : splitAtCommas(text))
    values.push_back(parseInteger(option, std::string(part), lowest, std::numeric_limits<int>::max()));
  return values;
}

IntensityRange parseRange(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(option, text);
  if (v.size() != 2 || v[0] > v[1]) refuse(option, text, "a range LO,HI with LO not above HI");
  return {v[0], v[1]};
}

WallBall parseWall(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(option, text);
  if (v.size() != 4 || !allFinite(v) || !(v[3] > 0))
    refuse(option, text, "X,Y,Z,R in finite numbers with a radius above 0");
  return {{v[0], v[1], v[2]}, v[3]};
}

WallDisc parseWallDisc(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(option, text);
  if (v.size() != 7 || !allFinite(v)) refuse(option, text, "X,Y,Z,NX,NY,NZ,R in finite numbers");
  const WallDisc disc{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6]};
  if (!(disc.normal.norm() > 0)) refuse(option, text, "a disc with a normal of some length");
  if (!(disc.radius > 0)) refuse(option, text, "a disc with a radius above 0");
  return disc;
}

Pin parsePin(const std::string& option, const std::string& text) {
  const auto at = text.find('@');
  if (at == std::string::npos) refuse(option, text, "X,Y,Z,R@ITERATION");
  const auto v = parseNumbers(option, text.substr(0, at));
  if (v.size() != 4 || !allFinite(v) || !(v[3] > 0))
    refuse(option, text, "X,Y,Z,R@ITERATION in finite numbers with a radius above 0");
  const int iteration = parseInteger(option, text.substr(at + 1), 0, std::numeric_limits<int>::max());
  return {{v[0], v[1], v[2]}, v[3], iteration};
}

Veto parseVeto(const std::string& option, const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) refuse(option, text, "ITERATION:X,Y,Z");
  const int iteration = parseInteger(option, text.substr(0, colon), 1, std::numeric_limits<int>::max());
  return {iteration, parseVector(option, text.substr(colon + 1))};
}

MeshEdit parseSmoothing(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(option, text);
  if (v.size() != 4 || !allFinite(v) || !(v[3] > 0))
    refuse(option, text, "X,Y,Z,R in finite numbers with a radius above 0");
  MeshEdit edit;
  edit.kind = MeshEditKind::smooth;
  edit.place = {v[0], v[1], v[2]};
  edit.radius = v[3];
  return edit;
}

MeshEdit parsePull(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(option, text);
  if (v.size() != 7 || !allFinite(v) || !(v[6] > 0))
    refuse(option, text, "X,Y,Z,X2,Y2,Z2,R in finite numbers with a radius above 0");
  MeshEdit edit;
  edit.kind = MeshEditKind::pull;
  edit.place = {v[0], v[1], v[2]};
  edit.vector = {v[3], v[4], v[5]};
  edit.radius = v[6];
  return edit;
}

MeshEdit parsePlaneCut(const std::string& option, const std::string& text) {
  MeshEdit edit;
  edit.kind = MeshEditKind::cut;
  std::string numbers = text;
  const auto comma = text.rfind(',');
  if (comma != std::string::npos)
    if (const auto keep = keptSideOf(text.substr(comma + 1))) {
      edit.keep = *keep;
      numbers = text.substr(0, comma);
    }
  const bool isWord = numbers.find_first_of("abpn") != std::string::npos;
  const auto v = isWord ? std::vector<double>() : parseNumbers(option, numbers);
  if ((v.size() != 6 && v.size() != 7) || !allFinite(v))
    refuse(option, text, "X,Y,Z,NX,NY,NZ[,R][,both|positive|negative] in finite numbers");
  edit.place = {v[0], v[1], v[2]};
  edit.vector = {v[3], v[4], v[5]};
  if (!(edit.vector.norm() > 0)) refuse(option, text, "a plane with a normal of some length");
  if (v.size() == 7 && !(v[6] > 0)) refuse(option, text, "a cut with a radius above 0");
  if (v.size() == 7) edit.radius = v[6];
  return edit;
}

MeshEdit parseMeshEdit(const std::string& option, const std::string& text) {
  const auto first = text.find(':'), second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) refuse(option, text, "ITERATION:KIND:X,Y,Z");
  const std::string word = text.substr(first + 1, second - first - 1);
  MeshEdit edit;
  edit.iteration = parseInteger(option, text.substr(0, first), 1, std::numeric_limits<int>::max());
  const std::string rest = text.substr(second + 1);
  if (word == "smooth" || word == "pull" || word == "cut") {
    const int iteration = edit.iteration;
    edit = word == "smooth" ? parseSmoothing(option, rest)
           : word == "pull" ? parsePull(option, rest)
                            : parsePlaneCut(option, rest);
    edit.iteration = iteration;
    return edit;
  }
  edit.place = parseVector(option, rest);
  if (word == "fill-tunnel" || word == "cut-handle") {
    edit.cut = word == "cut-handle" ? TunnelCut::handle : TunnelCut::tunnel;
    return edit;
  }
  const auto kind = meshEditKind(word);
  if (!kind)
    refuse(option, text,
           "an edit of kind close-tunnel, fill-tunnel, cut-handle, remove-component, keep-component, "
           "fill-cavity, smooth, pull or cut");
  edit.kind = *kind;
  return edit;
}

Seed parseSeed(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(option, text);
  if ((v.size() != 3 && v.size() != 4) || !allFinite(v))
    refuse(option, text, "X,Y,Z or X,Y,Z,R in finite numbers");
  Seed seed{{v[0], v[1], v[2]}, {}};
  if (v.size() == 4) {
    if (!(v[3] > 0)) refuse(option, text, "a seed with a radius above 0");
    seed.radius = v[3];
  }
  return seed;
}

}  // namespace handlebody
