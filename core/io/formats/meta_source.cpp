// MetaImage, with its voxels in the file or in one beside it, through our own stream, which sees truncation.

#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "core/io/formats/byte_stream.h"

namespace handlebody {
namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& s) {
  const auto first = s.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return s.substr(first, s.find_last_not_of(" \t\r\n") - first + 1);
}

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
    const std::string key = trimmed(line.substr(0, equal));
    if (isLaterFrame(key)) refuseInput(path, FindingKind::trackedFrames);
    text.fields[key] = trimmed(line.substr(equal + 1));
    if (key == "ElementDataFile") break;
  }
  if (text.value("ElementDataFile").empty())
    refuseInput(path, {FindingKind::headerTruncatedAt,
                       {{"format", std::string("MetaImage")}, {"field", std::string("ElementDataFile")}}});
  text.end = static_cast<std::uint64_t>(file.tellg());
  return text;
}

std::vector<double> numbers(const std::string& text, const std::string& path) {
  std::istringstream stream(text);
  std::vector<double> values;
  for (std::string word; stream >> word;) {
    double value = 0;
    const char* first = word.data() + (word.size() > 1 && word[0] == '+');
    const auto [end, error] = std::from_chars(first, word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      refuseInput(
          path, {FindingKind::headerDamaged,
                 {{"format", std::string("MetaImage")}, {"field", word.substr(0, 40) + " is not a number"}}});
    values.push_back(value);
  }
  return values;
}

Component componentOf(const std::string& type, const std::string& path) {
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

class MetaSource : public VolumeSource {
 public:
  explicit MetaSource(const std::string& path);

 protected:
  void readFrame(int frame, void* to, const ReadProgress& progress) override;

 private:
  void setSizes(const MetaText& text);
  void setGeometry(const MetaText& text);
  void setComponents(const MetaText& text);
  void locateData(const MetaText& text);
  std::string path_, dataFile_;
  std::uint64_t offset_ = 0;
  std::size_t dimensions_ = 0;
  bool compressed_ = false, swapped_ = false;
};

MetaSource::MetaSource(const std::string& path) : path_(path) {
  const MetaText text = readText(path);
  header_.format = "MetaImage";
  header_.component = componentOf(text.value("ElementType"), path);
  setSizes(text);
  setComponents(text);
  setGeometry(text);
  checkHeader(header_, path);
  locateData(text);
  const std::string unit = text.value("DistanceUnits");
  if (!unit.empty() && unit != "mm" && unit != "?")
    header_.warnings.push_back({FindingKind::unitAsMillimetres, {{"unit", unit}}});
}

void MetaSource::setSizes(const MetaText& text) {
  const std::vector<double> sizes = numbers(text.value("DimSize"), path_);
  const std::vector<double> dimensions = numbers(text.value("NDims"), path_);
  dimensions_ = sizes.size();
  if (dimensions.size() != 1 || dimensions[0] != static_cast<double>(dimensions_))
    refuseInput(path_, {FindingKind::headerDamaged,
                        {{"format", std::string("MetaImage")}, {"field", std::string("NDims and DimSize")}}});
  if (dimensions_ < 3) refuseInput(path_, FindingKind::flatImage);
  for (std::size_t a = 0; a < dimensions_; ++a) {
    if (!(sizes[a] >= 0 && sizes[a] <= std::numeric_limits<int>::max()) || std::floor(sizes[a]) != sizes[a])
      refuseInput(path_, {FindingKind::implausibleSize, {{"size", text.value("DimSize")}}});
    if (a > 3 && sizes[a] > 1)
      refuseInput(path_, {FindingKind::tooManyDimensions, {{"dimensions", dimensions_}}});
    if (a < 3) header_.grid.size[a] = static_cast<int>(sizes[a]);
  }
  if (dimensions_ > 3) header_.frames = static_cast<int>(sizes[3]);
}

void MetaSource::setComponents(const MetaText& text) {
  const std::vector<double> channels = numbers(text.value("ElementNumberOfChannels"), path_);
  if (channels.empty() || channels[0] == 1) return;
  // MetaImage has no word for colour: three or four bytes per voxel are colour by convention.
  if (header_.component != Component::uint8 || (channels[0] != 3 && channels[0] != 4))
    refuseInput(path_, {FindingKind::vectorVoxels, {{"components", text.value("ElementNumberOfChannels")}}});
  header_.components = static_cast<int>(channels[0]);
  header_.warnings.push_back(FindingKind::colourAsLuminance);
}

void MetaSource::setGeometry(const MetaText& text) {
  const std::string spacing = text.nameOf({"ElementSpacing", "ElementSize"}),
                    origin = text.nameOf({"Offset", "Position", "Origin"}),
                    direction = text.nameOf({"TransformMatrix", "Rotation", "Orientation"});
  const auto read = [&](const std::string& key, std::size_t least) {
    std::vector<double> values = key.empty() ? std::vector<double>() : numbers(text.value(key), path_);
    if (!key.empty() && values.size() < least)
      refuseInput(path_,
                  {FindingKind::headerDamaged, {{"format", std::string("MetaImage")}, {"field", key}}});
    return values;
  };
  const auto distances = read(spacing, dimensions_), place = read(origin, dimensions_),
             matrix = read(direction, dimensions_ * dimensions_);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    if (!distances.empty()) header_.grid.spacing[i] = distances[a];
    if (!place.empty()) header_.grid.origin[i] = place[a];
    // The matrix is written axis by axis.
    for (std::size_t r = 0; r < 3 && !matrix.empty(); ++r)
      header_.grid.direction(static_cast<Eigen::Index>(r), i) = matrix[a * dimensions_ + r];
  }
  const auto source = [](const std::string& key) { return key.empty() ? std::string("assumed") : key; };
  header_.calibrated = !spacing.empty();
  header_.sources = {
      "DimSize", {source(spacing), source(spacing), source(spacing)}, source(origin), source(direction)};
}

void MetaSource::locateData(const MetaText& text) {
  const std::string file = text.value("ElementDataFile");
  if (file.rfind("LIST", 0) == 0 || file.find('%') != std::string::npos)
    refuseInput(path_, FindingKind::manyDataFiles);
  if (!text.value("BinaryData").empty() && !text.isTrue("BinaryData"))
    refuseInput(path_, FindingKind::voxelsAsText);
  const bool local = file == "LOCAL" || file == "Local" || file == "local";
  dataFile_ = local ? path_ : (fs::path(path_).parent_path() / file).string();
  if (!fs::is_regular_file(dataFile_))
    refuseInput(path_, {FindingKind::dataFileMissing, {{"data", dataFile_}}});
  compressed_ = text.isTrue("CompressedData");
  const bool msb = text.isTrue("BinaryDataByteOrderMSB") || text.isTrue("ElementByteOrderMSB");
  swapped_ = msb != (std::endian::native == std::endian::big);
  const std::uint64_t bytes = header_.bytesPerFrame() * static_cast<std::uint64_t>(header_.frames);
  const long long skip = std::atoll(text.value("HeaderSize").c_str());
  offset_ = local ? text.end : static_cast<std::uint64_t>(std::max(0ll, skip));
  // -1: the data are the end of the file.
  if (skip == -1 && !local) {
    const std::uint64_t size = fs::file_size(dataFile_);
    offset_ = size > bytes ? size - bytes : 0;
  }
  checkDataSize(path_, dataFile_, offset_, bytes, compressed_);
}

void MetaSource::readFrame(int frame, void* to, const ReadProgress& progress) {
  const std::uint64_t bytes = header_.bytesPerFrame();
  const std::uint64_t before = bytes * static_cast<std::uint64_t>(frame);
  ByteStream stream(dataFile_, compressed_ ? offset_ : offset_ + before,
                    compressed_ ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  if (compressed_) stream.skip(before, progress);
  stream.readAll(to, static_cast<std::size_t>(bytes), progress);
  stream.checkEnd(frame + 1 < header_.frames);
  if (swapped_)
    swapBytes(to, header_.grid.voxelCount() * static_cast<std::size_t>(header_.components),
              bytesOf(header_.component));
}

}  // namespace

SourcePointer openMetaImage(const std::string& path) { return std::make_unique<MetaSource>(path); }

}  // namespace handlebody
