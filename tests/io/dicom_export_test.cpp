// DICOM files made from a series: segmentations and encapsulated STL.

#include <sys/wait.h>

#include <cstdlib>
#include <random>
#include <set>

#include "core/collision/certify.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/meshes/mesh_io.h"
#include "tests/io/dicom_test_support.h"
#include "tests/support/mesh_zoo.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! What a patient's series says besides its images.
MoreElements patient(const std::string& name = "Doe^Jane") {
  return {{0x00080005, {"CS", "ISO_IR 100"}}, {0x00080020, {"DA", "19991231"}},
          {0x00080030, {"TM", "235959"}},     {0x00080050, {"SH", "ACC4711"}},
          {0x00080090, {"PN", "House^Greg"}}, {0x00100010, {"PN", name}},
          {0x00100020, {"LO", "PID0815"}},    {0x00100030, {"DA", "19700203"}},
          {0x00100040, {"CS", "F"}},          {0x00200010, {"SH", "STUDY99"}}};
}

//! An oblique series of frames whose pixels do not fill whole bytes, and what is known of it.
struct Source {
  TemporaryFolder folder;
  LoadedVolume loaded;

  explicit Source(int slices = 9, const MoreElements& more = patient(), int columns = 7, int rows = 5) {
    std::vector<Slice> stack = evenStack(slices);
    for (Slice& s : stack) {
      s.columns = columns;
      s.rows = rows;
      s.more = more;
    }
    writeSeries(folder / "series", stack);
    loaded = loadVolume(folder / "series");
  }
  const Grid& grid() const { return loaded.volume.grid; }
  const DicomOrigin& origin() const { return *loaded.info.dicom; }
};

std::vector<ExportedObject> twoOrgans(const std::string& name = "Left kidney") {
  ObjectLabel first, second;
  first.name = name;
  first.value = 3;
  first.term = "kidney";
  second.name = "Cyst";
  second.value = 9;
  second.term = "cyst";
  return {{first, {}}, {second, {}}};
}

//! Values 3 and 9 at random, in slices of their own each and in some of both.
Volume randomLabels(const Grid& grid) {
  void* buffer = nullptr;
  Volume labels = makeVolume(grid, VoxelType::uint8, &buffer);
  std::mt19937 random(7);
  const int perSlice = grid.size[0] * grid.size[1];
  for (int k = 1; k < grid.size[2]; ++k)
    for (int i = 0; i < perSlice; ++i) {
      const auto drawn = random() % 3;
      const bool first = k<grid.size[2] - 2, second = k> 3;
      static_cast<std::uint8_t*>(buffer)[k * perSlice + i] = drawn == 1 && first    ? 3
                                                             : drawn == 2 && second ? 9
                                                                                    : 0;
    }
  return labels;
}

std::string element(unsigned group, unsigned number, const std::string& vr, const std::string& value) {
  DicomText text;
  text.add(group, number, vr, value);
  return text.bytes;
}

bool holds(const std::string& bytes, const std::string& part) {
  return bytes.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a segmentation that is read back holds the same voxels at the same places") {
  const Source source;
  const auto objects = twoOrgans();
  const Volume labels = randomLabels(source.grid());
  const std::string path = source.folder / "out.seg.dcm";
  writeDicomSegmentation(labels, objects, source.origin(), {}, path);
  const Volume back = readVolume(path);
  // Slice 0 is empty and not written.
  const Grid &grid = source.grid(), &small = back.grid;
  REQUIRE(small.size == std::array{7, 5, 8});
  CHECK((small.spacing - grid.spacing).norm() < 1e-6);
  const auto* written = labels.data<std::uint8_t>();
  const auto* read = back.data<std::uint8_t>();
  for (int k = 0; k < small.size[2]; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 7; ++i) {
        const Vec3 at = grid.toIndex(small.toWorld(Vec3(i, j, k)));
        REQUIRE((at - Vec3(i, j, k + 1)).norm() < 1e-4);
        const int label = written[(k + 1) * 35 + j * 7 + i];
        REQUIRE(read[k * 35 + j * 7 + i] == (label == 3 ? 1 : label == 9 ? 2 : 0));
      }
}

TEST_CASE("segments are numbered in the order of the label values, without gaps") {
  const Source source;
  auto objects = twoOrgans();
  std::swap(objects[0].label.value, objects[1].label.value);
  const Volume labels = randomLabels(source.grid());
  const std::string path = source.folder / "out.seg.dcm";
  writeDicomSegmentation(labels, objects, source.origin(), {}, path);
  const std::string bytes = readBytes(path);
  const auto cyst = bytes.find("Cyst"), kidney = bytes.find("Left kidney");
  REQUIRE(cyst != std::string::npos);
  REQUIRE(kidney != std::string::npos);
  CHECK(cyst < kidney);
  const Volume back = readVolume(path);
  const auto* written = labels.data<std::uint8_t>();
  const auto* read = back.data<std::uint8_t>();
  for (std::size_t i = 0, n = back.grid.voxelCount(); i < n; ++i)  // slice 0 is empty and not written
    REQUIRE(read[i] == (written[i + 35] == 3 ? 1 : written[i + 35] == 9 ? 2 : 0));
}

TEST_CASE("a segmentation of an object in one slice is read back, with an empty slice behind") {
  const Source source;
  const Grid& grid = source.grid();
  void* buffer = nullptr;
  const Volume labels = makeVolume(grid, VoxelType::uint8, &buffer);
  auto* written = static_cast<std::uint8_t*>(buffer);
  std::fill_n(written, grid.voxelCount(), std::uint8_t{0});
  for (const int v : {4 * 35 + 9, 4 * 35 + 10, 4 * 35 + 16}) written[v] = 3;
  const std::string path = source.folder / "out.seg.dcm";
  writeDicomSegmentation(labels, {twoOrgans()[0]}, source.origin(), {}, path);
  const auto expectSlab = [&] {
    const Volume back = readVolume(path);
    REQUIRE(back.grid.size == std::array{7, 5, 2});
    CHECK((back.grid.spacing - grid.spacing).norm() < 1e-6);
    CHECK((grid.toIndex(back.grid.toWorld(Vec3(0, 0, 0))) - Vec3(0, 0, 4)).norm() < 1e-4);
    const auto* read = back.data<std::uint8_t>();
    for (int v = 0; v < 70; ++v) CHECK(read[v] == (v < 35 && written[4 * 35 + v] == 3 ? 1 : 0));
  };
  expectSlab();
  // Not all state the distance of slices where there is one; the slice is as thick as they say.
  std::string bytes = readBytes(path);
  const std::size_t distance = bytes.find(std::string("\x18\0\x88\0DS", 6));
  REQUIRE(distance != std::string::npos);
  bytes[distance + 2] = '\x89';  // an element that nobody knows
  writeBytes(path, bytes);
  expectSlab();
}

TEST_CASE(
    "a segmentation that leaves slices out and does not state their distance says what is taken for it") {
  const Source source;
  const std::string path = source.folder / "out.seg.dcm";
  const auto inSlices = [&](int first, int second) {
    void* buffer = nullptr;
    const Volume labels = makeVolume(source.grid(), VoxelType::uint8, &buffer);
    static_cast<std::uint8_t*>(buffer)[first * 35 + 8] = 3;
    static_cast<std::uint8_t*>(buffer)[second * 35 + 9] = 9;
    writeDicomSegmentation(labels, twoOrgans(), source.origin(), {}, path);
    std::string bytes = readBytes(path);
    const std::string stated("\x18\0\x88\0DS", 6);
    REQUIRE(bytes.find(stated) != std::string::npos);
    bytes[bytes.find(stated) + 2] = '\x87';  // the strength of the magnet
    return bytes;
  };
  const auto isGuessed = [](const VolumeInfo& info) {
    return std::any_of(info.warnings.begin(), info.warnings.end(),
                       [](const Finding& w) { return w.kind == FindingKind::sliceDistanceGuessed; });
  };
  const double thick = source.grid().spacing.z();
  const std::string apart = inSlices(1, 4);
  CHECK_FALSE(isGuessed(inspectVolume(path)));  // it is stated
  CHECK(inspectVolume(path).grid.size[2] == 4);
  writeBytes(path, apart);
  const VolumeInfo info = inspectVolume(path);
  CHECK(info.grid.spacing.z() == Approx(3 * thick));
  REQUIRE(isGuessed(info));
  CHECK_THAT(sentence(info.warnings), Contains("The header does not state the distance of the slices"));
  writeBytes(path, inSlices(1, 2));
  CHECK(inspectVolume(path).grid.spacing.z() == Approx(thick));
  CHECK_FALSE(isGuessed(inspectVolume(path)));
}

TEST_CASE("a segmentation belongs to patient and study of its series and refers to its images") {
  const Source source;
  DicomContent content;
  content.creator = "Miller^Ann";
  content.description = "planning";
  writeDicomSegmentation(randomLabels(source.grid()), twoOrgans(), source.origin(), content,
                         source.folder / "out.seg.dcm");
  const std::string bytes = readBytes(source.folder / "out.seg.dcm");
  for (const auto& [tag, value] : patient()) {
    INFO(std::hex << tag);
    CHECK(holds(bytes, element(tag >> 16, tag & 0xffff, value.first, value.second)));
  }
  CHECK(holds(bytes, element(0x20, 0x0d, "UI", "1.2.3")));
  CHECK(holds(bytes, element(0x70, 0x84, "PN", "Miller^Ann")));
  CHECK(holds(bytes, element(0x70, 0x81, "LO", "planning")));
  CHECK(holds(bytes, element(0x62, 0x05, "LO", "Left kidney")));
  CHECK(holds(bytes, element(0x08, 0x100, "SH", "64033007")));
  // Bits of a frame of one bit; DCMTK's own HighBit is 1.
  CHECK(holds(bytes, std::string("\x28\0\x02\x01US\x02\0\0\0", 10)));
  // Every image in the list of the series, and those of slices 1 to 8 with their frames.
  REQUIRE(source.origin().images.size() == 9);
  for (std::size_t i = 0; i < 9; ++i) {
    const std::string reference = element(0x08, 0x1155, "UI", source.origin().images[i].instance);
    std::size_t count = 0;
    for (auto at = bytes.find(reference); at != std::string::npos; at = bytes.find(reference, at + 1))
      ++count;
    CHECK(count == std::size_t{1} + (i >= 1 && i < 7) + (i > 3));
  }
}

TEST_CASE("every segmentation and its series have UIDs of their own") {
  const Source source;
  std::set<std::string> uids;
  for (const char* name : {"a.seg.dcm", "b.seg.dcm"}) {
    writeDicomSegmentation(randomLabels(source.grid()), twoOrgans(), source.origin(), {},
                           source.folder / name);
    const VolumeInfo info = inspectVolume(source.folder / name);
    REQUIRE(info.series.size() == 1);
    uids.insert(info.series[0].uid);
  }
  CHECK(uids.size() == 2);
  for (const std::string& uid : uids) {
    CHECK(uid.rfind("2.25.", 0) == 0);
    CHECK(uid.size() <= 64);
    CHECK(uid[5] != '0');
  }
}

TEST_CASE("a name beyond ASCII turns the patient's values to UTF-8 with it") {
  const Source source(9, patient("M\xfcller^J\xf6rg"));
  writeDicomSegmentation(randomLabels(source.grid()), twoOrgans("Ni\u00e8re"), source.origin(), {},
                         source.folder / "utf8.seg.dcm");
  const std::string bytes = readBytes(source.folder / "utf8.seg.dcm");
  CHECK(holds(bytes, element(0x08, 0x05, "CS", "ISO_IR 192")));
  CHECK(holds(bytes, element(0x10, 0x10, "PN", "M\u00fcller^J\u00f6rg")));
  CHECK(holds(bytes, element(0x62, 0x05, "LO", "Ni\u00e8re")));
  writeDicomSegmentation(randomLabels(source.grid()), twoOrgans("Kidney"), source.origin(), {},
                         source.folder / "latin.seg.dcm");
  CHECK(holds(readBytes(source.folder / "latin.seg.dcm"), element(0x10, 0x10, "PN", "M\xfcller^J\xf6rg")));
}

TEST_CASE("a name beyond ASCII without a character set of the series is refused before the growth") {
  MoreElements values = patient("M\xfcller^J\xf6rg");
  values.erase(0x00080005);
  const Source source(9, values);
  const std::string path = source.folder / "out.seg.dcm";
  CHECK_THROWS_AS(requireDicomNames({"Ni\u00e8re"}, source.origin(), {}, path), OutputError);
  CHECK_NOTHROW(requireDicomNames({"Kidney"}, source.origin(), {}, path));
  CHECK_NOTHROW(requireDicomNames({"Ni\u00e8re"}, source.origin(), {.anonymous = true}, path));
  // Before the seed, which lies outside of the volume, is looked at.
  const std::string said = source.folder / "said";
  const std::string command = std::string(HANDLEBODY_CLI) + " segment '" + (source.folder / "series") +
                              "' --seed 9000,9000,9000,1 --object-name 'Ni\u00e8re' --quiet -o '" + path +
                              "' 2> '" + said + "'";
  const int status = std::system(command.c_str());
  CHECK(WEXITSTATUS(status) == 2);
  CHECK_THAT(readBytes(said), Contains("character set"));
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("a segmentation of images that were compressed with loss says so, an anonymous one too") {
  MoreElements lossy = patient();
  lossy[0x00282110] = {"CS", "01"};
  lossy[0x00282112] = {"DS", "12.5"};
  const Source source(9, lossy);
  const std::string path = source.folder / "lossy.seg.dcm";
  for (const bool anonymous : {false, true}) {
    DicomContent content;
    content.anonymous = anonymous;
    writeDicomSegmentation(randomLabels(source.grid()), twoOrgans(), source.origin(), content, path);
    const std::string bytes = readBytes(path);
    CHECK(holds(bytes, element(0x28, 0x2110, "CS", "01")));
    CHECK(holds(bytes, element(0x28, 0x2112, "DS", "12.5")));
    CHECK(holds(bytes, "PID0815") != anonymous);
  }
}

TEST_CASE("a series whose UIDs were blanked gives a segmentation without references") {
  const Source source;
  DicomOrigin blank = source.origin();
  blank.studyUid.clear();
  for (DicomImage& image : blank.images) image.instance.clear();
  const std::string path = source.folder / "blank.seg.dcm";
  writeDicomSegmentation(randomLabels(source.grid()), twoOrgans(), blank, {}, path);
  CHECK(readVolume(path).grid.size == std::array{7, 5, 8});
  CHECK_FALSE(holds(readBytes(path), std::string("\x08\0\x55\x11", 4)));
}

TEST_CASE("a text that DICOM cannot hold is told with what is wrong with it") {
  CHECK_FALSE(dicomTextFinding("Roe^Ann").any());
  CHECK(sentence(dicomTextFinding("A\\B")) == "'A\\B' holds a control character or a backslash");
  CHECK(dicomTextFinding(std::string(65, 'x')).kind == FindingKind::dicomTextTooLong);
}

TEST_CASE("no DICOM file is made for a volume that does not lie in a patient's series") {
  CHECK_THAT(dicomFault(nullptr), Contains("was not read from DICOM"));
  std::vector<Slice> nowhere = evenStack(4);
  for (Slice& s : nowhere) s.placed = false;
  const TemporaryFolder folder;
  writeSeries(folder / "nowhere", nowhere);
  CHECK_THAT(dicomFault(loadVolume(folder / "nowhere").info.dicom.get()), Contains("where its slices lie"));
  const Source source;
  VolumeSelection given;
  given.spacing = Vec3(1, 1, 1);
  const auto other = loadVolume(source.folder / "series", given);
  CHECK_THAT(dicomFault(other.info.dicom.get()), Contains("given by the user"));
  CHECK_THROWS_AS(writeDicomSegmentation(randomLabels(other.volume.grid), twoOrgans(), *other.info.dicom, {},
                                         folder / "x.seg.dcm"),
                  UsageError);
  CHECK(dicomFault(source.loaded.info.dicom.get()).empty());
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("slices that were resampled are referred to as a series, not one by one") {
  std::vector<Slice> uneven = evenStack(9);
  uneven[4].position += 1.1 * uneven[4].direction.col(2);
  const TemporaryFolder folder;
  writeSeries(folder / "uneven", uneven);
  const auto loaded = loadVolume(folder / "uneven");
  REQUIRE_FALSE(loaded.info.dicom->straight);
  const Volume labels = randomLabels(loaded.volume.grid);
  writeDicomSegmentation(labels, twoOrgans(), *loaded.info.dicom, {}, folder / "u.seg.dcm");
  const std::string bytes = readBytes(folder / "u.seg.dcm");
  const std::string reference = element(0x08, 0x1155, "UI", loaded.info.dicom->images[3].instance);
  CHECK(bytes.find(reference) != std::string::npos);
  CHECK(bytes.find(reference) == bytes.rfind(reference));
}

TEST_CASE("the images of another time point are not referred to") {
  std::vector<Slice> both = evenStack(6);
  for (int k = 0; k < 6; ++k) {
    both.push_back(both[k]);
    both.back().value = static_cast<std::int16_t>(50 + k);
    both.back().instance = "1.2.99." + std::to_string(k + 1);
  }
  for (std::size_t i = 0; i < both.size(); ++i) both[i].number = static_cast<int>(i);
  const TemporaryFolder folder;
  writeSeries(folder / "both", both);
  const auto first = loadVolume(folder / "both", {.frame = 0}),
             second = loadVolume(folder / "both", {.frame = 1});
  REQUIRE(second.info.frames == 2);
  REQUIRE(first.info.dicom->images.size() == 6);
  REQUIRE(second.info.dicom->images.size() == 6);
  for (int k = 0; k < 6; ++k) {
    const auto i = static_cast<std::size_t>(k);
    CHECK(second.info.dicom->images[i].instance == "1.2.99." + std::to_string(k + 1));
    CHECK(first.info.dicom->images[i].instance.rfind("1.2.99.", 0) == std::string::npos);
  }
}

TEST_CASE("an object without a voxel is refused, and nothing is left behind") {
  const Source source;
  void* buffer = nullptr;
  const Volume empty = makeVolume(source.grid(), VoxelType::uint8, &buffer);
  CHECK_THROWS_WITH(
      writeDicomSegmentation(empty, twoOrgans(), source.origin(), {}, source.folder / "e.seg.dcm"),
      Contains("Left kidney holds the centre of no voxel"));
  CHECK_THROWS_AS(writeDicomSegmentation(randomLabels(source.grid()), twoOrgans(), source.origin(), {},
                                         source.folder / "no/such/folder.seg.dcm"),
                  OutputError);
  CHECK(source.folder.fileCount() == 1);
}

TEST_CASE("damaged segmentations are refused in one sentence") {
  const Source source;
  const std::string path = source.folder / "out.seg.dcm";
  writeDicomSegmentation(randomLabels(source.grid()), twoOrgans(), source.origin(), {}, path);
  const std::string bytes = readBytes(path);
  const std::string bad = source.folder / "bad.dcm";
  for (std::size_t cut = 1; cut < 12; ++cut) {
    writeBytes(bad, bytes.substr(0, bytes.size() * cut / 12));
    expectInputError(bad, "", true);
  }
  writeBytes(bad, bytes.substr(0, bytes.size() - 8));
  expectInputError(bad, "truncated", true);
  const auto patched = [&](const std::string& from, const std::string& to) {
    std::string other = bytes;
    const auto at = other.find(from);
    REQUIRE(at != std::string::npos);
    writeBytes(bad, other.replace(at, from.size(), to));
  };
  DicomText many, more, bits, eight;
  many.addShort(0x28, 0x10, 5);
  more.addShort(0x28, 0x10, 500);
  patched(many.bytes, more.bytes);
  expectInputError(bad, "less pixels", true);
  bits.addShort(0x28, 0x100, 1);
  eight.addShort(0x28, 0x100, 8);
  patched(bits.bytes, eight.bytes);
  expectInputError(bad, "not binary", true);
  patched(std::string("\x62\0\x0b\0US\x02\0\x01\0", 10), std::string("\x62\0\x0b\0US\x02\0\0\0", 10));
  expectInputError(bad, "which segment", true);
}

TEST_CASE("an encapsulated STL holds the meshes as they are, for the patient of the series") {
  const Source source;
  auto objects = twoOrgans();
  objects[0].mesh = zoo::sphere(2);
  objects[1].mesh = zoo::moved(zoo::sphere(2), Vec3(5, 0, 0));
  const std::string path = source.folder / "out.stl.dcm";
  writeDicomStl(objects, source.origin(), {}, path);
  const std::string bytes = readBytes(path);
  CHECK(holds(bytes, element(0x08, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.104.3")));
  CHECK(holds(bytes, element(0x10, 0x10, "PN", "Doe^Jane")));
  CHECK(holds(bytes, std::string("\x08\0\x15\x11SQ", 6)));  // the series it refers to
  CHECK(holds(bytes, element(0x42, 0x12, "LO", "model/stl")));
  CHECK(holds(bytes, element(0x42, 0x10, "ST", "Left kidney, Cyst")));
  const auto start = bytes.find("SPACE=LPS");
  REQUIRE(start != std::string::npos);
  const std::size_t length = 84 + 50 * 2 * objects[0].mesh.triangles.size();
  writeBytes(source.folder / "inside.stl", bytes.substr(start, length));
  const TriangleSoup inside = readMesh(source.folder / "inside.stl");
  CHECK(inside.triangles.size() == 2 * objects[0].mesh.triangles.size());
  CHECK(certify(inside).components == 2);
  CHECK(certify(inside).volume ==
        Approx(certify(objects[0].mesh).volume + certify(objects[1].mesh).volume).epsilon(1e-5));
}
