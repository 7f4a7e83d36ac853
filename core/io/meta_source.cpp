// MetaImage: geometry through ITK, plain voxel data (in the file or in one beside it) through our own stream,
// which sees truncation; lists and patterns of data files through ITK.

#include <itkMetaImageIO.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/io/byte_stream.h"
#include "core/io/itk_source.h"

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
    if (isLaterFrame(key))
      refuseInput(
          path, "this is a sequence of tracked 2D frames, not a volume; reconstruct a volume from it first");
    text.fields[key] = trimmed(line.substr(equal + 1));
    if (key == "ElementDataFile") break;
  }
  if (text.value("ElementDataFile").empty())
    refuseInput(path, "its MetaImage header is truncated (no ElementDataFile)");
  text.end = static_cast<std::uint64_t>(file.tellg());
  return text;
}

class MetaSource : public VolumeSource {
 public:
  explicit MetaSource(const std::string& path);
  void readFrame(int frame, void* to, const ReadControl& control) override;

 private:
  void locateData(const MetaText& text);
  std::string path_, dataFile_;
  std::uint64_t offset_ = 0;
  bool compressed_ = false, swapped_ = false;
};

MetaSource::MetaSource(const std::string& path) : path_(path) {
  const MetaText text = readText(path);
  if (text.value("ElementType") == "MET_NONE" || text.value("ElementType") == "MET_OTHER")
    refuseInput(path, "its voxel type is not supported");
  auto io = itk::MetaImageIO::New();
  header_ = readItkHeader(*io, path, "MetaImage");
  checkHeader(header_, path);
  locateData(text);
  const std::string unit = text.value("DistanceUnits");
  if (!unit.empty() && unit != "mm" && unit != "?")
    header_.warnings.push_back("The distance unit " + unit + " is taken as millimetres.");
}

void MetaSource::locateData(const MetaText& text) {
  const std::string file = text.value("ElementDataFile");
  if (file.rfind("LIST", 0) == 0 || file.find('%') != std::string::npos)
    refuseInput(path_, "its voxels are spread over many data files, which is not supported");
  if (!text.value("BinaryData").empty() && !text.isTrue("BinaryData"))
    refuseInput(path_, "its voxels are written as text, which is not supported");
  const bool local = file == "LOCAL" || file == "Local" || file == "local";
  dataFile_ = local ? path_ : (fs::path(path_).parent_path() / file).string();
  if (!fs::is_regular_file(dataFile_)) refuseInput(path_, "its data file " + dataFile_ + " is missing");
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

void MetaSource::readFrame(int frame, void* to, const ReadControl& control) {
  const std::uint64_t bytes = header_.bytesPerFrame();
  const std::uint64_t before = bytes * static_cast<std::uint64_t>(frame);
  ByteStream stream(dataFile_, compressed_ ? offset_ : offset_ + before,
                    compressed_ ? ByteStream::Coding::deflate : ByteStream::Coding::raw);
  if (compressed_) stream.skip(before, control);
  stream.readAll(to, static_cast<std::size_t>(bytes), control);
  stream.checkEnd();
  if (swapped_)
    swapBytes(to, header_.grid.voxelCount() * static_cast<std::size_t>(header_.components),
              bytesOf(header_.component));
}

}  // namespace

SourcePointer openMetaImage(const std::string& path) { return std::make_unique<MetaSource>(path); }

}  // namespace handlebody
