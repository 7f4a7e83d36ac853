// 3MF is three texts in a ZIP archive. lib3mf's interface of Debian 12 (1.8) is another one than that of
// Debian 13 (2.x), so they are written here, with zlib.

#include "core/io/meshes/three_mf.h"

#include <zlib.h>

#include <array>
#include <charconv>
#include <cstdio>

#include "core/io/atomic_file.h"
#include "core/io/lowered.h"

namespace handlebody {

namespace {

constexpr const char* kTypes =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
    "</Types>\n";
constexpr const char* kRelations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

void appendNumber(std::string& text, float value) {
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

std::string hexColour(const Colour& c) {
  std::array<char, 10> text{};
  std::snprintf(text.data(), text.size(), "#%02X%02X%02XFF", c[0], c[1], c[2]);
  return text.data();
}

void appendMesh(std::string& xml, const TriangleSoup& mesh, CoordinateSpace space) {
  const double turn = space == CoordinateSpace::ras ? -1 : 1;
  xml += "<mesh><vertices>\n";
  for (const Vec3& p : mesh.points) {
    xml += "<vertex x=\"";
    appendNumber(xml, static_cast<float>(turn * p.x()));
    xml += "\" y=\"";
    appendNumber(xml, static_cast<float>(turn * p.y()));
    xml += "\" z=\"";
    appendNumber(xml, static_cast<float>(p.z()));
    xml += "\"/>\n";
  }
  xml += "</vertices><triangles>\n";
  for (const Triangle& t : mesh.triangles)
    xml += "<triangle v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) + "\" v3=\"" +
           std::to_string(t[2]) + "\"/>\n";
  xml += "</triangles></mesh>";
}

std::string modelXml(const std::vector<ExportedObject>& objects, CoordinateSpace space) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Application\">Handlebody " HANDLEBODY_VERSION
      "</metadata>\n<resources><basematerials id=\"1\">";
  for (const ExportedObject& o : objects)
    xml +=
        "<base name=\"" + escaped(o.label.name) + "\" displaycolor=\"" + hexColour(o.label.colour) + "\"/>";
  xml += "</basematerials>\n";
  std::string items;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string id = std::to_string(i + 2);
    xml += "<object id=\"" + id + "\" type=\"model\" name=\"" + escaped(objects[i].label.name) +
           "\" pid=\"1\" pindex=\"" + std::to_string(i) + "\">";
    appendMesh(xml, objects[i].mesh, space);
    xml += "</object>\n";
    items += "<item objectid=\"" + id + "\"/>";
  }
  return xml + "</resources><build>" + items + "</build></model>\n";
}

//! A ZIP archive in memory (PKWARE's APPNOTE 6.3): deflated entries, all of them of 1 January 1980.
class Zip {
 public:
  void add(const std::string& name, const std::string& content) {
    const std::string packed = deflated(content);
    const auto crc =
        crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
    std::string common;  // of the local and the central header
    put(common, 20, 2);  // version needed
    put(common, 0, 2);   // flags
    put(common, 8, 2);   // deflate
    put(common, 0x00210000, 4);
    put(common, static_cast<std::uint32_t>(crc), 4);
    put(common, static_cast<std::uint32_t>(packed.size()), 4);
    put(common, static_cast<std::uint32_t>(content.size()), 4);
    put(common, static_cast<std::uint32_t>(name.size()), 2);
    put(common, 0, 2);  // extra field
    const auto offset = static_cast<std::uint32_t>(bytes_.size());
    bytes_ += "PK\x03\x04" + common + name + packed;
    directory_ += std::string("PK\x01\x02") + '\x14' + '\0' + common;
    put(directory_, 0, 2);  // comment
    put(directory_, 0, 2);  // disk
    put(directory_, 0, 2);  // internal attributes
    put(directory_, 0, 4);  // external attributes
    put(directory_, offset, 4);
    directory_ += name;
    ++entries_;
  }

  std::string finished() {
    const auto offset = static_cast<std::uint32_t>(bytes_.size());
    bytes_ += directory_ + "PK\x05\x06";
    put(bytes_, 0, 4);  // disks
    put(bytes_, entries_, 2);
    put(bytes_, entries_, 2);
    put(bytes_, static_cast<std::uint32_t>(directory_.size()), 4);
    put(bytes_, offset, 4);
    put(bytes_, 0, 2);  // comment
    return std::move(bytes_);
  }

 private:
  static void put(std::string& to, std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) to += static_cast<char>(value >> (8 * i) & 255);
  }
  static std::string deflated(const std::string& content) {
    z_stream stream{};
    constexpr int kRawDeflate = -15, kMemory = 8;
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kRawDeflate, kMemory, Z_DEFAULT_STRATEGY) !=
        Z_OK)
      throw std::bad_alloc();
    std::string packed(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
  }
  std::string bytes_, directory_;
  std::uint32_t entries_ = 0;
};

}  // namespace

bool isThreeMfPath(const std::string& path) { return lowered(path).ends_with(".3mf"); }

void writeThreeMf(const std::vector<ExportedObject>& objects, const std::string& path,
                  CoordinateSpace space) {
  const std::string model = modelXml(objects, space);
  constexpr std::size_t kLongest = 0xf0000000;  // of an entry without ZIP's 64-bit extension
  if (model.size() > kLongest) refuseOutput(path, FindingKind::packageTooLarge);
  Zip zip;
  zip.add("[Content_Types].xml", kTypes);
  zip.add("_rels/.rels", kRelations);
  zip.add("3D/3dmodel.model", model);
  writeTextAtomically(path, zip.finished());
}

}  // namespace handlebody
