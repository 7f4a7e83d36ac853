// MetaImage, with its voxels in the file or in one beside it.

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string_view>

#include "core/io/formats/header_text.h"
#include "core/io/formats/meta_text.h"
#include "core/io/formats/stored_voxels.h"
#include "core/io/trimmed.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

struct MetaText {
  std::map<std::string, std::string> fields;
  std::uint64_t end = 0;  // where local data begin

  std::string value(const std::string& key) const {
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
  }
  //! The first of these fields that is there.
  std::string nameOf(std::initializer_list<const char*> keys) const {
    for (const char* key : keys)
      if (!value(key).empty()) return key;
    return {};
  }
  bool isTrue(const std::string& key) const {
    const std::string v = value(key);
    return !v.empty() && (v[0] == 'T' || v[0] == 't' || v[0] == '1');
  }
};

MetaText readText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  MetaText text;
  std::string line;
  while (std::getline(file, line) && line.size() < 100000) {
    const auto equal = line.find('=');
    if (equal == std::string::npos) continue;
    const std::string key(trimmed(std::string_view(line).substr(0, equal)));
    if (isLaterFrame(key)) refuseInput(path, FindingKind::trackedFrames);
    text.fields[key] = trimmed(std::string_view(line).substr(equal + 1));
    if (key == "ElementDataFile") break;
  }
  if (text.value("ElementDataFile").empty())
    refuseInput(path, {FindingKind::headerTruncatedAt,
                       {{"format", std::string("MetaImage")}, {"field", std::string("ElementDataFile")}}});
  text.end = static_cast<std::uint64_t>(file.tellg());
  return text;
}

[[noreturn]] void refuseField(const std::string& path, const std::string& field) {
  refuseHeader(path, "MetaImage", field);
}

std::vector<double> numbers(const std::string& text, const std::string& path) {
  std::vector<double> values;
  for (const std::string& word : words(text)) {
    const std::optional<double> value = parsed<double>(word);
    if (!value) refuseField(path, word.substr(0, 40) + " is not a number");
    values.push_back(*value);
  }
  return values;
}

Component componentOfMeta(const std::string& type, const std::string& path) {
  static const std::map<std::string, Component> kTypes{
      {"MET_CHAR", Component::int8},       {"MET_UCHAR", Component::uint8},
      {"MET_SHORT", Component::int16},     {"MET_USHORT", Component::uint16},
      {"MET_INT", Component::int32},       {"MET_UINT", Component::uint32},
      {"MET_LONG", Component::int32},      {"MET_ULONG", Component::uint32},
      {"MET_LONG_LONG", Component::int64}, {"MET_ULONG_LONG", Component::uint64},
      {"MET_FLOAT", Component::float32},   {"MET_DOUBLE", Component::float64}};
  // An array of three or four is a colour, written "MET_UCHAR_ARRAY".
  const auto found = kTypes.find(type.substr(0, type.rfind("_ARRAY")));
  if (found == kTypes.end()) refuseInput(path, FindingKind::voxelTypeUnknown);
  return found->second;
}

//! Returns the number of dimensions.
std::size_t setSizes(const MetaText& text, const std::string& path, VolumeHeader& header) {
  const std::vector<double> sizes = numbers(text.value("DimSize"), path);
  const std::vector<double> dimensions = numbers(text.value("NDims"), path);
  if (dimensions.size() != 1 || dimensions[0] != static_cast<double>(sizes.size()))
    refuseField(path, "NDims and DimSize");
  if (sizes.size() < 3) refuseInput(path, FindingKind::flatImage);
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    if (!(sizes[a] >= 0 && sizes[a] <= std::numeric_limits<int>::max()) || std::floor(sizes[a]) != sizes[a])
      refuseInput(path, {FindingKind::implausibleSize, {{"size", text.value("DimSize")}}});
    if (a > 3 && sizes[a] > 1)
      refuseInput(path, {FindingKind::tooManyDimensions, {{"dimensions", sizes.size()}}});
    if (a < 3) header.grid.size[a] = static_cast<int>(sizes[a]);
  }
  if (sizes.size() > 3) header.frames = static_cast<int>(sizes[3]);
  return sizes.size();
}

void setComponents(const MetaText& text, const std::string& path, VolumeHeader& header) {
  const std::vector<double> channels = numbers(text.value("ElementNumberOfChannels"), path);
  if (channels.empty() || channels[0] == 1) return;
  // MetaImage has no word for colour: three or four bytes per voxel are colour by convention.
  if (header.component != Component::uint8 || (channels[0] != 3 && channels[0] != 4))
    refuseInput(path, {FindingKind::vectorVoxels, {{"components", text.value("ElementNumberOfChannels")}}});
  header.components = static_cast<int>(channels[0]);
  header.warnings.push_back(FindingKind::colourAsLuminance);
}

void setGeometry(const MetaText& text, std::size_t dimensions, const std::string& path,
                 VolumeHeader& header) {
  const std::string spacing = text.nameOf({"ElementSpacing", "ElementSize"}),
                    origin = text.nameOf({"Offset", "Position", "Origin"}),
                    direction = text.nameOf({"TransformMatrix", "Rotation", "Orientation"});
  const auto read = [&](const std::string& key, std::size_t least) {
    std::vector<double> values = key.empty() ? std::vector<double>() : numbers(text.value(key), path);
    if (!key.empty() && values.size() < least) refuseField(path, key);
    return values;
  };
  const auto distances = read(spacing, dimensions), place = read(origin, dimensions),
             matrix = read(direction, dimensions * dimensions);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    if (!distances.empty()) header.grid.spacing[i] = distances[a];
    if (!place.empty()) header.grid.origin[i] = place[a];
    // The matrix is written axis by axis.
    for (std::size_t r = 0; r < 3 && !matrix.empty(); ++r)
      header.grid.direction(static_cast<Eigen::Index>(r), i) = matrix[a * dimensions + r];
  }
  const auto source = [](const std::string& key) { return key.empty() ? std::string("assumed") : key; };
  header.calibrated = !spacing.empty();
  header.sources = {
      "DimSize", {source(spacing), source(spacing), source(spacing)}, source(origin), source(direction)};
}

bool isLocalData(const std::string& file) { return file == "LOCAL" || file == "Local" || file == "local"; }
bool areSeveralFiles(const std::string& file) {
  return file.rfind("LIST", 0) == 0 || file.find('%') != std::string::npos;
}

StoredVoxels voxelsOf(const MetaText& text, const std::string& path, const VolumeHeader& header) {
  const std::string file = text.value("ElementDataFile");
  if (areSeveralFiles(file)) refuseInput(path, FindingKind::manyDataFiles);
  if (!text.value("BinaryData").empty() && !text.isTrue("BinaryData"))
    refuseInput(path, FindingKind::voxelsAsText);
  const bool isLocal = isLocalData(file);
  StoredVoxels voxels{isLocal ? path : (fs::path(path).parent_path() / file).string(), text.end};
  if (!fs::is_regular_file(voxels.file))
    refuseInput(path, {FindingKind::dataFileMissing, {{"data", voxels.file}}});
  voxels.isPacked = text.isTrue("CompressedData");
  const bool isBig = text.isTrue("BinaryDataByteOrderMSB") || text.isTrue("ElementByteOrderMSB");
  voxels.isSwapped = isBig != (std::endian::native == std::endian::big);
  if (isLocal) return voxels;
  const std::vector<double> given = numbers(text.value("HeaderSize"), path);
  const double skip = given.empty() ? 0 : given.front();
  if (std::floor(skip) != skip || std::abs(skip) > std::ldexp(1.0, 53)) refuseField(path, "HeaderSize");
  voxels.offset = static_cast<std::uint64_t>(std::max(0.0, skip));
  // -1: the data are the end of the file.
  const std::uint64_t bytes = header.bytesPerFrame() * static_cast<std::uint64_t>(header.frames);
  if (const std::uint64_t size = fs::file_size(voxels.file); skip == -1 && size > bytes)
    voxels.offset = size - bytes;
  return voxels;
}

}  // namespace

std::string metaDataFile(const std::string& path) {
  const std::string file = readText(path).value("ElementDataFile");
  if (file.empty() || isLocalData(file) || areSeveralFiles(file)) return {};
  return (fs::path(path).parent_path() / file).string();
}

SourcePointer openMetaImage(const std::string& path) {
  const MetaText text = readText(path);
  VolumeHeader header;
  header.format = "MetaImage";
  header.component = componentOfMeta(text.value("ElementType"), path);
  const std::size_t dimensions = setSizes(text, path, header);
  setComponents(text, path, header);
  setGeometry(text, dimensions, path, header);
  checkHeader(header, path);
  const std::string unit = text.value("DistanceUnits");
  if (!unit.empty() && unit != "mm" && unit != "?")
    header.warnings.push_back({FindingKind::unitAsMillimetres, {{"unit", unit}}});
  return storedSource(header, voxelsOf(text, path, header), path);
}

}  // namespace handlebody
