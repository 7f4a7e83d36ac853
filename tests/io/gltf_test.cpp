// glTF: a scene with a node for each object.

#include "core/io/meshes/gltf.h"

#include <nlohmann/json.hpp>

#include "core/errors.h"
#include "core/mesh/shapes.h"
#include "tests/io/io_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

std::string decoded(const std::string& base64) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned value = 0;
  int bits = 0;
  for (const char c : base64) {
    const auto digit = kDigits.find(c);
    if (digit == std::string::npos) break;
    value = value << 6 | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(value >> bits & 255);
  }
  return bytes;
}

//! The values of an accessor, each as T.
template <typename T>
std::vector<T> values(const nlohmann::json& gltf, std::size_t accessor, std::size_t perItem) {
  const auto& a = gltf.at("accessors").at(accessor);
  const auto& view = gltf.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
  const std::string uri = gltf.at("buffers").at(view.at("buffer").get<std::size_t>()).at("uri");
  const std::string bytes = decoded(uri.substr(uri.find(',') + 1));
  std::vector<T> all(a.at("count").get<std::size_t>() * perItem);
  REQUIRE(bytes.size() >= all.size() * sizeof(T));
  std::memcpy(all.data(), bytes.data(), all.size() * sizeof(T));
  return all;
}

std::vector<ExportedObject> twoInScene() {
  ObjectLabel liver, cyst;
  liver.name = "Left ä liver";
  liver.colour = {255, 0, 128};
  cyst.name = "Cyst";
  return {{liver, icosphere(Vec3(10, 20, 30), 5, 2)}, {cyst, icosphere(Vec3(-40, 0, 7), 3, 1)}};
}

}  // namespace

TEST_CASE("a glTF scene has the objects with names, colours, points and faces, in metres with y up") {
  const TemporaryFolder folder;
  const std::vector<ExportedObject> objects = twoInScene();
  writeGltf(objects, folder / "a.gltf");
  const auto gltf = nlohmann::json::parse(readBytes(folder / "a.gltf"));
  CHECK(gltf.at("asset").at("version") == "2.0");
  REQUIRE(gltf.at("nodes").size() == 2);
  CHECK(gltf.at("scenes").at(0).at("nodes") == nlohmann::json{0, 1});
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& node = gltf.at("nodes").at(i);
    CHECK(node.at("name") == objects[i].label.name);
    const auto& primitive = gltf.at("meshes").at(node.at("mesh").get<std::size_t>()).at("primitives").at(0);
    CHECK(gltf.at("materials").at(primitive.at("material").get<std::size_t>()).at("name") ==
          objects[i].label.name);
    const TriangleSoup& mesh = objects[i].mesh;
    const auto points = values<float>(gltf, primitive.at("attributes").at("POSITION").get<std::size_t>(), 3);
    REQUIRE(points.size() == 3 * mesh.points.size());
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
      const Vec3 back(1000 * points[3 * p], -1000 * points[3 * p + 2], 1000 * points[3 * p + 1]);
      REQUIRE((back - mesh.points[p]).norm() < 1e-5);
    }
    const auto corners = values<std::uint32_t>(gltf, primitive.at("indices").get<std::size_t>(), 1);
    REQUIRE(corners.size() == 3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(corners[3 * t + c] == static_cast<std::uint32_t>(mesh.triangles[t][c]));
  }
  const auto colour = gltf.at("materials").at(0).at("pbrMetallicRoughness").at("baseColorFactor");
  CHECK(colour.at(0) == 1.0);
  CHECK(colour.at(1) == 0.0);
  CHECK(colour.at(2).get<double>() == Approx(0.2158605).epsilon(1e-5));
  writeGltf(objects, folder / "b.gltf");
  CHECK(readBytes(folder / "a.gltf") == readBytes(folder / "b.gltf"));
}

TEST_CASE("a glTF scene that cannot be written leaves nothing") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(writeGltf(twoInScene(), folder / "none/a.gltf"), OutputError);
  CHECK(folder.fileCount() == 0);
}
