// What the file of a segment says that is not in our list: codes of any scheme, and how it was made.

#include "core/errors.h"
#include "core/io/dicom/dicom_segments.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "core/io/report/session.h"
#include "core/io/report/start_surface.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/mesh_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Of a retired scheme, with all that there may be one of.
Terminology leftKidney() {
  return {{"T-D000A", "SRT", "Anatomical Structure"},
          {{"T-71000", "SRT", "Kidney"}, {{"G-A101", "SRT", "Left"}}},
          {{"818983003", "SCT", "Abdomen"}, {{"255561001", "SCT", "Middle"}}}};
}

//! Of the plain type, without the rest.
Terminology someFat() {
  return {{"85756007", "SCT", "Tissue"}, {{"256674009", "SCT", "Fat \u00e9"}, {}}, {}};
}

std::vector<ExportedObject> threeObjects() {
  const Colour colour{17, 200, 33};
  return {
      {{"One", colour, 1, "tissue", {leftKidney(), SegmentAlgorithm{AlgorithmType::automatic, "Net 3"}}}, {}},
      {{"Two", colour, 2, "tissue", {someFat(), SegmentAlgorithm{AlgorithmType::manual, ""}}}, {}},
      {{"Three", colour, 3, "liver"}, {}}};
}

Volume thirds() {
  const Grid grid = obliqueGrid();
  void* buffer = nullptr;
  Volume labels = makeVolume(grid, VoxelType::uint8, &buffer);
  for (std::size_t i = 0, n = grid.voxelCount(); i < n; ++i)
    static_cast<std::uint8_t*>(buffer)[i] = static_cast<std::uint8_t>(1 + i * 3 / n);
  return labels;
}

DicomOrigin noSeries() {
  DicomOrigin origin;
  origin.straight = false;
  return origin;
}

std::string segmentElement(unsigned group, unsigned number, const std::string& vr, const std::string& value) {
  DicomText text;
  text.add(group, number, vr, value);
  return text.bytes;
}

bool holdsPart(const std::string& bytes, const std::string& part) {
  return bytes.find(part) != std::string::npos;
}

DicomText coded(const CodedTerm& code, const std::vector<DicomText>& modifiers = {}, unsigned group = 0,
                unsigned number = 0) {
  DicomText text;
  text.add(8, 0x100, "SH", code.value);
  text.add(8, 0x102, "SH", code.scheme);
  text.add(8, 0x104, "LO", code.meaning);
  if (!modifiers.empty()) text.addSequence(group, number, modifiers);
  return text;
}

//! A file of others with one segment.
std::string segmentation(const DicomText& segment, const std::string& characters = {}) {
  DicomText text;
  text.add(2, 0x02, "UI", "1.2.840.10008.5.1.4.1.1.66.4");
  text.add(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  if (!characters.empty()) text.add(8, 0x05, "CS", characters);
  text.add(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.66.4");
  text.addSequence(0x62, 0x02, {segment});
  return std::string(128, '\0') + "DICM" + text.bytes;
}

DicomText segmentOf(const Terminology& t, const std::string& type, const std::string& name) {
  DicomText text;
  std::vector<DicomText> left, where;
  for (const CodedTerm& code : t.type.modifiers) left.push_back(coded(code));
  for (const CodedTerm& code : t.region.modifiers) where.push_back(coded(code));
  text.addSequence(8, 0x2218, {coded(t.region.term, where, 8, 0x2220)});
  text.addSequence(0x62, 0x03, {coded(t.category)});
  text.addShort(0x62, 0x04, 1);
  text.add(0x62, 0x05, "LO", "One");
  text.add(0x62, 0x08, "CS", type);
  text.add(0x62, 0x09, "LO", name);
  text.addSequence(0x62, 0x0f, {coded(t.type.term, left, 0x62, 0x11)});
  return text;
}

//! What is read of the segment.
FileLabel readOf(const Terminology& t, const std::string& type = "AUTOMATIC", const std::string& name = "Net",
                 const std::string& characters = {}) {
  const TemporaryFolder folder;
  writeBytes(folder / "s.dcm", segmentation(segmentOf(t, type, name), characters));
  return readDicomLabels(folder / "s.dcm").at(1);
}

Session someSession(const std::string& volume) {
  Session session;
  session.volume.path = volume;
  session.seeds.push_back({Vec3(1, 2, 3), {}, {}});
  session.label = {"One", {1, 2, 3}, 4, "liver"};
  return session;
}

}  // namespace

TEST_CASE("codes, modifiers, region and algorithm of a DICOM Segmentation of others are read as they stand",
          "[labels]") {
  Terminology two = leftKidney();
  two.type.modifiers.push_back({"G-A103", "SRT", "Second"});
  const FileLabel said = readOf(two, "AUTOMATIC", "Net 3");
  CHECK(said.source.terminology == two);
  CHECK(said.term.empty());
  CHECK_FALSE(said.hasLook());
  CHECK(said.source.algorithm == SegmentAlgorithm{AlgorithmType::automatic, "Net 3"});
  Terminology latin = someFat();
  latin.type.term.meaning = "Fat \xe9";
  CHECK(readOf(latin, "MANUAL", "", "ISO_IR 100").source.terminology == someFat());
}

TEST_CASE("codes and algorithms of others come back from both kinds of segmentation that are written",
          "[labels]") {
  const TemporaryFolder folder;
  const auto objects = threeObjects();
  writeDicomSegmentation(thirds(), objects, noSeries(), {}, folder / "a.seg.dcm");
  writeSlicerSegmentation(thirds(), objects, folder / "a.seg.nrrd");
  for (const FileLabels& said :
       {readDicomLabels(folder / "a.seg.dcm"), readSlicerLabels(folder / "a.seg.nrrd")}) {
    REQUIRE(said.size() == 3);
    CHECK(said.at(1).source.terminology == leftKidney());
    CHECK(said.at(1).source.algorithm == SegmentAlgorithm{AlgorithmType::automatic, "Net 3, Handlebody"});
    CHECK(said.at(2).source.terminology == someFat());
    CHECK(said.at(2).source.algorithm == SegmentAlgorithm{AlgorithmType::manual, ""});
    CHECK(said.at(3).term == "liver");
    CHECK_FALSE(said.at(3).source.terminology);
  }
  const std::string dicom = readBytes(folder / "a.seg.dcm"), slicer = readBytes(folder / "a.seg.nrrd");
  // One name each of the automatic one and of ours; a manual one may have none.
  CHECK(holdsPart(dicom, segmentElement(0x62, 0x08, "CS", "MANUAL")));
  CHECK(holdsPart(dicom, segmentElement(0x62, 0x09, "LO", "Net 3, Handlebody")));
  const std::string name("\x62\0\x09\0LO", 6);
  CHECK(dicom.find(name, dicom.rfind(name) - 1) == dicom.rfind(name));
  CHECK(dicom.find(name, dicom.find(name) + 1) == dicom.rfind(name));
  CHECK(readDicomLabels(folder / "a.seg.dcm").at(3).source.algorithm == ownAlgorithm());
  CHECK(holdsPart(slicer,
                  "Segment0_Tags:=DICOM.SegmentAlgorithmName:Net 3, Handlebody|"
                  "DICOM.SegmentAlgorithmType:AUTOMATIC|TerminologyEntry:"));
  CHECK(holdsPart(slicer, "Segment2_Tags:=TerminologyEntry:"));
}

TEST_CASE("what an object is called in codes goes from its file into the next, name by name", "[labels]") {
  const FileLabel said = readOf(leftKidney());
  const ObjectLabel label = labelledAs(said, {"as before", {1, 2, 3}, 4, "bone"});
  CHECK(label.source == said.source);
  CHECK(label.term == "tissue");
  CHECK(label.colour == Colour{1, 2, 3});
  CHECK(terminologyOf(label) == leftKidney());
  // Our own word needs none besides.
  CHECK(labelledAs(readOf(someFat(), "SEMIAUTOMATIC", "Handlebody"), {}).source.algorithm == std::nullopt);
  FileLabel liver;
  liver.take(terminologyOf(*termFromName("liver")));
  CHECK(labelledAs(liver, label).source.terminology == std::nullopt);
  CHECK(labelledAs({}, label) == label);
}

TEST_CASE("a code of our list is its term alone, and with anything more both", "[labels]") {
  const Terminology liver = terminologyOf(*termFromName("liver"));
  CHECK(readOf(liver).term == "liver");
  CHECK_FALSE(readOf(liver).source.terminology);
  Terminology left = liver, other = liver;
  left.type.modifiers.push_back({"7771000", "SCT", "Left"});
  other.category = {"85756007", "SCT", "Tissue"};
  for (const Terminology& t : {left, other}) {
    CHECK(readOf(t).term == "liver");
    CHECK(readOf(t).source.terminology == t);
    CHECK(meaningOf(t) == (t == left ? "Liver, Left" : "Liver"));
  }
}

TEST_CASE("a code that could not be written again is none: too long, empty, or with what separates codes",
          "[labels]") {
  const std::string sixteen(16, 'x');
  std::string umlauts;
  for (int i = 0; i < 64; ++i) umlauts += "\u00fc";
  Terminology longest = someFat();
  longest.type.term = {sixteen, sixteen, umlauts};
  CHECK(usable(longest) == longest);
  const std::vector<CodedTerm> bad{{sixteen + "x", "SCT", "m"},
                                   {"1", sixteen + "x", "m"},
                                   {"1", "SCT", umlauts + "x"},
                                   {"", "SCT", "m"},
                                   {"1", "", "m"},
                                   {"1", "SCT", " "},
                                   {"1", "SCT", "a\nb"},
                                   {"1", "SCT", "a\\b"},
                                   {"1", "SCT", "a|b"},
                                   {"1", "SCT", "a~b"},
                                   {"1", "SCT", "a^b"},
                                   {"1", "SCT", "\xff"}};
  for (const CodedTerm& code : bad) {
    INFO(code.value << ' ' << code.scheme << ' ' << code.meaning);
    Terminology type = leftKidney(), category = leftKidney(), modifier = leftKidney(), region = leftKidney();
    type.type.term = category.category = region.region.term = code;
    modifier.type.modifiers = {code, {"G-A101", "SRT", "Left"}};
    CHECK_FALSE(usable(type));
    CHECK_FALSE(usable(category));
    CHECK(usable(modifier) == leftKidney());
    Terminology nowhere = leftKidney();
    nowhere.region = {};
    CHECK(usable(region) == nowhere);
  }
  Terminology many = leftKidney();
  many.type.modifiers.resize(1000, {"G-A101", "SRT", "Left"});
  CHECK(readOf(many).source.terminology->type.modifiers.size() == kMaxModifiers);
}

TEST_CASE("the name of an algorithm is followed by ours, once, and fits", "[labels]") {
  const auto written = [](AlgorithmType type, const std::string& name) {
    return writtenAlgorithm(algorithmSaid(algorithmTypeName(type), name)).name;
  };
  CHECK(writtenAlgorithm(std::nullopt) == SegmentAlgorithm{AlgorithmType::semiautomatic, "Handlebody"});
  CHECK(written(AlgorithmType::automatic, "Net") == "Net, Handlebody");
  CHECK(written(AlgorithmType::automatic, "Net, Handlebody") == "Net, Handlebody");
  CHECK(written(AlgorithmType::automatic, "Handlebody") == "Handlebody");
  CHECK(written(AlgorithmType::automatic, std::string(65, 'x')) == "Handlebody");
  CHECK(written(AlgorithmType::semiautomatic, "a\\b") == "Handlebody");
  CHECK(written(AlgorithmType::automatic, std::string(64, 'x')) == std::string(52, 'x') + ", Handlebody");
  CHECK(written(AlgorithmType::automatic, std::string(51, 'x') + "\u00fcber allem") ==
        std::string(51, 'x') + ", Handlebody");
  CHECK(written(AlgorithmType::manual, "OHIF Brush").empty());
  CHECK_FALSE(algorithmSaid("HAND", "Net"));
}

TEST_CASE("what is to name nobody leaves out an algorithm's name and private codes, and keeps the rest",
          "[labels]") {
  const TemporaryFolder folder;
  auto objects = threeObjects();
  writeDicomSegmentation(thirds(), objects, noSeries(), {{}, {}, true}, folder / "a.seg.dcm");
  CHECK_FALSE(holdsPart(readBytes(folder / "a.seg.dcm"), "Net 3"));
  const FileLabels said = readDicomLabels(folder / "a.seg.dcm");
  CHECK(said.at(1).source.terminology == leftKidney());
  CHECK(said.at(1).source.algorithm == SegmentAlgorithm{AlgorithmType::automatic, "Handlebody"});
  CHECK(said.at(2).source.algorithm == SegmentAlgorithm{AlgorithmType::manual, ""});
  for (const char* scheme : {"99KLINIKUM", "L"}) {
    SegmentSource own = objects[0].label.source;
    own.terminology->type.modifiers[0].scheme = scheme;
    CHECK_FALSE(withoutSite(own).terminology);
  }
  Session session = someSession("/scans/v.mha");
  session.label = objects[0].label;
  CHECK(anonymous(session).label.source == withoutSite(objects[0].label.source));
  CHECK(anonymous(session).label.source.algorithm->name.empty());
}

TEST_CASE("how a segment was made holds for its surface as it is in the file, not for what has grown on it",
          "[labels]") {
  const SegmentSource source = threeObjects()[0].label.source;
  Constraints given, grown;
  given.start.emplace();
  CHECK(sourceInFiles(source, given, 0, false) == source);
  CHECK(sourceInFiles(source, given, 0, true) == withoutSite(source));
  for (const SegmentSource& ours :
       {sourceInFiles(source, given, 1, false), sourceInFiles(source, grown, 0, false)}) {
    CHECK(ours.terminology == source.terminology);
    CHECK_FALSE(ours.algorithm);
  }
}

TEST_CASE("a session keeps codes and algorithm, and says nothing of them where there are none", "[labels]") {
  const TemporaryFolder folder;
  const std::string path = folder / "s.json";
  Session session = someSession(folder / "v.mha");
  writeSession(session, path);
  const std::string plain = readBytes(path);
  CHECK(readSession(path).label == session.label);
  CHECK_FALSE(holdsPart(plain, "terminology"));
  CHECK_FALSE(holdsPart(plain, "algorithm"));
  for (const ExportedObject& object : threeObjects()) {
    session.label = object.label;
    writeSession(session, path);
    CHECK(readSession(path).label == object.label);
  }
  session.label = threeObjects()[0].label;
  session.label.source.terminology->type.term.value = "much-too-long-a-value";
  writeSession(session, path);
  CHECK_THROWS_AS(readSession(path), InputError);
  session.label.source = {};
  session.label.source.algorithm = SegmentAlgorithm{AlgorithmType::automatic, "a|b"};
  writeSession(session, path);
  CHECK_THROWS_AS(readSession(path), InputError);
}
