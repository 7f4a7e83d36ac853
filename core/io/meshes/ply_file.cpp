// PLY by hand: VTK's reader frees foreign memory on damaged files and does not notice an early end.

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

#include "core/io/meshes/mesh_files.h"
#include "core/io/refuse_input.h"

namespace handlebody {
namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  bool isList = false;
  Scalar countType = Scalar::uint8;
  Scalar type = Scalar::float32;
};

struct ElementKind {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties{};
};

class PlyReader {
 public:
  explicit PlyReader(std::string path) : path_(std::move(path)) {}

  MeshFile read() {
    std::ifstream stream(path_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
    readHeader();
    for (const ElementKind& kind : kinds_) readElements(kind);
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuse(const Finding& cause) const { refuseInput(path_, cause); }

  bool nextLine(std::string& line) {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) return false;
    line = bytes_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    at_ = end + 1;
    return true;
  }

  Scalar scalar(const std::string& name) const {
    static const std::map<std::string, Scalar> kNames{
        {"char", Scalar::int8},      {"int8", Scalar::int8},       {"uchar", Scalar::uint8},
        {"uint8", Scalar::uint8},    {"short", Scalar::int16},     {"int16", Scalar::int16},
        {"ushort", Scalar::uint16},  {"uint16", Scalar::uint16},   {"int", Scalar::int32},
        {"int32", Scalar::int32},    {"uint", Scalar::uint32},     {"uint32", Scalar::uint32},
        {"float", Scalar::float32},  {"float32", Scalar::float32}, {"double", Scalar::float64},
        {"float64", Scalar::float64}};
    const auto found = kNames.find(name);
    if (found == kNames.end())
      refuse({FindingKind::headerDamaged,
              {{"format", std::string("PLY")}, {"field", std::string("property type")}}});
    return found->second;
  }

  void readHeader() {
    std::string line;
    if (!nextLine(line) || line != "ply")
      refuse({FindingKind::notOfFormat, {{"format", std::string("PLY")}}});
    while (nextLine(line)) {
      if (line == "end_header") return;
      readHeaderLine(line);
    }
    refuse({FindingKind::headerTruncated, {{"format", std::string("PLY")}}});
  }

  void readHeaderLine(const std::string& line) {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key == "comment" && line.find("SPACE=") != std::string::npos) file_.space = spaceIn(line);
    if (key == "format") {
      words >> word;
      text_ = word == "ascii";
      if (!text_ && word != "binary_little_endian" && word != "binary_big_endian")
        refuse(
            {FindingKind::headerDamaged, {{"format", std::string("PLY")}, {"field", std::string("format")}}});
      swapped_ = !text_ && (word == "binary_big_endian") != (std::endian::native == std::endian::big);
    }
    if (key == "element") {
      ElementKind kind;
      if (!(words >> kind.name >> kind.count))
        refuse({FindingKind::headerDamaged,
                {{"format", std::string("PLY")}, {"field", std::string("element")}}});
      kinds_.push_back(kind);
    }
    if (key == "property") {
      if (kinds_.empty())
        refuse({FindingKind::headerDamaged,
                {{"format", std::string("PLY")}, {"field", std::string("property")}}});
      Property p;
      words >> word;
      p.isList = word == "list";
      if (p.isList) {
        words >> word;
        p.countType = scalar(word);
        words >> word;
      }
      p.type = scalar(word);
      words >> p.name;
      kinds_.back().properties.push_back(p);
    }
  }

  template <typename T>
  double binary() {
    if (bytes_.size() - at_ < sizeof(T))
      refuse({FindingKind::truncatedFormat, {{"format", std::string("PLY")}}});
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof raw);
    at_ += sizeof raw;
    if (swapped_) std::reverse(raw, raw + sizeof raw);
    T value;
    std::memcpy(&value, raw, sizeof value);
    return static_cast<double>(value);
  }

  double fromText() {
    const char* end = bytes_.data() + bytes_.size();
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_]))) ++at_;
    if (at_ == bytes_.size()) refuse({FindingKind::truncatedFormat, {{"format", std::string("PLY")}}});
    double value = 0;
    const auto result = std::from_chars(bytes_.data() + at_, end, value);
    if (result.ec != std::errc())
      refuse({FindingKind::damagedBecause, {{"format", std::string("PLY")}}, FindingKind::badNumber});
    at_ = static_cast<std::size_t>(result.ptr - bytes_.data());
    return value;
  }

  double number(Scalar type) {
    if (text_) return fromText();
    switch (type) {
      case Scalar::int8:
        return binary<std::int8_t>();
      case Scalar::uint8:
        return binary<std::uint8_t>();
      case Scalar::int16:
        return binary<std::int16_t>();
      case Scalar::uint16:
        return binary<std::uint16_t>();
      case Scalar::int32:
        return binary<std::int32_t>();
      case Scalar::uint32:
        return binary<std::uint32_t>();
      case Scalar::float32:
        return binary<float>();
      default:
        return binary<double>();
    }
  }

  void readElements(const ElementKind& kind) {
    // Without properties nothing is read, and a hostile count would only burn time.
    if (kind.properties.empty()) return;
    for (std::uint64_t i = 0; i < kind.count; ++i) {
      Vec3 point(0, 0, 0);
      for (const Property& p : kind.properties) {
        if (p.isList) {
          readList(p, kind.name == "face" && (p.name == "vertex_indices" || p.name == "vertex_index"));
          continue;
        }
        const double value = number(p.type);
        for (int a = 0; a < 3; ++a)
          if (p.name == std::string(1, "xyz"[a])) point[a] = value;
      }
      if (kind.name == "vertex") file_.mesh.points.push_back(point);
    }
  }

  void readList(const Property& p, bool corners) {
    const double n = number(p.countType);
    if (!(n >= 0))
      refuse({FindingKind::damagedBecause, {{"format", std::string("PLY")}}, FindingKind::badList});
    list_.clear();
    for (double i = 0; i < n; ++i) list_.push_back(number(p.type));
    if (!corners) return;
    if (list_.size() < 3) refuse(FindingKind::faceTooFewCorners);
    for (double v : list_)
      if (!(v >= 0 && v < static_cast<double>(file_.mesh.points.size())))
        refuse(FindingKind::faceVertexMissing);
    for (std::size_t i = 2; i < list_.size(); ++i)
      file_.mesh.triangles.push_back(
          {static_cast<int>(list_[0]), static_cast<int>(list_[i - 1]), static_cast<int>(list_[i])});
  }

  std::string path_, bytes_;
  std::size_t at_ = 0;
  bool text_ = false, swapped_ = false;
  std::vector<ElementKind> kinds_;
  std::vector<double> list_;
  MeshFile file_;
};

}  // namespace

MeshFile readPly(const std::string& path) { return PlyReader(path).read(); }

}  // namespace handlebody
