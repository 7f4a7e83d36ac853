// What files of several segments say of each: names, colours and terms.

#include "core/io/formats/file_labels.h"

#include "core/io/dicom/cie_lab.h"
#include "core/io/dicom/dicom_segments.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/label_file.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Values 3 and 9, with nothing that is a default.
std::vector<ExportedObject> twoObjects() {
  return {{{"Left kidney", {17, 200, 33}, 3, "kidney"}, {}}, {{"Cyst \u00e9", {250, 5, 128}, 9, "cyst"}, {}}};
}

//! The halves of a grid.
Volume halves() {
  const Grid grid = obliqueGrid();
  void* buffer = nullptr;
  Volume labels = makeVolume(grid, VoxelType::uint8, &buffer);
  for (std::size_t i = 0, n = grid.voxelCount(); i < n; ++i)
    static_cast<std::uint8_t*>(buffer)[i] = i < n / 2 ? 3 : 9;
  return labels;
}

//! Of a patient, with a frame of reference.
DicomOrigin someOrigin() {
  DicomOrigin origin;
  origin.values = {{0x10, 0x10, "Doe^Jane"}, {0x10, 0x20, "PID0815"}};
  origin.studyUid = "1.2.3";
  origin.seriesUid = "1.2.3.4";
  origin.frameOfReference = "1.2.3.5";
  for (int k = 0; k < 4; ++k)
    origin.images.push_back({"1.2.840.10008.5.1.4.1.1.4", "1.2.3.4." + std::to_string(k + 1), 0});
  return origin;
}

void expectSaid(const FileLabel& said, const ObjectLabel& meant) {
  INFO(meant.name);
  CHECK(said.name == meant.name);
  CHECK(said.term == meant.term);
  REQUIRE(said.colour);
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(int{(*said.colour)[i]} - int{meant.colour[i]}) <= 1);
}

std::string slicerHeader(const std::string& keys) {
  return "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
         "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nspace origin: (0,0,0)\n" +
         keys + "\n" + std::string("\1\1\1\1\2\2\2\2");
}

//! A segment of a DICOM Segmentation.
DicomText segment(int number, const std::string& label, const std::string& scheme, const std::string& code) {
  DicomText type, text;
  type.add(8, 0x100, "SH", code);
  type.add(8, 0x102, "SH", scheme);
  type.add(8, 0x104, "LO", "whatever it means");
  text.addShort(0x62, 0x04, number);
  text.add(0x62, 0x05, "LO", label);
  text.addSequence(0x62, 0x0f, {type});
  return text;
}

std::string segmentation(const std::string& characters, const std::vector<DicomText>& segments) {
  DicomText text;
  text.add(2, 0x02, "UI", "1.2.840.10008.5.1.4.1.1.66.4");
  text.add(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  if (!characters.empty()) text.add(8, 0x05, "CS", characters);
  text.add(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.66.4");
  text.addSequence(0x62, 0x02, segments);
  return std::string(128, '\0') + "DICM" + text.bytes;
}

}  // namespace

TEST_CASE("a colour comes back from CIELab as it was", "[labels]") {
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    Colour colour{};
    for (std::uint8_t& part : colour) part = static_cast<std::uint8_t>(random());
    CHECK(dicom::colourOf(dicom::cieLab(colour)) == colour);
  }
  CHECK(dicom::colourOf(dicom::cieLab({0, 0, 0})) == Colour{0, 0, 0});
  CHECK(dicom::colourOf(dicom::cieLab({255, 255, 255})) == Colour{255, 255, 255});
  CHECK(dicom::cieLab({255, 255, 255})[0] == 65535);
}

TEST_CASE("what is written of two objects as segments is what is read of them", "[labels]") {
  const TemporaryFolder folder;
  const auto objects = twoObjects();
  writeSlicerSegmentation(halves(), objects, folder / "all.seg.nrrd");
  writeDicomSegmentation(halves(), objects, someOrigin(), {}, folder / "all.seg.dcm");
  const std::vector<NamedLabel> slicer = labelsIn(folder / "all.seg.nrrd"),
                                dicom = labelsIn(folder / "all.seg.dcm");
  REQUIRE(slicer.size() == 2);
  REQUIRE(dicom.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    expectSaid(slicer[i], objects[i].label);
    expectSaid(dicom[i], objects[i].label);
    CHECK(slicer[i].value == objects[i].label.value);
    CHECK(dicom[i].value == static_cast<int>(i) + 1);  // DICOM numbers segments from 1
  }
  expectSaid(labelIn(folder / "all.seg.nrrd", 9), objects[1].label);
  expectSaid(labelIn(folder / "all.seg.dcm", 1), objects[0].label);
  CHECK(labelIn(folder / "all.seg.nrrd", 5).name.empty());
  CHECK(labelIn(folder / "all.seg.nrrd", std::nullopt).name.empty());  // which of the two?
  fs::create_directory(folder / "series");
  fs::rename(folder / "all.seg.dcm", folder / "series/1.dcm");
  expectSaid(readDicomLabels(folder / "series").at(2), objects[1].label);
}

TEST_CASE(
    "of what 3D Slicer says a code that is not of our list gives no term and is kept, and the rest holds",
    "[labels]") {
  const TemporaryFolder folder;
  const std::string path = folder / "some.seg.nrrd";
  writeBytes(path, slicerHeader("Segment0_LabelValue:=1\nSegment0_Name:=one\nSegment0_Color:=0.5 1 0\n"
                                "Segment0_Tags:=Segmentation.Status:inprogress|TerminologyEntry:Context~"
                                "SCT^123037004^Anatomical Structure~SCT^10200004^Liver~^^~Regions~^^~^^|\n"
                                "Segment1_LabelValue:=2\nSegment1_Color:=red\n"
                                "Segment1_Tags:=TerminologyEntry:C~SCT^1^A~SRT^T-62000^Liver~^^~R~^^~^^|\n"));
  const FileLabels labels = readSlicerLabels(path);
  REQUIRE(labels.size() == 2);
  CHECK(labels.at(1).name == "one");
  CHECK(labels.at(1).colour == Colour{128, 255, 0});
  CHECK(labels.at(1).term == "liver");
  CHECK_FALSE(labels.at(2).hasLook());
  CHECK(labels.at(2).name.empty());
  const ObjectLabel kept = labelledAs(labels.at(2), {"as before", {1, 2, 3}, 4, "bone"});
  const Terminology liver{{"1", "SCT", "A"}, {{"T-62000", "SRT", "Liver"}, {}}, {}};
  CHECK(kept == ObjectLabel{"as before", {1, 2, 3}, 4, "tissue", {liver, {}}});
  FileLabel onlyTerm;
  onlyTerm.term = "liver";
  onlyTerm.name = "no | name";
  CHECK(labelledAs(onlyTerm, {}).colour == termFromName("liver")->colour);
  CHECK(labelledAs(onlyTerm, {}).name == ObjectLabel{}.name);
}

TEST_CASE("what a DICOM Segmentation of others says is read, in its character set", "[labels]") {
  const TemporaryFolder folder;
  const std::string path = folder / "s.dcm";
  const std::vector<DicomText> segments{segment(1, "Ni\xe8re", "SCT", "64033007"),
                                        segment(7, "Rest", "SRT", "T-62000")};
  writeBytes(path, segmentation("ISO_IR 100", segments));
  const FileLabels labels = readDicomLabels(path);
  REQUIRE(labels.size() == 2);
  CHECK(labels.at(1).name == "Ni\u00e8re");
  CHECK(labels.at(1).term == "kidney");
  CHECK_FALSE(labels.at(1).colour);
  CHECK(labels.at(7).name == "Rest");
  CHECK(labels.at(7).term.empty());
}

TEST_CASE("a file that is no segmentation, cut off or damaged says nothing or less, and nothing breaks",
          "[labels]") {
  const TemporaryFolder folder;
  CHECK(labelIn(folder / "none.seg.nrrd", 1).name.empty());
  CHECK(labelIn(folder.path(), 1).name.empty());
  writeBytes(folder / "image.dcm", dicomBytes(evenStack(1)[0], "1.2"));
  CHECK(readDicomLabels(folder / "image.dcm").empty());
  writeSlicerSegmentation(halves(), twoObjects(), folder / "all.seg.nrrd");
  writeDicomSegmentation(halves(), twoObjects(), someOrigin(), {}, folder / "all.seg.dcm");
  std::mt19937 random(9);
  for (const std::string name : {"all.seg.nrrd", "all.seg.dcm"}) {
    const std::string whole = readBytes(folder / name), path = folder / ("bad" + name);
    for (int round = 0; round < 300; ++round) {
      std::string bytes = whole.substr(0, round % 3 == 0 ? random() % whole.size() : whole.size());
      for (int change = 0; change < 4 && !bytes.empty(); ++change)
        bytes[random() % bytes.size()] = static_cast<char>(random());
      writeBytes(path, bytes);
      CHECK_NOTHROW(labelIn(path, 1));
    }
  }
}

TEST_CASE("what is made of a DICOM Segmentation belongs to its patient and study, and refers to it",
          "[labels]") {
  const TemporaryFolder folder;
  writeDicomSegmentation(halves(), twoObjects(), someOrigin(), {}, folder / "all.seg.dcm");
  const LoadedVolume loaded = loadVolume(folder / "all.seg.dcm");
  REQUIRE(loaded.info.dicom);
  CHECK(dicomFault(loaded.info.dicom.get()).empty());
  REQUIRE(loaded.info.dicom->images.size() == 1);
  const std::string instance = loaded.info.dicom->images[0].instance;
  writeDicomStl({{{}, sphere(Vec3(0, 0, 0), 1, 1)}}, *loaded.info.dicom, {}, folder / "m.stl.dcm");
  writeDicomSegmentation(loaded.volume, {{{"One", {1, 2, 3}, 1, "tissue"}, {}}}, *loaded.info.dicom, {},
                         folder / "m.seg.dcm");
  for (const char* name : {"m.stl.dcm", "m.seg.dcm"}) {
    INFO(name);
    const std::string bytes = readBytes(folder / name);
    for (const std::string text : {"Doe^Jane", "PID0815", "1.2.3.5", instance.c_str()})
      CHECK(bytes.find(text) != std::string::npos);
  }
  CHECK(readMesh(folder / "m.stl.dcm").triangles.size() == 32);
  CHECK(readVolume(folder / "m.seg.dcm").grid.size[0] == loaded.volume.grid.size[0]);
}
