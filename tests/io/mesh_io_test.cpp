#include "core/io/meshes/mesh_io.h"

#include <limits>

#include "tests/io/comma_locale.h"
#include "tests/io/io_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Single precision near 200 mm is good to 1.5e-5 mm.
constexpr double kSingle = 2e-5;

TriangleSoup roundBall() { return sphere(Vec3(-101.123456789, 57.3, 181.9), 12.34, 4); }

double largestDistance(const TriangleSoup& a, const TriangleSoup& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    largest = std::max(largest, (a.points[i] - b.points[i]).norm());
  return largest;
}

void expectMeshError(const std::string& path, const std::string& cause) {
  INFO(path);
  std::string message;
  try {
    readMesh(path);
  } catch (const InputError& e) {
    message = e.what();
  }
  CHECK_THAT(message, Contains(cause));
  CHECK(message.rfind(path, 0) == 0);
}

}  // namespace

TEST_CASE("VTP and OBJ keep every vertex bit for bit and every triangle in order") {
  const TemporaryFolder folder;
  const std::string path = folder / GENERATE("m.vtp", "m.obj", "M.OBJ");
  const auto space = GENERATE(CoordinateSpace::lps, CoordinateSpace::ras);
  writeMesh(roundBall(), path, space);
  CHECK(folder.fileCount() == 1);
  const TriangleSoup back = readMesh(path);
  CHECK((back.points == roundBall().points));
  CHECK((back.triangles == roundBall().triangles));
}

TEST_CASE("PLY keeps vertices and triangles in order, in single precision") {
  const TemporaryFolder folder;
  const auto space = GENERATE(CoordinateSpace::lps, CoordinateSpace::ras);
  writeMesh(roundBall(), folder / "m.ply", space);
  const TriangleSoup back = readMesh(folder / "m.ply");
  REQUIRE(back.points.size() == roundBall().points.size());
  CHECK(largestDistance(back, roundBall()) < kSingle);
  CHECK((back.triangles == roundBall().triangles));
}

TEST_CASE("STL vertices with equal coordinates are merged to the same closed mesh") {
  const TemporaryFolder folder;
  const auto space = GENERATE(CoordinateSpace::lps, CoordinateSpace::ras);
  writeMesh(roundBall(), folder / "m.stl", space);
  const TriangleSoup back = readMesh(folder / "m.stl");
  CHECK(back.points.size() == roundBall().points.size());
  CHECK(back.triangles.size() == roundBall().triangles.size());
  CHECK(signedVolume(back) == Approx(signedVolume(roundBall())).epsilon(1e-5));
  CHECK(area(back) == Approx(area(roundBall())).epsilon(1e-5));
}

TEST_CASE("files say their space, in RAS x and y are turned, and the winding stays outward") {
  const TemporaryFolder folder;
  for (const char* name : {"m.stl", "m.vtp", "m.ply", "m.obj"}) {
    INFO(name);
    writeMesh(roundBall(), folder / name, CoordinateSpace::ras);
    const std::string bytes = readBytes(folder / name);
    const std::string mark = std::string(name) == "m.vtp" ? "Name=\"SPACE\"" : "SPACE=RAS";
    CHECK(bytes.substr(0, 2000).find(mark) != std::string::npos);
    CHECK(bytes.rfind("solid", 0) != 0);
    writeMesh(roundBall(), folder / name, CoordinateSpace::lps);
    CHECK(readBytes(folder / name).find("SPACE=RAS") == std::string::npos);
  }
  writeMesh(roundBall(), folder / "ras.stl", CoordinateSpace::ras);
  float x = 0;
  std::memcpy(&x, readBytes(folder / "ras.stl").data() + 96, 4);
  const double firstX = roundBall().points[roundBall().triangles[0][0]].x();
  CHECK(static_cast<double>(x) == Approx(-firstX));
  // The same bytes without their mark are read as they stand: turned about z, with a positive volume.
  std::string bytes = readBytes(folder / "ras.stl");
  bytes.replace(bytes.find("SPACE=RAS"), 9, "SPACE=LPS");
  writeBytes(folder / "turned.stl", bytes);
  CHECK(signedVolume(readMesh(folder / "turned.stl")) == Approx(signedVolume(roundBall())).epsilon(1e-5));
}

TEST_CASE("meshes of others are read: text STL and PLY, polygons, relative OBJ corners") {
  const TemporaryFolder folder;
  writeBytes(
      folder / "a.stl",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
      "a\n");
  CHECK(readMesh(folder / "a.stl").points.size() == 4);
  CHECK(area(readMesh(folder / "a.stl")) == Approx(1));
  writeBytes(folder / "a.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 "
             "0\n4 0 1 2 3\n");
  CHECK(readMesh(folder / "a.ply").triangles.size() == 2);
  CHECK(area(readMesh(folder / "a.ply")) == Approx(1));
  writeBytes(folder / "a.obj",
             "o quad\nv 0 0 0\nv 1 0 0 1\r\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf -4//1 -3//1 3/1/1 4\n");
  CHECK(area(readMesh(folder / "a.obj")) == Approx(1));
}

TEST_CASE("lines of an OBJ may begin with blanks, and a tab may end a keyword") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.obj";
  writeBytes(path,
             "v 0 0 0\n  v 1 0 0\nv\t0 1 0\n\tv\t1\t1\t0\r\n \n vt 9 9\n\tvn 0 0 1\nvp 1 1\n"
             "  f 1 2 3\nf\t2/1\t4/1 3\r\n fo 1 2 3\n");
  const TriangleSoup mesh = readMesh(path);
  REQUIRE(mesh.points.size() == 4);
  CHECK((mesh.points[3] == Vec3(1, 1, 0)));
  CHECK((mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
  for (const char* line : {"v", "f\r", " f"}) {
    writeBytes(path, line);
    CHECK_THROWS_AS(readMesh(path), InputError);
  }
}

TEST_CASE("a text STL has points in its numbers, whatever the locale") {
  const TemporaryFolder folder;
  writeBytes(folder / "a.stl",
             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0.25 0.5 0\nvertex 1.25 0.5 0\n"
             "vertex 0.25 2.5e0 0\nendloop\nendfacet\nendsolid a\n");
  const CommaLocale comma;
  if (!comma.isChosen()) return;
  TriangleSoup read;
  REQUIRE_NOTHROW(read = readMesh(folder / "a.stl"));
  REQUIRE(read.points.size() == 3);
  CHECK(read.points[0] == Vec3(0.25, 0.5, 0));
  CHECK(area(read) == Approx(1));
}

TEST_CASE("damaged mesh files are refused with one sentence") {
  const TemporaryFolder folder;
  expectMeshError(folder / "missing.stl", "no such file");
  expectMeshError(folder.path(), "it is not a file");
  writeBytes(folder / "mesh.txt", "v 0 0 0");
  expectMeshError(folder / "mesh.txt", "not a mesh file");
  writeBytes(folder / "far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  expectMeshError(folder / "far.obj", "not there in line 4");
  writeBytes(
      folder / "far.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 7\n");
  expectMeshError(folder / "far.ply", "not there");
  for (const char* ending : {".stl", ".vtp", ".ply", ".obj"}) {
    writeBytes(folder / (std::string("empty") + ending), "");
    expectMeshError(folder / (std::string("empty") + ending), "empty");
    writeBytes(folder / (std::string("text") + ending), "This is a letter, not a mesh.\nfoo bar baz\n");
    expectMeshError(folder / (std::string("text") + ending), "");
    TriangleSoup bad = roundBall();
    bad.points[3].x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(writeMesh(bad, folder / (std::string("nan") + ending)), OutputError);
    CHECK_FALSE(fs::exists(folder / (std::string("nan") + ending)));
  }
}

TEST_CASE("truncated STL, VTP and PLY files are refused wherever they end") {
  const TemporaryFolder folder;
  const TriangleSoup mesh = sphere(Vec3(0, 0, 0), 1, 1);
  for (const std::string ending : {".stl", ".vtp", ".ply"}) {
    writeMesh(mesh, folder / ("whole" + ending));
    const std::string bytes = readBytes(folder / ("whole" + ending));
    for (std::size_t n = 1; n < bytes.size() - 1; n += 1 + n / 40) {
      INFO(ending << " " << n << " of " << bytes.size());
      writeBytes(folder / ("cut" + ending), bytes.substr(0, n));
      CHECK_THROWS_AS(readMesh(folder / ("cut" + ending)), InputError);
    }
  }
}

TEST_CASE("changed bytes in mesh files are refused or read, never a crash") {
  const TemporaryFolder folder;
  std::mt19937 random(11);
  for (const std::string ending : {".stl", ".ply", ".obj", ".vtp"}) {
    writeMesh(sphere(Vec3(0, 0, 0), 1, 1), folder / ("whole" + ending));
    const std::string whole = readBytes(folder / ("whole" + ending));
    for (int round = 0; round < 200; ++round) {
      std::string bytes = whole;
      for (int change = 0; change < 3; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
      writeBytes(folder / ("changed" + ending), bytes);
      try {
        const TriangleSoup mesh = readMesh(folder / ("changed" + ending));
        for (const Triangle& t : mesh.triangles)
          for (int v : t) REQUIRE((v >= 0 && v < static_cast<int>(mesh.points.size())));
      } catch (const InputError&) {
        SUCCEED();
      }
    }
  }
}
