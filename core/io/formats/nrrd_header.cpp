#include "core/io/formats/nrrd_header.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include "core/io/formats/header_text.h"
#include "core/io/lowered.h"
#include "core/io/trimmed.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

//! "(1,0,0) none (0,1,0)": one list of numbers per axis, empty for none.
std::vector<std::vector<double>> vectors(const std::string& text, const std::string& path) {
  std::vector<std::vector<double>> list;
  for (std::size_t at = text.find_first_not_of(" \t"); at < text.size();
       at = text.find_first_not_of(" \t", at)) {
    std::vector<double> numbers;
    if (text.compare(at, 4, "none") == 0) {
      at += 4;
    } else {
      const auto close = text.find(')', at);
      if (text[at] != '(' || close == std::string::npos) refuseHeader(path, "NRRD", "space");
      std::string inside = text.substr(at + 1, close - at - 1);
      std::replace(inside.begin(), inside.end(), ',', ' ');
      for (const std::string& word : words(inside)) {
        const auto value = parsed<double>(word);
        if (!value) refuseHeader(path, "NRRD", "space");
        numbers.push_back(*value);
      }
      at = close + 1;
    }
    list.push_back(numbers);
    if (at >= text.size()) break;
  }
  return list;
}

//! "slice.%03d 1 93 1": the paths.
std::vector<std::string> numbered(const std::vector<std::string>& parts, const fs::path& folder,
                                  const std::string& path) {
  const std::string& pattern = parts[0];
  const auto percent = pattern.find('%');
  const auto letter = percent == std::string::npos ? percent : pattern.find('d', percent);
  const auto first = parsed<int>(parts[1]), last = parsed<int>(parts[2]), step = parsed<int>(parts[3]);
  const bool plain = letter != std::string::npos && pattern.find('%', percent + 1) == std::string::npos;
  const std::string width = plain ? pattern.substr(percent + 1, letter - percent - 1) : "";
  const auto digits = width.empty() ? std::optional(0) : parsed<int>(width);
  constexpr int kMaxFiles = 100000;
  if (!plain || !first || !last || !step || *step == 0 || !digits || *digits < 0 || *digits > 20 ||
      parts.size() > 4 || std::abs(static_cast<double>(*last) - *first) / std::abs(*step) > kMaxFiles)
    refuseInput(path, {FindingKind::listNotSupported, {{"pattern", pattern}}});
  std::vector<std::string> files;
  for (long long i = *first; *step > 0 ? i <= *last : i >= *last; i += *step) {
    std::string number = std::to_string(i);
    while (static_cast<int>(number.size()) < *digits)
      number.insert(number.begin(), width[0] == '0' ? '0' : ' ');
    files.push_back((folder / (pattern.substr(0, percent) + number + pattern.substr(letter + 1))).string());
  }
  return files;
}

Component componentOfNrrd(const std::string& type, const std::string& path) {
  using Names = std::vector<std::string>;
  static const std::pair<Component, Names> kTypes[] = {
      {Component::int8, {"signed char", "int8", "int8_t"}},
      {Component::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {Component::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {Component::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {Component::int32, {"int", "signed int", "int32", "int32_t"}},
      {Component::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {Component::int64,
       {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64",
        "int64_t"}},
      {Component::uint64,
       {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {Component::float32, {"float"}},
      {Component::float64, {"double"}}};
  for (const auto& [component, names] : kTypes)
    if (std::find(names.begin(), names.end(), lowered(type)) != names.end()) return component;
  refuseInput(path, {FindingKind::voxelType, {{"type", type}}});
}

//! One axis of the array, fastest first.
struct Axis {
  std::int64_t size = 0;
  std::string kind;                 // lower-case; empty if not given
  std::vector<double> direction{};  // in space
  double spacing = std::numeric_limits<double>::quiet_NaN();
  bool spatial = true;
};

std::vector<Axis> axesOf(const NrrdFields& f, const std::string& path) {
  std::vector<Axis> axes;
  for (const std::string& word : words(f.value("sizes"))) {
    const auto size = parsed<std::int64_t>(word);
    if (!size || *size < 1 || *size > std::numeric_limits<int>::max())
      refuseInput(path, {FindingKind::implausibleSize, {{"size", word}}});
    axes.push_back({*size, {}});
  }
  if (axes.empty() || std::to_string(axes.size()) != f.value("dimension"))
    refuseHeader(path, "NRRD", "dimension and sizes");
  const auto kinds = words(lowered(f.value("kinds"))), spacings = words(lowered(f.value("spacings")));
  const auto directions = vectors(f.value("space directions"), path);
  for (const std::size_t n : {kinds.size(), spacings.size(), directions.size()})
    if (n != 0 && n != axes.size()) refuseHeader(path, "NRRD", "a field has not one value per axis");
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Axis& a = axes[i];
    if (!kinds.empty()) a.kind = kinds[i];
    if (!directions.empty()) a.direction = directions[i];
    if (!spacings.empty()) a.spacing = parsed<double>(spacings[i]).value_or(a.spacing);
    const bool named =
        !a.kind.empty() && a.kind != "domain" && a.kind != "space" && a.kind != "???" && a.kind != "none";
    a.spatial = directions.empty() ? !named : !a.direction.empty();
  }
  return axes;
}

//! Colour, time points, or vectors, which are refused.
void useOtherAxis(const std::vector<Axis>& axes, std::size_t i, const std::string& path, VolumeHeader& header,
                  NrrdLayout& layout) {
  const Axis& axis = axes[i];
  const bool colour = axis.kind.find("color") != std::string::npos;
  const bool time = axis.kind.empty() || axis.kind == "list" || axis.kind == "time" ||
                    axis.kind == "domain" || axis.kind == "space" || axis.kind == "none" ||
                    axis.kind == "???";
  if (colour && i == 0 && (axis.size == 3 || axis.size == 4) &&
      (header.component == Component::uint8 || header.component == Component::uint16)) {
    header.components = static_cast<int>(axis.size);
    header.warnings.push_back(FindingKind::colourAsLuminance);
  } else if (time || axis.size == 1) {
    header.frames = static_cast<int>(axis.size);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      if (k == i) continue;
      std::uint64_t& count = k < i ? layout.inner : layout.outer;
      // Sizes of a hostile header may exceed 64 bits; more than this is refused afterwards.
      count = std::min(count, std::uint64_t{1} << 32) * static_cast<std::uint64_t>(axes[k].size);
    }
  } else {
    refuseInput(path, {FindingKind::vectorVoxels, {{"components", std::to_string(axis.size)}}});
  }
}

//! Milliseconds in a unit of the header, quoted or not; 0 for one that is no unit of time.
double millisecondsIn(const std::string& unit) {
  const auto is = [&](const char* name) { return unit == name || unit == '"' + std::string(name) + '"'; };
  return is("s") ? 1000 : is("ms") ? 1 : is("us") ? 1e-3 : 0;
}

//! Times of the axis that is not in space: 3D Slicer's list of values, or an even spacing; only where the
//! header gives a unit of time for it.
void setTimes(const NrrdFields& f, const Axis& axis, std::size_t index, VolumeHeader& header) {
  if (header.frames < 2) return;
  const std::vector<std::string> units = words(f.value("units"));
  const double ms = index < units.size() ? millisecondsIn(units[index]) : 0;
  const auto values = f.keys.find("axis " + std::to_string(index) + " index values");
  if (values == f.keys.end()) {
    header.times = evenTimes(header.frames, axis.spacing * ms, "spacings, units");
    return;
  }
  std::vector<double> times;
  for (const std::string& word : words(values->second))
    times.push_back(ms * parsed<double>(word).value_or(std::numeric_limits<double>::quiet_NaN()));
  header.times = checkedTimes(header.frames, std::move(times), values->first + ", units");
}

//! What makes a direction of the header's space LPS; nothing for a space that is not the patient's.
std::optional<Vec3> toLps(const std::string& space) {
  const std::string s = lowered(space);
  const auto is = [&](const char* name, const char* letters) {
    return s.rfind(name, 0) == 0 || s == letters || s == std::string(letters) + "t";
  };
  if (is("left-posterior-superior", "lps")) return Vec3(1, 1, 1);
  if (is("right-anterior-superior", "ras")) return Vec3(-1, -1, 1);
  if (is("left-anterior-superior", "las")) return Vec3(1, -1, 1);
  return std::nullopt;
}

void setDirection(const Axis& axis, int a, const Vec3& flip, const std::string& path, VolumeHeader& h) {
  if (axis.direction.size() < 3) refuseHeader(path, "NRRD", "space directions");
  const Vec3 v = Vec3(axis.direction[0], axis.direction[1], axis.direction[2]).cwiseProduct(flip);
  h.grid.spacing[a] = v.norm();
  if (v.norm() > 0) h.grid.direction.col(a) = v / v.norm();
  h.sources.spacing[a] = "space directions";
}

//! What is given and not understood is refused: in its place would be 0, without a word.
void setOrigin(const NrrdFields& f, const Vec3& flip, const std::string& path, VolumeHeader& h) {
  h.sources.origin = "assumed";
  const std::string text = f.value("space origin");
  if (!f.has("space origin") || lowered(text) == "none") return;
  const auto origin = vectors(text, path);
  // Four numbers: of a space with time.
  if (origin.size() != 1 || origin[0].size() < 3 || origin[0].size() > 4)
    refuseHeader(path, "NRRD", "space origin");
  const Vec3 place(origin[0][0], origin[0][1], origin[0][2]);
  if (!place.allFinite()) refuseHeader(path, "NRRD", "space origin");
  h.grid.origin = place.cwiseProduct(flip);
  h.sources.origin = "space origin";
}

void setGeometry(const NrrdFields& f, const std::vector<Axis>& spatial, const std::string& path,
                 VolumeHeader& h) {
  const std::optional<Vec3> lps = toLps(f.value("space"));
  const Vec3 flip = lps.value_or(Vec3(1, 1, 1));
  bool directed = false;
  h.sources.size = "sizes";
  for (int a = 0; a < 3; ++a) {
    const Axis& axis = spatial[a];
    const auto i = static_cast<std::size_t>(a);
    h.grid.size[i] = static_cast<int>(axis.size);
    directed |= !axis.direction.empty();
    if (!axis.direction.empty()) {
      setDirection(axis, a, flip, path, h);
    } else if (std::isfinite(axis.spacing)) {
      h.grid.spacing[a] = axis.spacing;
      h.sources.spacing[i] = "spacings";
    } else {
      h.calibrated = false;
      h.sources.spacing[i] = "assumed";
    }
  }
  h.sources.direction = directed ? "space directions" : "assumed";
  setOrigin(f, flip, path, h);
  if (!lps || !directed)
    h.warnings.push_back(FindingKind::axesTakenAsLps);
  else if (h.sources.origin == "assumed")
    h.warnings.push_back(FindingKind::originAssumed);
}

void checkUnits(const std::string& units, VolumeHeader& header) {
  for (const std::string& word : words(units))
    if (word != "\"mm\"" && word != "\"\"" && word != "???" && word != "\"s\"" && word != "none") {
      header.warnings.push_back({FindingKind::unitsAsMillimetres, {{"units", units}}});
      return;
    }
}

void setEncoding(const NrrdFields& f, const std::string& path, const VolumeHeader& header,
                 NrrdLayout& layout) {
  const std::string encoding = lowered(f.value("encoding"));
  layout.compressed = encoding == "gzip" || encoding == "gz";
  layout.text = encoding == "ascii" || encoding == "text" || encoding == "txt";
  if (!layout.compressed && !layout.text && encoding != "raw")
    refuseInput(path, {FindingKind::encodingNotSupported, {{"encoding", encoding}}});
  const std::string endian = lowered(f.value("endian"));
  if (endian.empty() && bytesOf(header.component) > 1 && !layout.text)
    refuseHeader(path, "NRRD", "no endian");
  if (bytesOf(header.component) > 1)
    layout.swapped = (endian == "big") != (std::endian::native == std::endian::big);
  for (const auto& [name, skip] :
       {std::pair("byte skip", &layout.byteSkip), std::pair("line skip", &layout.lineSkip)})
    if (const std::string text = f.value(name); !text.empty()) {
      const auto value = parsed<long long>(text);
      if (!value || *value < -1 || *value > (1ll << 60)) refuseHeader(path, "NRRD", name);
      *skip = *value;
    }
}

}  // namespace

std::string nrrdName(std::string_view name) {
  std::string plain = lowered(std::string(name));
  std::erase_if(plain, [](char c) { return c == ' ' || c == '\t'; });
  return plain;
}

NrrdFields readNrrdFields(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  NrrdFields f;
  std::string line, list;
  bool listed = false;
  std::getline(file, line);  // the magic
  constexpr std::size_t kLongestHeader = 16u << 20;
  while (std::getline(file, line) && static_cast<std::size_t>(file.tellg()) < kLongestHeader) {
    line = std::string(trimmed(line));
    if (line.empty()) break;
    f.sequence |= isLaterFrame(line);
    if (listed) f.dataFiles.push_back((fs::path(path).parent_path() / line).string());
    if (listed || line[0] == '#') continue;
    const auto colon = line.find(':'), pair = line.find(":=");
    if (pair < line.find(": ")) {  // a key may hold a colon, a field's name cannot
      f.keys[line.substr(0, pair)] = line.substr(pair + 2);
      continue;
    }
    if (colon == std::string::npos) continue;
    const std::string_view whole = line;
    f.fields[nrrdName(whole.substr(0, colon))] = trimmed(whole.substr(colon + 1));
    listed = f.value("data file") == "LIST";
  }
  if (file) f.end = static_cast<std::uint64_t>(file.tellg());
  const std::string data = f.value("data file");
  if (data.empty() || listed) return f;
  const std::vector<std::string> parts = words(data);
  if (parts.size() >= 4 && data.find('%') != std::string::npos)
    f.dataFiles = numbered(parts, fs::path(path).parent_path(), path);
  else
    f.dataFiles = {(fs::path(path).parent_path() / data).string()};
  return f;
}

NrrdLayout interpretNrrd(const NrrdFields& f, const std::string& path, VolumeHeader& header) {
  header.format = "NRRD";
  header.component = componentOfNrrd(f.value("type"), path);
  std::vector<Axis> axes = axesOf(f, path);
  std::vector<Axis> spatial;
  std::size_t others = 0, other = 0;
  // Four axes in space without a word for time: the last is time.
  if (std::all_of(axes.begin(), axes.end(), [](const Axis& a) { return a.spatial; }) && axes.size() == 4)
    axes[3].spatial = false;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].spatial) spatial.push_back(axes[i]);
    if (!axes[i].spatial && (axes[i].size > 1 || others == 0)) other = i;
    others += !axes[i].spatial && axes[i].size > 1;
  }
  if (spatial.size() > 3 || others > 1) refuseInput(path, FindingKind::fourDimensions);
  if (spatial.size() < 3) refuseInput(path, FindingKind::flatImage);
  const bool unsaid =
      f.value("space directions").empty() && f.value("spacings").empty() && f.value("kinds").empty();
  if (unsaid && axes.size() == 3 && (axes[0].size == 3 || axes[0].size == 4) &&
      header.component == Component::uint8)
    refuseInput(path, {FindingKind::flatColour, {{"values", axes[0].size}}});
  NrrdLayout layout;
  if (axes.size() > 3) {
    useOtherAxis(axes, other, path, header, layout);
    setTimes(f, axes[other], other, header);
  }
  if (header.frames == 1 || axes.size() == 3) layout.inner = layout.outer = 1;
  setGeometry(f, spatial, path, header);
  checkUnits(f.value("space units"), header);
  setEncoding(f, path, header, layout);
  return layout;
}

}  // namespace handlebody
