// 3MF is three texts in a ZIP archive. lib3mf's interface of Debian 12 (1.8) is another one than that of
// Debian 13 (2.x), so the texts are written here.

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/io/atomic_file.h"
#include "core/io/meshes/three_mf.h"
#include "core/io/meshes/three_mf_model.h"
#include "core/io/meshes/zip_archive.h"
#include "core/version.h"

namespace handlebody {

namespace {

constexpr const char* kContentTypes =
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
      "<model unit=\"millimeter\" xml:lang=\"en-US\" xmlns=\"" +
      std::string(kThreeMfCore) + "\" xmlns:hb=\"" + kThreeMfOurs +
      "\">\n<metadata name=\"Application\">Handlebody " HANDLEBODY_VERSION
      "</metadata>\n<metadata name=\"hb:Space\">" +
      (space == CoordinateSpace::ras ? "RAS" : "LPS") + "</metadata>\n<resources><basematerials id=\"1\">";
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

}  // namespace

void writeThreeMf(const std::vector<ExportedObject>& objects, const std::string& path,
                  CoordinateSpace space) {
  for (const ExportedObject& o : objects)
    for (const Vec3& p : o.mesh.points)
      if (!p.cast<float>().allFinite()) refuseOutput(path, FindingKind::badCoordinate);
  const std::string model = modelXml(objects, space);
  constexpr std::size_t kLongest = 0xf0000000;  // without ZIP's 64-bit extension, which not all readers know
  if (model.size() > kLongest) refuseOutput(path, FindingKind::packageTooLarge);
  writeTextAtomically(path, zipped({{"[Content_Types].xml", kContentTypes},
                                    {"_rels/.rels", kRelations},
                                    {"3D/3dmodel.model", model}}));
}

}  // namespace handlebody
