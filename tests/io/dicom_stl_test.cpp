// The STL within DICOM (Encapsulated STL), read.

#include "core/io/dicom/dicom_writer.h"
#include "core/io/meshes/mesh_io.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

constexpr const char* kExplicitSyntax = "1.2.840.10008.1.2.1";

TriangleSoup stlBall() { return sphere(Vec3(-101.5, 57.25, 181), 12.5, 2); }

//! The bytes of a binary STL.
std::string stl(const TriangleSoup& mesh, CoordinateSpace space = CoordinateSpace::lps) {
  const TemporaryFolder folder;
  writeMesh(mesh, folder / "m.stl", space);
  return readBytes(folder / "m.stl");
}

//! A DICOM file as others may make it.
struct Encapsulated {
  std::string syntax = kExplicitSyntax, type = "model/stl", unit{}, document = stl(stlBall());
  //! With the lengths of a sequence and its item, or with marks at their ends.
  bool hasLengths = true;

  std::string bytes() const {
    DicomText text;
    text.add(2, 0x02, "UI", "1.2.840.10008.5.1.4.1.1.104.3");
    text.add(2, 0x10, "UI", syntax);
    text.add(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.104.3");
    if (!unit.empty()) addUnit(text);
    if (!document.empty()) text.add(0x42, 0x11, "OB", document);
    if (!type.empty()) text.add(0x42, 0x12, "LO", type);
    return std::string(128, '\0') + "DICM" + text.bytes;
  }

 private:
  void addUnit(DicomText& text) const {
    DicomText code;
    code.add(8, 0x100, "SH", unit);
    code.add(8, 0x102, "SH", "UCUM");
    if (hasLengths) return text.addSequence(0x40, 0x8ea, {code});
    text.bytes += std::string("\x40\0\xea\x08SQ\0\0\xff\xff\xff\xff", 12) +
                  std::string("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8) + code.bytes +
                  std::string("\xfe\xff\x0d\xe0\0\0\0\0", 8) + std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8);
  }
};

TriangleSoup readBack(const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "m.stl.dcm", bytes);
  return readMesh(folder / "m.stl.dcm");
}

void expectRefused(const std::string& bytes, FindingKind kind, const std::string& said) {
  const TemporaryFolder folder;
  const std::string path = folder / "m.stl.dcm";
  writeBytes(path, bytes);
  try {
    readMesh(path);
    FAIL("it was read");
  } catch (const InputError& error) {
    const Finding finding = findingOf(error);
    INFO(error.what());
    REQUIRE(finding.kind == FindingKind::fileRefused);
    CHECK(finding.causes.at(0).kind == kind);
    CHECK(hasKinds(finding));
    CHECK(std::string(error.what()) == path + ": " + said + ".");
  }
}

}  // namespace

TEST_CASE("an encapsulated STL is read back as the meshes that it was made of", "[encapsulated]") {
  const TemporaryFolder folder;
  const std::string path = folder / GENERATE("m.stl.dcm", "M.STL.DCM");
  const TriangleSoup other = sphere(Vec3(10, 20, 30), 4, 1);
  writeDicomStl({{{}, stlBall()}, {{}, other}}, {}, {}, path);
  CHECK(isMeshInputPath(path));
  CHECK_FALSE(isMeshPath(path));  // it is not written as a mesh alone
  const TriangleSoup back = readMesh(path);
  REQUIRE(back.points.size() == stlBall().points.size() + other.points.size());
  CHECK(back.triangles.size() == stlBall().triangles.size() + other.triangles.size());
  CHECK(signedVolume(back) == Approx(signedVolume(stlBall()) + signedVolume(other)).epsilon(1e-5));
  CHECK((back.points[0] - stlBall().points[stlBall().triangles[0][0]]).norm() < 2e-5);
}

TEST_CASE("encapsulated STL of others is read: in RAS, in other units, with sequences of any kind",
          "[encapsulated]") {
  const double volume = signedVolume(stlBall());
  CHECK(signedVolume(readBack(Encapsulated{}.bytes())) == Approx(volume).epsilon(1e-5));
  Encapsulated ras;
  ras.document = stl(stlBall(), CoordinateSpace::ras);
  CHECK((readBack(ras.bytes()).points[0] - readBack(Encapsulated{}.bytes()).points[0]).norm() < 1e-4);
  Encapsulated capital;
  capital.type = "Model/STL";
  CHECK(readBack(capital.bytes()).triangles.size() == stlBall().triangles.size());
  for (const auto& [unit, millimetres] : {std::pair("mm", 1.0), std::pair("cm", 10.0), std::pair("um", 1e-3)})
    for (const bool hasLengths : {true, false}) {
      INFO(unit << " " << hasLengths);
      Encapsulated scaled;
      scaled.unit = unit;
      scaled.hasLengths = hasLengths;
      CHECK(signedVolume(readBack(scaled.bytes())) ==
            Approx(volume * std::pow(millimetres, 3)).epsilon(1e-5));
    }
}

TEST_CASE("what holds no STL is refused, and what it holds is told", "[encapsulated]") {
  const auto changed = [](auto&& change) {
    Encapsulated file;
    change(file);
    return file.bytes();
  };
  expectRefused("This is a letter, not a mesh.\n", FindingKind::notOfFormat, "it is not a DICOM file");
  expectRefused(dicomBytes(evenStack(1)[0], "1.2"), FindingKind::notOfFormat,
                "it is not a DICOM Encapsulated STL file");
  expectRefused(changed([](Encapsulated& f) { f.document.clear(); }), FindingKind::notOfFormat,
                "it is not a DICOM Encapsulated STL file");
  expectRefused(changed([](Encapsulated& f) { f.type = "application/pdf"; }), FindingKind::decodingFailed,
                "its data cannot be decoded (application/pdf, not model/stl)");
  expectRefused(changed([](Encapsulated& f) { f.type.clear(); }), FindingKind::decodingFailed,
                "its data cannot be decoded (no MIME type (0042,0012))");
  expectRefused(changed([](Encapsulated& f) { f.unit = "[ft_i]"; }), FindingKind::decodingFailed,
                "its data cannot be decoded (unit [ft_i])");
  expectRefused(changed([](Encapsulated& f) { f.syntax = "1.2.840.10008.1.2.1.99"; }),
                FindingKind::decodingFailed,
                "its data cannot be decoded (transfer syntax 1.2.840.10008.1.2.1.99)");
  expectRefused(changed([](Encapsulated& f) { f.document = "solid text\nendsolid text\n"; }),
                FindingKind::notStl, "it is not an STL file, or it is truncated");
  expectRefused(changed([](Encapsulated& f) { f.document.resize(f.document.size() - 50); }),
                FindingKind::notStl, "it is not an STL file, or it is truncated");
  expectRefused(changed([](Encapsulated& f) { f.document = std::string(84, '\0'); }),
                FindingKind::noTriangles, "it holds no triangles");
}

TEST_CASE("a document without a length, or with one beyond the file, is refused", "[encapsulated]") {
  std::string bytes = Encapsulated{}.bytes();
  const auto at = bytes.find(std::string("\x42\0\x11\0OB", 6));
  REQUIRE(at != std::string::npos);
  for (const std::uint32_t length : {0xfffffffeu, 0x7fffffffu, static_cast<std::uint32_t>(bytes.size())}) {
    patch(bytes, at + 8, length);
    expectRefused(bytes, FindingKind::dicomDamaged, "the DICOM file is truncated or damaged");
  }
  patch(bytes, at + 8, 0xffffffffu);  // undefined, and no fragments follow
  expectRefused(bytes, FindingKind::dicomDamaged, "the DICOM file is truncated or damaged");
  Encapsulated fragments;
  fragments.document.clear();
  std::string file = fragments.bytes();
  file.insert(file.find(std::string("\x42\0\x12\0LO", 6)),
              std::string("\x42\0\x11\0OB\0\0\xff\xff\xff\xff", 12) +
                  std::string("\xfe\xff\x00\xe0\x04\0\0\0abcd", 12) +
                  std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8));
  expectRefused(file, FindingKind::decodingFailed,
                "its data cannot be decoded (the document (0042,0011) is of undefined length)");
}

namespace {

bool isWholeOrRefused(const std::string& path, const TriangleSoup& whole) try {
  const TriangleSoup read = readMesh(path);
  return read.points == whole.points && read.triangles == whole.triangles;
} catch (const InputError&) {
  return true;
}

}  // namespace

TEST_CASE("an encapsulated STL that is cut off anywhere is refused", "[encapsulated]") {
  const TemporaryFolder folder;
  writeDicomStl({{{}, sphere(Vec3(0, 0, 0), 1, 1)}}, {}, {}, folder / "whole.stl.dcm");
  const std::string bytes = readBytes(folder / "whole.stl.dcm");
  const TriangleSoup whole = readMesh(folder / "whole.stl.dcm");
  const std::size_t type = bytes.find("model/stl");
  for (std::size_t n = 1; n < bytes.size() - 1; n += 1 + n / 100) {
    INFO(n << " of " << bytes.size());
    writeBytes(folder / "cut.stl.dcm", bytes.substr(0, n));
    // Between two elements behind the document and its type nothing of either is missing.
    if (n <= type)
      CHECK_THROWS_AS(readMesh(folder / "cut.stl.dcm"), InputError);
    else
      CHECK(isWholeOrRefused(folder / "cut.stl.dcm", whole));
  }
}

TEST_CASE("changed bytes in an encapsulated STL are refused or read, never a crash", "[encapsulated]") {
  const TemporaryFolder folder;
  const std::string path = folder / "changed.stl.dcm";
  writeDicomStl({{{}, sphere(Vec3(0, 0, 0), 1, 0)}}, {}, {}, path);
  const std::string whole = readBytes(path);
  const std::size_t head = whole.find("SPACE=LPS");  // most of what may go wrong stands before
  std::mt19937 random(5);
  for (int round = 0; round < 500; ++round) {
    std::string bytes = whole;
    for (int change = 0; change < 3; ++change)
      bytes[random() % (change == 0 ? head : bytes.size())] = static_cast<char>(random());
    writeBytes(path, bytes);
    try {
      const TriangleSoup mesh = readMesh(path);
      for (const Triangle& t : mesh.triangles)
        for (int v : t) REQUIRE((v >= 0 && v < static_cast<int>(mesh.points.size())));
    } catch (const InputError&) {
      SUCCEED();
    }
  }
}
