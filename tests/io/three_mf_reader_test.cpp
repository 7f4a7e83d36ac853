// 3MF as others write it, read: packages that libzip makes here of texts, not by our writer.

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "core/io/meshes/three_mf.h"
#include "tests/io/io_test_support.h"
#include "tests/io/mesh_test_support.h"
#include "tests/io/zip_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! A corner of a cube at the origin: a body of 1/6, outward.
const std::string kTetrahedron =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
    "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh>";

std::string object(int id, const std::string& content, const std::string& more = "") {
  return "<object id=\"" + std::to_string(id) + "\" " + more + ">" + content + "</object>";
}

std::string model(const std::string& resources, const std::string& items, const std::string& more = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
         "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" " +
         more + "><resources>" + resources + "</resources><build>" + items + "</build></model>";
}

std::string tetrahedronWith(const std::string& item, const std::string& more = "") {
  return model(object(1, kTetrahedron), "<item objectid=\"1\" " + item + "/>", more);
}

TriangleSoup readBytesAs3mf(const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "m.3mf", bytes);
  return readMesh(folder / "m.3mf");
}

TriangleSoup readModel(const std::string& xml) { return readBytesAs3mf(archiveOfModel(xml)); }

//! So that another language has words for it: no value is a piece of a sentence.
bool isToldByKinds(const Finding& finding) {
  for (const auto& [name, value] : finding.values)
    if (name != "part" && name != "unit" && name != "reason" && std::holds_alternative<std::string>(value))
      return false;
  return std::all_of(finding.causes.begin(), finding.causes.end(), isToldByKinds);
}

//! In one line that begins with the path, ends with the cause, and has a kind.
void expectRefusedPrint(const std::string& bytes, FindingKind kind, const std::string& cause) {
  const TemporaryFolder folder;
  const std::string path = folder / "m.3mf";
  writeBytes(path, bytes);
  Finding finding;
  std::string message;
  try {
    readMesh(path);
  } catch (const InputError& e) {
    message = e.what();
    finding = findingOf(e);
  }
  INFO(cause);
  CHECK(message.rfind(path + ": ", 0) == 0);
  CHECK_THAT(message, Contains(cause));
  CHECK(message.find('\n') == std::string::npos);
  REQUIRE(finding.causes.size() == 1);
  CHECK(findingName(finding.causes[0].kind) == std::string(findingName(kind)));
  if (kind == FindingKind::damagedBecause) CHECK(isToldByKinds(finding.causes[0].causes.at(0)));
  CHECK(sentence(finding) == message);
}

void expectModelRefused(const std::string& xml, FindingKind kind, const std::string& cause) {
  expectRefusedPrint(archiveOfModel(xml), kind, cause);
}

std::vector<ExportedObject> twoInPrint() {
  ObjectLabel second;
  second.name = "Second";
  return {{{}, sphere(Vec3(-101.123456789, 57.3, 181.9), 12.34, 3)},
          {second, sphere(Vec3(5, 0.1, -3), 1, 1)}};
}

using K = FindingKind;

}  // namespace

TEST_CASE("what is written as 3MF is read back: every object, in single precision to the last bit, as LPS") {
  const TemporaryFolder folder;
  const auto objects = twoInPrint();
  const auto space = GENERATE(CoordinateSpace::lps, CoordinateSpace::ras);
  const std::string path = folder / GENERATE("m.3mf", "M.3MF");
  writeThreeMf(objects, path, space);
  REQUIRE(isMeshInputPath(path));
  const TriangleSoup back = readMesh(path);
  std::size_t point = 0, triangle = 0;
  for (const ExportedObject& o : objects) {
    const int first = static_cast<int>(point);
    for (const Vec3& p : o.mesh.points)
      REQUIRE(back.points.at(point++) == Vec3(p.cast<float>().cast<double>()));
    for (const Triangle& t : o.mesh.triangles)
      REQUIRE(back.triangles.at(triangle++) == Triangle{first + t[0], first + t[1], first + t[2]});
  }
  CHECK(point == back.points.size());
  CHECK(triangle == back.triangles.size());
}

TEST_CASE("only the mark of ours turns a 3MF file: a metadata of that name in another namespace is another") {
  const std::string mark = "<metadata name=\"x:Space\">RAS</metadata><resources>";
  for (const std::string space : {"http://handlebody.example.org/3mf", "http://other.example.org"}) {
    std::string xml = tetrahedronWith("", "xmlns:x=\"" + space + "\"");
    xml.replace(xml.find("<resources>"), 11, mark);
    const double x = readModel(xml).points[1].x();
    CHECK(x == (space.find("handlebody") == std::string::npos ? 1 : -1));
  }
}

TEST_CASE("the units of 3MF become millimetres, those of its transforms too; without one it is millimetres") {
  const std::vector<std::pair<std::string, double>> units{{"micron", 1e-3},   {"millimeter", 1},
                                                          {"centimeter", 10}, {"inch", 25.4},
                                                          {"foot", 304.8},    {"meter", 1000}};
  for (const auto& [unit, mm] : units) {
    INFO(unit);
    const TriangleSoup read =
        readModel(tetrahedronWith("transform=\"1 0 0 0 1 0 0 0 1 2 3 4\"", "unit=\"" + unit + "\""));
    CHECK(signedVolume(read) == Approx(mm * mm * mm / 6));
    CHECK((read.points[0] - mm * Vec3(2, 3, 4)).norm() < 1e-9 * mm);
  }
  CHECK(signedVolume(readModel(tetrahedronWith(""))) == Approx(1.0 / 6));
  expectModelRefused(tetrahedronWith("", "unit=\"parsec\""), K::damagedBecause, "unit parsec");
}

TEST_CASE("a transform of 3MF multiplies rows: its first row is where x goes, its last one the shift") {
  const TriangleSoup read = readModel(tetrahedronWith("transform=\" 0 2 0\t0 0 3\n+5e0 0 0 10 20 30 \""));
  CHECK(read.points[0] == Vec3(10, 20, 30));
  CHECK(read.points[1] == Vec3(10, 22, 30));
  CHECK(read.points[2] == Vec3(10, 20, 33));
  CHECK(read.points[3] == Vec3(15, 20, 30));
  CHECK(signedVolume(read) == Approx(30.0 / 6));
}

TEST_CASE("components are placed within components: the inner transform comes first") {
  const std::string xml =
      model(object(1, kTetrahedron) +
                object(2,
                       "<components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 1 0 0\"/>"
                       "<component objectid=\"1\"/></components>") +
                object(3,
                       "<components><component objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 5\"/>"
                       "</components>"),
            "<item objectid=\"3\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 100\"/><item objectid=\"1\"/>");
  const TriangleSoup read = readModel(xml);
  REQUIRE(read.points.size() == 12);
  CHECK(read.triangles.size() == 12);
  CHECK(read.points[0] == Vec3(0, 2, 105));  // (0, 0, 0), moved by 1, doubled, raised, turned, raised
  CHECK(read.points[4] == Vec3(0, 0, 105));
  CHECK(read.points[9] == Vec3(1, 0, 0));
  CHECK(read.triangles[11] == Triangle{9, 10, 11});
  CHECK(signedVolume(read) == Approx((8 + 8 + 1) / 6.0));
}

TEST_CASE("what a transform mirrors stays outward, and what is mirrored twice is not turned") {
  const std::string mirror = "transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"";
  const TriangleSoup once = readModel(tetrahedronWith(mirror));
  CHECK(once.points[1] == Vec3(-1, 0, 0));
  CHECK(signedVolume(once) == Approx(1.0 / 6));
  const TriangleSoup twice =
      readModel(model(object(1, kTetrahedron) +
                          object(2, "<components><component objectid=\"1\" " + mirror + "/></components>"),
                      "<item objectid=\"2\" " + mirror + "/>"));
  CHECK(twice.points[1] == Vec3(1, 0, 0));
  CHECK(twice.triangles[0] == Triangle{0, 2, 1});
  CHECK(signedVolume(twice) == Approx(1.0 / 6));
}

TEST_CASE("of 3MF only what is built is read, and neither supports nor what is of type other") {
  for (const std::string type : {"model", "surface"})
    CHECK(readModel(model(object(1, kTetrahedron, "type=\"" + type + "\""), "<item objectid=\"1\"/>"))
              .triangles.size() == 4);
  for (const std::string type : {"support", "solidsupport", "other"}) {
    const std::string both = object(1, kTetrahedron) + object(2, kTetrahedron, "type=\"" + type + "\"") +
                             object(3,
                                    "<components><component objectid=\"1\"/><component objectid=\"2\"/>"
                                    "</components>",
                                    "type=\"support\"");
    CHECK(readModel(model(both, "<item objectid=\"3\"/>")).triangles.size() == 4);
    expectModelRefused(model(both, "<item objectid=\"2\"/>"), K::noTriangles, "no triangles");
  }
  expectModelRefused(model(object(1, kTetrahedron), ""), K::noTriangles, "no triangles");
}

TEST_CASE("3MF archives with stored entries, without relationships and with names in other cases are read") {
  const std::string xml = tetrahedronWith("");
  for (const int method : {ZIP_CM_STORE, ZIP_CM_DEFLATE}) {
    CHECK(readBytesAs3mf(archiveOf({{"3D/3dmodel.model", xml, method}})).triangles.size() == 4);
    CHECK(readBytesAs3mf(archiveOf({{"3d/3DModel.model", xml, method}})).triangles.size() == 4);
  }
  CHECK(readModel(xml).triangles.size() == 4);  // whose relationship names another part
}

TEST_CASE(
    "objects in other parts of a 3MF package are found, in their own units, and parts that lack are told") {
  const std::string root = model(object(1,
                                        "<components><component objectid=\"1\" p:path=\"/3D/a.model\" "
                                        "transform=\"1 0 0 0 1 0 0 0 1 7 0 0\"/></components>"),
                                 "<item objectid=\"1\"/><item objectid=\"1\" p:path=\"/3D/a.model\"/>",
                                 "requiredextensions=\"p\"");
  const std::string part = model(object(1, kTetrahedron), "<item objectid=\"1\"/>", "unit=\"centimeter\"");
  const TriangleSoup read = readBytesAs3mf(archiveOf({{"3D/3dmodel.model", root}, {"3D/a.model", part}}));
  REQUIRE(read.points.size() == 8);
  CHECK(read.points[1] == Vec3(17, 0, 0));
  CHECK(read.points[5] == Vec3(10, 0, 0));
  expectRefusedPrint(archiveOf({{"3D/3dmodel.model", root}}), K::damagedBecause, "3D/a.model is missing");
}

TEST_CASE("what 3MF has besides the core is ignored, unless the file says that it cannot be read without") {
  std::string xml = tetrahedronWith("", "xmlns:x=\"http://x.example.org\"");
  xml.replace(xml.find("<triangles>"), 0,
              "<x:triangles><triangle v1=\"0\" v2=\"1\" v3=\"9\"/></x:triangles><vertex x=\"bad\"/>");
  CHECK(readModel(xml).triangles.size() == 4);
  expectModelRefused(tetrahedronWith("", "requiredextensions=\"p b\""), K::extensionNotSupported,
                     "an extension of 3MF that is not supported (beamlattice/2017/02)");
  expectModelRefused(tetrahedronWith("", "requiredextensions=\"none\""), K::extensionNotSupported, "(none)");
}

TEST_CASE("numbers of 3MF are read with blanks, plus and exponent, small ones too, and nothing else is") {
  std::string xml = tetrahedronWith("");
  const std::string x = "x=\"1\"";
  const auto withX = [&](const std::string& value) {
    return std::string(xml).replace(xml.find(x), x.size(), "x=\"" + value + "\"");
  };
  CHECK(readModel(withX(" +1.5e1\n")).points[1].x() == 15);
  CHECK(readModel(withX(".25")).points[1].x() == 0.25);
  CHECK(std::abs(readModel(withX("1e-320")).points[1].x()) < 1e-37);
  CHECK(readModel(withX("0.1")).points[1].x() == double{0.1f});
  for (const char* bad : {"", " ", "nan", "inf", "-inf", "1e39", "1e999", "1,5", "1 2", "0x10", "+-1", "one"})
    expectModelRefused(withX(bad), K::vertexDamaged, "not three numbers");
  xml.replace(xml.find(" y=\"0\""), 6, "");
  expectModelRefused(xml, K::vertexDamaged, "not three numbers");
}

TEST_CASE("faces of 3MF that name no vertex are refused") {
  const std::string xml = tetrahedronWith(""), v = "v2=\"2\"";
  const auto withV = [&](const std::string& value) {
    return std::string(xml).replace(xml.find(v), v.size(), value);
  };
  expectModelRefused(withV("v2=\"4\""), K::faceVertexMissing, "not there");
  for (const char* bad : {"v2=\"-1\"", "v2=\"99999999999\"", "v2=\"1.0\"", "v2=\"\"", ""})
    expectModelRefused(withV(bad), K::faceDamaged, "a face is damaged");
}

TEST_CASE("transforms, objects and items of 3MF that make no sense are refused") {
  for (const char* bad : {"", "1 0 0 0 1 0 0 0 1 0 0", "1 0 0 0 1 0 0 0 1 0 0 0 0", "1 0 0 0 1 0 0 0 1 0 0 x",
                          "nan 0 0 0 1 0 0 0 1 0 0 0", "1e999 0 0 0 1 0 0 0 1 0 0 0"})
    expectModelRefused(tetrahedronWith("transform=\"" + std::string(bad) + "\""), K::damagedBecause,
                       "twelve numbers");
  expectModelRefused(tetrahedronWith("transform=\"1.7e308 0 0 0 1 0 0 0 1 1.7e308 0 0\""), K::badCoordinate,
                     "not a number or infinite");
}

TEST_CASE("components of 3MF that hold themselves, are missing, too deep or too many are refused") {
  const auto holding = [](int id, const std::vector<int>& others) {
    std::string all = "<components>";
    for (const int other : others) all += "<component objectid=\"" + std::to_string(other) + "\"/>";
    return object(id, all + "</components>");
  };
  expectModelRefused(model(holding(1, {1}), "<item objectid=\"1\"/>"), K::damagedBecause,
                     "object 1 holds itself");
  expectModelRefused(model(holding(1, {2}) + holding(2, {1}), "<item objectid=\"1\"/>"), K::damagedBecause,
                     "object 1 holds itself");
  expectModelRefused(model(holding(1, {2}), "<item objectid=\"1\"/>"), K::damagedBecause,
                     "object 2 is missing");
  expectModelRefused(model("", "<item objectid=\"1\"/>"), K::damagedBecause, "object 1 is missing");
  expectModelRefused(model(object(1, kTetrahedron), "<item/>"), K::damagedBecause, "without an object");
  expectModelRefused(model(object(1, "") + object(1, ""), ""), K::damagedBecause, "two objects 1");
  expectModelRefused(model("<object/>", ""), K::damagedBecause, "an object without a number");
  std::string chain = object(1, kTetrahedron), bush = chain;
  for (int id = 2; id <= 40; ++id) {
    chain += holding(id, {id - 1});
    bush += holding(id, std::vector<int>(id < 8 ? 10 : 1, id - 1));
  }
  CHECK(readModel(model(chain, "<item objectid=\"20\"/>")).triangles.size() == 4);
  expectModelRefused(model(chain, "<item objectid=\"40\"/>"), K::damagedBecause,
                     "too deeply nested components");
  CHECK(readModel(model(bush, "<item objectid=\"4\"/>")).triangles.size() == 4000);
  expectModelRefused(model(bush, "<item objectid=\"8\"/>"), K::damagedBecause, "more than 1000000 objects");
}

TEST_CASE("XML that is damaged or hostile is refused with its line, before anything multiplies") {
  const std::string xml = tetrahedronWith("");
  expectModelRefused(xml.substr(0, xml.size() - 4), K::damagedBecause, "XML: ");
  expectModelRefused(xml + "<more/>", K::damagedBecause, "in line 2 of 3D/m.model");
  expectModelRefused("", K::damagedBecause, "XML: no element found");
  expectModelRefused("This is a letter.", K::damagedBecause, "XML: ");
  expectModelRefused("<x:model/>", K::damagedBecause, "XML: unbound prefix");
  expectModelRefused("<model/>", K::notOfFormat, "not a 3MF file");
  std::string doctype = xml;
  doctype.insert(doctype.find("<model"), "<!DOCTYPE model [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;\">]>");
  expectModelRefused(doctype, K::damagedBecause, "a document type declaration");
  std::string deep = xml, wide = xml;
  for (int i = 0; i < 70; ++i) deep.insert(deep.find("<resources>"), "<a>");
  expectModelRefused(deep, K::damagedBecause, "too deeply nested XML");
  wide.insert(wide.find("<resources>"), "<a b=\"" + std::string(3 << 20, 'c') + "\"/>");
  expectModelRefused(wide, K::damagedBecause, "a tag of more than a megabyte");
  std::string text = xml;
  text.insert(text.find("<resources>"), std::string(3 << 20, ' '));
  CHECK(readModel(text).triangles.size() == 4);
}

TEST_CASE("what is no 3MF package is refused") {
  expectRefusedPrint("This is a letter.\n", K::notOfFormat, "it is not a 3MF file");
  expectRefusedPrint(archiveOf({{"word/document.xml", "<a/>"}}), K::notOfFormat, "it is not a 3MF file");
  const std::string relationships =
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
      "Target=\"/3D/no\nsuch.model\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
      "</Relationships>";
  expectRefusedPrint(archiveOf({{"_rels/.rels", relationships}, {"3D/3dmodel.model", tetrahedronWith("")}}),
                     K::damagedBecause, "3D/no such.model is missing");
  expectRefusedPrint(archiveOf({{"_rels/.rels", "<Relationships>"}}), K::damagedBecause, "of _rels/.rels");
}

TEST_CASE("an encrypted 3MF file says so, and one packed in a way that 3MF does not know is refused") {
  expectRefusedPrint(archiveOf({{"3D/3dmodel.model", tetrahedronWith(""), ZIP_CM_DEFLATE, true}}),
                     K::encryptedFile, "it is encrypted");
  if (zip_compression_method_supported(ZIP_CM_BZIP2, 1))
    expectRefusedPrint(archiveOf({{"3D/3dmodel.model", tetrahedronWith(""), ZIP_CM_BZIP2}}),
                       K::damagedBecause, "the compression of 3D/3dmodel.model");
}

TEST_CASE("a 3MF file that unpacks to a hundred times its size and more is refused once that takes long") {
  std::string xml = tetrahedronWith("");
  xml.insert(xml.find("<resources>"), std::string(std::size_t{70} << 20, ' '));
  expectRefusedPrint(archiveOf({{"3D/3dmodel.model", xml, ZIP_CM_DEFLATE}}), K::damagedBecause,
                     "the size of 3D/3dmodel.model");
}

TEST_CASE("sizes that no archive of this length can hold are refused before they are unpacked") {
  const std::string whole = archiveOf({{"3D/3dmodel.model", tetrahedronWith("")}});
  const std::size_t central = whole.rfind("PK\1\2");
  for (const std::uint32_t size : {0x7fffffffu, 0xfffffff0u, 5u}) {
    std::string bytes = whole;
    patch(bytes, central + 24, size);  // unpacked
    expectRefusedPrint(bytes, K::damagedBecause, "the size of 3D/3dmodel.model");
  }
  std::string bytes = whole;
  patch(bytes, central + 20, 0x7fffffffu);  // packed
  expectRefusedPrint(bytes, K::damagedBecause, "the size of 3D/3dmodel.model");
}

TEST_CASE(
    "every truncation of a 3MF file is refused, and a flipped bit of its data is found by the checksum") {
  const TemporaryFolder folder;
  writeThreeMf({{{}, sphere(Vec3(0, 0, 0), 1, 1)}}, folder / "whole.3mf");
  const std::string whole = readBytes(folder / "whole.3mf");
  for (std::size_t n = 1; n < whole.size(); n += n < whole.size() - 40 ? 13 : 1) {
    INFO(n << " of " << whole.size());
    writeBytes(folder / "cut.3mf", whole.substr(0, n));
    CHECK_THROWS_AS(readMesh(folder / "cut.3mf"), InputError);
  }
  std::string stored = archiveOfModel(tetrahedronWith(""));
  const std::size_t digit = stored.find("x=\"1\"") + 3;
  stored[digit] = '2';
  expectRefusedPrint(stored, K::truncatedOrDamagedFor, "CRC error");
}

TEST_CASE("changed bytes and changed XML in 3MF files are refused or read, never a crash") {
  std::mt19937 random(12);
  const std::string xml = tetrahedronWith("transform=\"1 0 0 0 1 0 0 0 1 2 3 4\""),
                    whole = archiveOfModel(xml);
  for (int round = 0; round < 400; ++round) {
    const bool isXml = round % 2 == 0;
    std::string bytes = isXml ? xml : whole;
    for (int change = 0; change < 3; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
    try {
      const TriangleSoup mesh = isXml ? readModel(bytes) : readBytesAs3mf(bytes);
      for (const Triangle& t : mesh.triangles)
        for (int v : t) REQUIRE((v >= 0 && v < static_cast<int>(mesh.points.size())));
    } catch (const InputError&) {
      SUCCEED();
    }
  }
}

TEST_CASE("a mesh with a coordinate that single precision cannot hold is not written as 3MF") {
  const TemporaryFolder folder;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e39}) {
    std::vector<ExportedObject> objects = twoInPrint();
    objects[1].mesh.points[3].x() = bad;
    CHECK_THROWS_AS(writeThreeMf(objects, folder / "m.3mf"), OutputError);
  }
  CHECK(folder.fileCount() == 0);
}
