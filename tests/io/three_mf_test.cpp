// 3MF: an archive whose model holds the meshes, names and colours.

#include "core/io/meshes/three_mf.h"

#include <zlib.h>

#include <cstdlib>
#include <map>

#include "core/errors.h"
#include "tests/io/io_test_support.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

std::uint32_t number(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int i = size; i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

//! The entries of a ZIP archive, found through its central directory; sizes and checksums are checked.
std::map<std::string, std::string> unzipped(const std::string& bytes) {
  std::map<std::string, std::string> entries;
  const std::size_t end = bytes.size() - 22;
  REQUIRE(bytes.substr(end, 4) == "PK\x05\x06");
  std::size_t at = number(bytes, end + 16, 4);
  for (std::uint32_t i = 0; i < number(bytes, end + 10, 2); ++i) {
    REQUIRE(bytes.substr(at, 4) == "PK\x01\x02");
    const std::uint32_t crc = number(bytes, at + 16, 4), packed = number(bytes, at + 20, 4);
    const std::uint32_t name = number(bytes, at + 28, 2), offset = number(bytes, at + 42, 4);
    REQUIRE(bytes.substr(offset, 4) == "PK\x03\x04");
    REQUIRE(bytes.substr(offset + 4, 26) == bytes.substr(at + 6, 26));  // both headers agree
    std::string content(number(bytes, at + 24, 4), '\0');
    const std::string data = bytes.substr(offset + 30 + name, packed);
    z_stream stream{};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
    stream.avail_in = packed;
    stream.next_out = reinterpret_cast<Bytef*>(content.data());
    stream.avail_out = static_cast<uInt>(content.size());
    REQUIRE(inflateInit2(&stream, -15) == Z_OK);
    REQUIRE(inflate(&stream, Z_FINISH) == Z_STREAM_END);
    inflateEnd(&stream);
    CHECK(crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())) == crc);
    entries[bytes.substr(at + 46, name)] = content;
    at += 46 + name;
  }
  CHECK(at == end);
  return entries;
}

//! The values of an attribute, in the order of the text.
std::vector<double> values(const std::string& xml, const std::string& attribute) {
  std::vector<double> all;
  const std::string start = " " + attribute + "=\"";
  for (auto at = xml.find(start); at != std::string::npos; at = xml.find(start, at + 1))
    all.push_back(std::strtod(xml.c_str() + at + start.size(), nullptr));
  return all;
}

std::vector<ExportedObject> twoBalls() {
  ObjectLabel first, second;
  first.name = "A & <B>";
  first.colour = {255, 0, 16};
  second.name = "Second";
  return {{first, zoo::sphere(2)}, {second, zoo::moved(zoo::sphere(2), Vec3(5, 0.1, -3))}};
}

}  // namespace

TEST_CASE("a 3MF file is an archive of a model with names, colours, millimetres and the meshes") {
  const TemporaryFolder folder;
  const auto objects = twoBalls();
  writeThreeMf(objects, folder / "two.3MF");
  auto entries = unzipped(readBytes(folder / "two.3MF"));
  REQUIRE(entries.size() == 3);
  CHECK_THAT(entries["[Content_Types].xml"], Contains("3dmanufacturing-3dmodel+xml"));
  CHECK_THAT(entries["_rels/.rels"], Contains("Target=\"/3D/3dmodel.model\""));
  const std::string& xml = entries["3D/3dmodel.model"];
  CHECK_THAT(xml, Contains("unit=\"millimeter\""));
  CHECK_THAT(xml, Contains("<base name=\"A &amp; &lt;B&gt;\" displaycolor=\"#FF0010FF\"/>"));
  CHECK_THAT(xml, Contains("<object id=\"3\" type=\"model\" name=\"Second\" pid=\"1\" pindex=\"1\">"));
  CHECK_THAT(xml, Contains("<item objectid=\"2\"/><item objectid=\"3\"/>"));
  const auto x = values(xml, "x"), y = values(xml, "y"), z = values(xml, "z");
  const auto a = values(xml, "v1"), b = values(xml, "v2"), c = values(xml, "v3");
  std::size_t point = 0, triangle = 0;
  for (const ExportedObject& o : objects) {
    for (const Vec3& p : o.mesh.points) {
      REQUIRE(Vec3(x[point], y[point], z[point]).cast<float>() == p.cast<float>());
      ++point;
    }
    for (const Triangle& t : o.mesh.triangles) {
      REQUIRE(std::array{int(a[triangle]), int(b[triangle]), int(c[triangle])} ==
              std::array{t[0], t[1], t[2]});
      ++triangle;
    }
  }
  CHECK(point == x.size());
  CHECK(triangle == a.size());
}

TEST_CASE("the same objects give the same 3MF file, and RAS turns x and y") {
  const TemporaryFolder folder;
  const auto objects = twoBalls();
  writeThreeMf(objects, folder / "a.3mf");
  writeThreeMf(objects, folder / "b.3mf");
  CHECK(readBytes(folder / "a.3mf") == readBytes(folder / "b.3mf"));
  writeThreeMf(objects, folder / "ras.3mf", CoordinateSpace::ras);
  const auto lps = unzipped(readBytes(folder / "a.3mf"))["3D/3dmodel.model"];
  const auto ras = unzipped(readBytes(folder / "ras.3mf"))["3D/3dmodel.model"];
  for (const char* axis : {"x", "y"}) CHECK(values(ras, axis)[40] == -values(lps, axis)[40]);
  CHECK(values(ras, "z") == values(lps, "z"));
  CHECK_THROWS_AS(writeThreeMf(objects, folder / "no/such/a.3mf"), OutputError);
  CHECK(folder.fileCount() == 3);
}
