// DICOM files known by what is in them, not by their names.

#include "core/io/dicom/dicom_class.h"

#include <sys/stat.h>

#include "core/io/dicom/dicom_segments.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/meshes/mesh_io.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

constexpr const char *kImplicit = "1.2.840.10008.1.2", *kExplicit = "1.2.840.10008.1.2.1",
                     *kDeflated = "1.2.840.10008.1.2.1.99";
//! As media of a PACS name files, and as programs do that know better.
const std::vector<std::string> kNames{"IM0001.dcm", "IM0001", "1.2.3.4", "a.stl.dcm.bak"};

std::string segmentation() {
  const TemporaryFolder folder;
  void* buffer = nullptr;
  const Volume labels = makeVolume(obliqueGrid(), VoxelType::uint8, &buffer);
  std::memset(buffer, 1, labels.grid.voxelCount());
  DicomOrigin origin;
  origin.straight = false;  // no series stands behind it
  writeDicomSegmentation(labels, {{{"Cyst", {1, 2, 3}, 1, "cyst"}, {}}}, origin, {}, folder / "s.seg.dcm");
  return readBytes(folder / "s.seg.dcm");
}

TriangleSoup ball() { return sphere(Vec3(-101.5, 57.25, 181), 12.5, 2); }

std::string encapsulated() {
  const TemporaryFolder folder;
  writeDicomStl({{{}, ball()}}, {}, {}, folder / "m.stl.dcm");
  return readBytes(folder / "m.stl.dcm");
}

//! What stands before the data set.
DicomText meta(const std::string& mediaClass, const std::string& syntax) {
  DicomText text;
  if (!mediaClass.empty()) text.add(2, 0x02, "UI", mediaClass);
  text.add(2, 0x10, "UI", syntax);
  return text;
}

std::string classOf(const std::string& afterPreamble) {
  const TemporaryFolder folder;
  writeBytes(folder / "f", std::string(128, '\0') + "DICM" + afterPreamble);
  return dicomClassOf(folder / "f");
}

}  // namespace

TEST_CASE("a DICOM Segmentation is known by what is in it, whatever its name", "[encapsulated]") {
  const TemporaryFolder folder;
  const std::string bytes = segmentation();
  for (const std::string& name : kNames) {
    INFO(name);
    writeBytes(folder / name, bytes);
    CHECK(isDicomSegmentationFile(folder / name));
    CHECK_FALSE(isMeshInputPath(folder / name));
    CHECK(readDicomLabels(folder / name).at(1).name == "Cyst");
    CHECK_THROWS_AS(readMesh(folder / name), InputError);
  }
  CHECK_FALSE(isDicomSegmentationFile(folder.path()));  // of several
}

TEST_CASE("an encapsulated STL is known by what is in it, whatever its name, and is read", "[encapsulated]") {
  const TemporaryFolder folder;
  const std::string bytes = encapsulated();
  for (const std::string& name : kNames) {
    INFO(name);
    CHECK_FALSE(isMeshInputPath(folder / name));  // not yet
    writeBytes(folder / name, bytes);
    CHECK(isMeshInputPath(folder / name));
    CHECK_FALSE(isMeshPath(folder / name));
    CHECK_FALSE(isDicomSegmentationFile(folder / name));
    CHECK(signedVolume(readMesh(folder / name)) == Approx(signedVolume(ball())).epsilon(1e-5));
  }
  CHECK(isMeshInputPath(folder / "none.stl.dcm"));
  CHECK_FALSE(isMeshInputPath(folder.path()));
}

TEST_CASE("what is another file, or none, has no class, and nothing waits for it", "[encapsulated]") {
  const TemporaryFolder folder;
  Slice image = evenStack(1)[0];
  image.more[0x00081030] = {"LO", std::string(kSegmentationClass) + " " + kEncapsulatedStlClass};
  writeBytes(folder / "image", dicomBytes(image, "1.2"));
  writeBytes(folder / "empty", {});
  writeBytes(folder / "text", std::string(200, ' ') + kSegmentationClass);
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK(dicomClassOf(folder / "image") == "1.2.840.10008.5.1.4.1.1.4");
  for (const char* name : {"image", "empty", "text", "pipe", "none", "none/none", "."}) {
    INFO(name);
    CHECK_FALSE(isDicomSegmentationFile(folder / name));
    CHECK_FALSE(isMeshInputPath(folder / name));
  }
  CHECK(dicomClassOf({}).empty());
}

TEST_CASE("the class is that of the data set, and what stands before it where that cannot be read",
          "[encapsulated]") {
  const std::string image = "1.2.840.10008.5.1.4.1.1.4";
  DicomText data;
  data.add(8, 0x05, "CS", "ISO_IR 192");
  data.add(8, 0x16, "UI", kSegmentationClass);
  const std::string implicit =
      std::string("\x08\0\x16\0\x1c\0\0\0", 8) + kSegmentationClass + std::string(1, '\0');
  CHECK(classOf(meta({}, kExplicit).bytes + data.bytes) == kSegmentationClass);
  CHECK(classOf(meta(image, kExplicit).bytes + data.bytes) == kSegmentationClass);
  CHECK(classOf(meta(image, kImplicit).bytes + implicit) == kSegmentationClass);
  CHECK(classOf(meta(image, kDeflated).bytes + data.bytes) == image);
  CHECK(classOf(meta(image, kExplicit).bytes) == image);
  DicomText longer = meta(kSegmentationClass, kExplicit);
  longer.add(2, 0x102, "OB", std::string(10000, 'x'));  // the data set lies beyond what is looked at
  CHECK(classOf(longer.bytes + data.bytes) == kSegmentationClass);
  CHECK(classOf({}).empty());
}

TEST_CASE("a beginning that is cut off or damaged is another class or none, and nothing breaks",
          "[encapsulated]") {
  const TemporaryFolder folder;
  const std::string whole = encapsulated(), path = folder / "bad";
  for (std::size_t n = 0; n < 800; n += 7) {
    writeBytes(path, whole.substr(0, n));
    const std::string found = dicomClassOf(path);
    CHECK((found.empty() || found == kEncapsulatedStlClass));
    if (isMeshInputPath(path)) CHECK_THROWS_AS(readMesh(path), InputError);
  }
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole.substr(0, 1024);
    for (int change = 0; change < 8; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
    writeBytes(path, bytes);
    CHECK_NOTHROW(dicomClassOf(path));
  }
}
