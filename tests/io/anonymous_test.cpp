// --anonymous: nothing that names the patient is in any file.

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "core/io/meshes/mesh_io.h"
#include "core/io/tetrahedra/tetrahedra.h"
#include "core/mesh/shapes.h"
#include "tests/io/dicom_test_support.h"
#include "tests/io/unpacked.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Whose images they are: every value of the source that names the patient, the study or the images, as it
//! stands in the files, their UIDs, and the folder that holds them. No value is part of another.
struct Patient {
  MoreElements values;
  std::string study, series, folder;
};
const MoreElements kDates{{0x00080012, {"DA", "19991227"}},       {0x00080013, {"TM", "235951.471108"}},
                          {0x00080020, {"DA", "19991231"}},       {0x00080021, {"DA", "19991230"}},
                          {0x00080022, {"DA", "19991229"}},       {0x00080023, {"DA", "19991228"}},
                          {0x0008002a, {"DT", "20000102030405"}}, {0x00080030, {"TM", "235958.471101"}},
                          {0x00080031, {"TM", "235957.471102"}},  {0x00080032, {"TM", "235956.471103"}},
                          {0x00080033, {"TM", "235955.471104"}},  {0x00100030, {"DA", "19700203"}},
                          {0x00100032, {"TM", "040506.471105"}},  {0x00181012, {"DA", "19991224"}},
                          {0x00181200, {"DA", "19991223"}},       {0x00400244, {"DA", "19991226"}},
                          {0x00400245, {"TM", "235953.471106"}}};
const MoreElements kPlaces{
    {0x00080080, {"LO", "Hospital X"}},        {0x00080081, {"ST", "1 Hospital Way"}},
    {0x00081010, {"SH", "SCANNER_7"}},         {0x00081040, {"LO", "Dept. of Knees"}},
    {0x00181000, {"LO", "SN-4711-0007"}},      {0x00181030, {"LO", "Knee protocol of X"}},
    {0x00400241, {"AE", "AE_TITLE_7"}},        {0x00400242, {"SH", "PPS_STATION"}},
    {0x00400243, {"SH", "PPS_LOCATION"}},      {0x00102299, {"LO", "Guardians Ltd"}},
    {0x00321033, {"LO", "Requesting ward"}},   {0x00081030, {"LO", "Knee study"}},
    {0x00321060, {"LO", "Requested of knee"}}, {0x00400254, {"LO", "Performed on knee"}},
    {0x00081080, {"LO", "Torn meniscus"}},     {0x00204000, {"LT", "comment on images"}}};
const MoreElements kPeople{{0x00080090, {"PN", "House^Greg"}},
                           {0x00080092, {"ST", "2 Doctors Lane"}},
                           {0x00080094, {"SH", "+1-555-0101"}},
                           {0x00081048, {"PN", "Cuddy^Lisa"}},
                           {0x00081050, {"PN", "Chase^Robert"}},
                           {0x00081060, {"PN", "Foreman^Eric"}},
                           {0x00081070, {"PN", "Tech^Tom"}},
                           {0x00321032, {"PN", "Cameron^Allison"}},
                           {0x00401010, {"PN", "Recipient^Rita"}},
                           {0x00100010, {"PN", "Doe^Jane"}},
                           {0x00101001, {"PN", "Roe^Janet"}},
                           {0x00101005, {"PN", "Born^Jane"}},
                           {0x00101060, {"PN", "Born^Mother"}},
                           {0x00102297, {"PN", "Doe^Mother"}},
                           {0x00101010, {"AS", "029Y"}},
                           {0x00101020, {"DS", "1.618033"}},
                           {0x00101030, {"DS", "61.80339"}},
                           {0x00101040, {"LO", "12 Elm Street"}},
                           {0x00101080, {"LO", "Sergeant of Navy"}},
                           {0x00102000, {"LO", "pacemaker alert"}},
                           {0x00102110, {"LO", "penicillin"}},
                           {0x00102150, {"LO", "Freedonia"}},
                           {0x00102152, {"LO", "Region of Doe"}},
                           {0x00102154, {"SH", "+1-555-0199"}},
                           {0x00102160, {"SH", "Ethnic group X"}},
                           {0x00102180, {"SH", "lion tamer"}},
                           {0x001021b0, {"LT", "fell off a lion"}},
                           {0x001021f0, {"LO", "Pastafarian"}},
                           {0x00104000, {"LT", "afraid of dogs"}}};
const MoreElements kNumbers{{0x00080014, {"UI", "1.2.3.4711.5.1"}}, {0x00080050, {"SH", "ACC4711"}},
                            {0x00100020, {"LO", "PID0815"}},        {0x00100021, {"LO", "Issuer of PIDs"}},
                            {0x00101000, {"LO", "OTHER0816"}},      {0x00101050, {"LO", "INSURED0817"}},
                            {0x00101090, {"LO", "RECORD0818"}},     {0x00181002, {"UI", "1.2.3.4711.7.1"}},
                            {0x00200010, {"SH", "STUDY99"}},        {0x00200052, {"UI", "1.2.3.4711.8.1"}},
                            {0x00380010, {"LO", "ADMISSION0819"}},  {0x00400253, {"SH", "PPS0820"}},
                            {0x00401001, {"SH", "REQUESTED0821"}},  {0x00402016, {"LO", "PLACER0822"}},
                            {0x00402017, {"LO", "FILLER0823"}},     {0x0040a124, {"UI", "1.2.3.4711.9.1"}}};

MoreElements together(std::initializer_list<MoreElements> parts) {
  MoreElements all;
  for (const MoreElements& part : parts) all.insert(part.begin(), part.end());
  return all;
}

const Patient kJane{together({kDates, kPlaces, kPeople, kNumbers}), "1.2.3.4711.6.1", "1.2.3.4711.99.1",
                    "DOE_JANE_19700203"};
const Patient kJohn{{{0x00080020, {"DA", "20010101"}},
                     {0x00080090, {"PN", "Wilson^James"}},
                     {0x00081030, {"LO", "Head"}},
                     {0x00081070, {"PN", "Operator^Olga"}},
                     {0x00100010, {"PN", "Roe^John^Q"}},
                     {0x00100020, {"LO", "42"}},
                     {0x00101010, {"AS", "060Y"}},
                     {0x00200052, {"UI", "1.2.3.815.9"}}},
                    "1.2.3.815.8",
                    "1.2.3.815.7",
                    "roe"};
//! Of kJane.values, what a DICOM file that is made of the series has from it.
const std::vector<std::string> kCopied{"19991231",   "235958.471101", "ACC4711", "House^Greg",
                                       "Knee study", "Doe^Jane",      "PID0815", "Issuer of PIDs",
                                       "19700203",   "029Y",          "STUDY99", "1.2.3.4711.8.1",
                                       "Doe^Mother", "1.618033",      "61.80339"};
const std::string kDescription = "made by hand";  // of the series, by dicomBytes

//! A bright ball, with a radius in voxels.
std::vector<Slice> bright(const Patient& patient = kJane, double radius = 9) {
  std::vector<Slice> slices = evenStack(24);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    Slice& s = slices[k];
    s.series = patient.series;
    s.study = patient.study;
    s.columns = s.rows = 40;
    s.spacing = "2.5\\2.5";
    s.more = patient.values;
    s.number = static_cast<int>(k) + 1;
    s.pixel = [k, radius](int x, int y) {
      const double dx = x - 19.5, dy = y - 19.5, dz = static_cast<double>(k) - 11.5;
      return dx * dx + dy * dy + dz * dz < radius * radius ? 500 : 100;
    };
  }
  return slices;
}

//! The same in three frames, in which it gets smaller.
std::vector<Slice> brightOverTime() {
  std::vector<Slice> slices;
  for (int t = 0; t < 3; ++t)
    for (Slice& s : bright(kJane, 9 - 0.5 * t)) {
      s.temporalPosition = 1 + t;
      s.number = static_cast<int>(slices.size()) + 1;
      slices.push_back(std::move(s));
    }
  return slices;
}

const std::vector<std::string> kAnonymousOutputs{"a.stl",      "a.vtp",     "a.ply",    "a.obj",  "a.3mf",
                                                 "a.gltf",     "a.nii",     "a.nii.gz", "a.nrrd", "a.mha",
                                                 "a.seg.nrrd", "a.seg.dcm", "a.stl.dcm"};

//! Its exit code; what it says does not matter.
int execute(const std::string& arguments) {
  const int status = std::system((HANDLEBODY_CLI + (" " + arguments) + " > /dev/null 2> /dev/null").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string quoted(const std::string& path) { return "'" + path + "'"; }

//! The files beside the results, as options.
std::string sideFiles(const std::string& to) {
  return " --report " + quoted(to + "/r.json") + " --session " + quoted(to + "/s.json") + " --trace " +
         quoted(to + "/t.json") + " --picture " + quoted(to + "/p.png");
}

//! Segments the series into `to`; every kind of file that needs no other program. Returns the exit code.
int run(const TemporaryFolder& folder, const std::string& to, const std::string& more,
        const Patient& patient = kJane) {
  fs::create_directories(folder / to);
  std::string command = "segment " + quoted(folder / patient.folder) + " --series " + patient.series +
                        " --seed-ijk 19,19,11 --quiet " + more;
  for (const std::string& name : kAnonymousOutputs) command += " -o " + quoted((folder / to) + "/" + name);
  return execute(command + sideFiles(folder / to) + " --label-description " +
                 quoted((folder / to) + "/l.txt") + " --sensitivity 2 --sensitivity-surface " +
                 quoted((folder / to) + "/v.vtp"));
}

//! What names the patient: the values, the UIDs, and the names of the folder and its files.
std::set<std::string> telling() {
  std::set<std::string> all{kJane.study,  kJane.series, kJane.folder,
                            kDescription, "DOE_JANE",   "not_dicom_doe.txt"};
  for (const auto& [tag, value] : kJane.values) all.insert(value.second);
  return all;
}

//! And those of the images in a folder.
std::set<std::string> telling(const std::string& folder) {
  std::set<std::string> all = telling();
  const LoadedVolume loaded = loadVolume(folder);
  REQUIRE(!loaded.info.dicom->images.empty());
  for (const DicomImage& image : loaded.info.dicom->images) all.insert(image.instance);
  return all;
}

bool holdsValue(const std::string& text, const std::string& value) {
  const std::boyer_moore_horspool_searcher searcher(value.begin(), value.end());  // there are many values
  return std::search(text.begin(), text.end(), searcher) != text.end();
}

//! In all files of a folder and of those in it, and in their names.
std::set<std::string> found(const std::string& folder, const std::set<std::string>& values) {
  std::set<std::string> hits;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    std::string text = fs::relative(entry.path(), folder).string();
    if (entry.is_regular_file()) text += "\n" + unpacked(readBytes(entry.path().string()));
    for (const std::string& value : values)
      if (holdsValue(text, value)) hits.insert(value);
  }
  return hits;
}

std::ptrdiff_t filesIn(const std::string& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator{});
}

//! Without how long it took and the hash of the volume.
nlohmann::json comparable(nlohmann::json json) {
  if (json.is_object())
    for (const char* key : {"seconds", "sha256"}) json.erase(key);
  for (auto& part : json)
    if (part.is_structured()) part = comparable(part);
  return json;
}

}  // namespace

TEST_CASE("no value of the source is in any file that is written anonymously") {
  const TemporaryFolder folder;
  writeSeries(folder / kJane.folder, bright());
  writeBytes((folder / kJane.folder) + "/not_dicom_doe.txt", "a note");
  const std::set<std::string> values = telling(folder / kJane.folder);
  REQUIRE(values.size() > 100);
  const std::set<std::string> source = found(folder / kJane.folder, values);
  for (const auto& [tag, value] : kJane.values) CHECK(source.count(value.second) == 1);

  REQUIRE(run(folder, "open", "") == 0);
  const std::set<std::string> open = found(folder / "open", values);
  for (const std::string& value : kCopied)
    CHECK(open.count(value) == 1);  // else the search would prove nothing
  for (const std::string& value :
       {kJane.study, kJane.series, std::string("DOE_JANE"), std::string("not_dicom_doe.txt")})
    CHECK(open.count(value) == 1);

  REQUIRE(run(folder, "hidden", "--anonymous") == 0);
  CHECK(filesIn(folder / "hidden") == std::ptrdiff_t(kAnonymousOutputs.size()) + 6);
  CHECK(found(folder / "hidden", values) == std::set<std::string>{});
  CHECK(readBytes(folder / "hidden/a.stl") == readBytes(folder / "open/a.stl"));
  const Volume one = readVolume(folder / "open/a.seg.dcm"), other = readVolume(folder / "hidden/a.seg.dcm");
  CHECK(voxelBytes(one) == voxelBytes(other));

  const std::string replay =
      "replay " + quoted(folder / "hidden/s.json") + " -o " + quoted(folder / "again.stl") + " --quiet";
  CHECK(execute(replay) != 0);  // it does not know its volume
  REQUIRE(execute(replay + " --volume " + quoted(folder / kJane.folder) + " --series " + kJane.series) == 0);
  CHECK(readBytes(folder / "again.stl") == readBytes(folder / "open/a.stl"));
}

// So there is nothing of the patient in the pixels of pictures, either.
TEST_CASE("what is written anonymously is the same for another patient with the same voxels") {
  const TemporaryFolder folder;
  for (const Patient& patient : {kJane, kJohn}) {
    writeSeries(folder / patient.folder, bright(patient));
    REQUIRE(run(folder, patient.folder + ".out", "--anonymous", patient) == 0);
  }
  const auto bytes = [&](const Patient& patient, const std::string& name) {
    return readBytes((folder / (patient.folder + ".out")) + "/" + name);
  };
  for (const std::string& name : kAnonymousOutputs)
    if (!name.ends_with(".dcm")) CHECK(bytes(kJane, name) == bytes(kJohn, name));  // those have random UIDs
  for (const char* name : {"p.png", "l.txt", "v.vtp"}) {
    CHECK_FALSE(bytes(kJane, name).empty());
    CHECK(bytes(kJane, name) == bytes(kJohn, name));
  }
  for (const char* name : {"r.json", "s.json", "t.json"}) {
    const auto one = nlohmann::json::parse(bytes(kJane, name)),
               two = nlohmann::json::parse(bytes(kJohn, name));
    CHECK(one.at("input").at("sha256") != two.at("input").at("sha256"));
    CHECK(comparable(one) == comparable(two));
  }
}

TEST_CASE("an anonymous session finds its series among others by the voxels, and refuses another one") {
  const TemporaryFolder folder;
  writeSeries(folder / "both", bright());
  std::vector<Slice> other = bright(kJane, 7);
  for (std::size_t i = 0; i < other.size(); ++i) {
    other[i].series = "1.2.3.4711.99.0";  // is listed first
    writeBytes((folder / "both") + "/other" + std::to_string(i),
               dicomBytes(other[i], other[i].series + "." + std::to_string(i + 1)));
  }
  fs::create_directories(folder / "out");
  const auto written = [&](const std::string& name) { return quoted(folder / ("out/" + name)); };
  REQUIRE(execute("segment " + quoted(folder / "both") + " --series " + kJane.series +
                  " --seed-ijk 19,19,11 --quiet --anonymous -o " + written("a.stl") + " --session " +
                  written("s.json") + " --report " + written("r.json")) == 0);
  CHECK(found(folder / "out", {kJane.series, "1.2.3.4711.99.0"}).empty());
  for (const char* name : {"s.json", "r.json"}) {
    const auto input = nlohmann::json::parse(readBytes(folder / (std::string("out/") + name))).at("input");
    CHECK(input.at("voxels_sha256").get<std::string>().size() == 64);
    CHECK_FALSE(input.contains("series"));
    const std::string replay =
        "replay " + written(name) + " --volume " + quoted(folder / "both") + " --quiet -o ";
    REQUIRE(execute(replay + written("b.stl")) == 0);
    CHECK(readBytes(folder / "out/b.stl") == readBytes(folder / "out/a.stl"));
    REQUIRE(execute(replay + written("c.stl") + " --series " + kJane.series) == 0);
    CHECK(execute(replay + written("d.stl") + " --series 1.2.3.4711.99.0") == 3);
    CHECK_FALSE(fs::exists(folder / "out/d.stl"));
  }

  // One of an earlier version asks which, as ever.
  auto old = nlohmann::json::parse(readBytes(folder / "out/s.json"));
  old.at("input").erase("voxels_sha256");
  writeBytes(folder / "out/old.json", old.dump());
  const std::string replay = "replay " + written("old.json") + " --volume " + quoted(folder / "both") +
                             " --quiet -o " + written("e.stl");
  CHECK(execute(replay) == 3);
  CHECK(execute(replay + " --series " + kJane.series) == 0);

  // None of them: the folder is the same, but not what the session keeps.
  old.at("input")["voxels_sha256"] = std::string(64, '0');
  writeBytes(folder / "out/old.json", old.dump());
  CHECK(execute(replay) == 3);
}

TEST_CASE("nor of several objects, one of them from a file that names the patient") {
  const TemporaryFolder folder;
  writeSeries(folder / kJane.folder, bright());
  const Volume volume = readVolume(folder / kJane.folder);
  const Vec3 corner = volume.grid.toWorld(Vec3(6, 6, 4));
  writeMesh(icosphere(corner, 2, 0.8), folder / "DOE_JANE_old.stl");
  std::set<std::string> values = telling(folder / kJane.folder);
  values.insert("DOE_JANE_old");
  const auto segment = [&](const std::string& to, const std::string& more) {
    fs::create_directories(folder / to);
    std::string command = "segment " + quoted(folder / kJane.folder) + " --quiet " + more +
                          " --object-name old --given " + quoted(folder / "DOE_JANE_old.stl") +
                          " --object-name new --seed-ijk 19,19,11";
    for (const std::string& name : kAnonymousOutputs) command += " -o " + quoted((folder / to) + "/" + name);
    for (const std::string& name : kAnonymousOutputs)
      command += " -o " + quoted("old=" + (folder / to) + "/old." + name);
    return execute(command + sideFiles(folder / to) + " --label-description " +
                   quoted((folder / to) + "/l.txt"));
  };
  REQUIRE(segment("open", "") == 0);
  CHECK(found(folder / "open", values).count("DOE_JANE_old") == 1);
  REQUIRE(segment("hidden", "--anonymous") == 0);
  CHECK(found(folder / "hidden", values) == std::set<std::string>{});
}

TEST_CASE("nor in tetrahedra for a solver") {
  if (!tetrahedraFault().empty()) {
    WARN("skipped: neither gmsh nor TetGen is installed");
    return;
  }
  const TemporaryFolder folder;
  writeSeries(folder / kJane.folder, bright());
  std::set<std::string> values = telling(folder / kJane.folder);
  const auto segment = [&](const std::string& to, const std::string& more) {
    fs::create_directories(folder / to);
    std::string command = "segment " + quoted(folder / kJane.folder) + " --seed-ijk 19,19,11 --quiet " + more;
    for (const char* name : {"/a.msh", "/a.vtu", "/a.inp"}) command += " -o " + quoted((folder / to) + name);
    return execute(command);
  };
  REQUIRE(segment("named", "--object-name 'DOE_JANE 2'") == 0);
  CHECK(found(folder / "named", {"DOE_JANE 2", "DOE_JANE_2"}).size() == 2);  // .msh and .inp are searched
  REQUIRE(segment("hidden", "--anonymous") == 0);
  CHECK(filesIn(folder / "hidden") == 3);
  CHECK(found(folder / "hidden", values) == std::set<std::string>{});
}

TEST_CASE("nor in the numbered meshes, the 4D label maps and the curve of a growth over time") {
  const TemporaryFolder folder;
  writeSeries(folder / kJane.folder, brightOverTime());
  writeBytes((folder / kJane.folder) + "/not_dicom_doe.txt", "a note");
  const std::set<std::string> values = telling();
  const auto segment = [&](const std::string& to, const std::string& more) {
    fs::create_directories(folder / to);
    std::string command = "segment " + quoted(folder / kJane.folder) + " --series " + kJane.series +
                          " --seed-ijk 19,19,11 --frames all --drift-check none --quiet " + more;
    for (const char* name : {"m.vtp", "m.stl", "m.ply", "m.obj", "l.nii", "l.nii.gz", "l.nrrd"})
      command += " -o " + quoted((folder / to) + "/" + name);
    for (const char* name : {"c.csv", "c.svg"}) command += " --curve " + quoted((folder / to) + "/" + name);
    return execute(command + sideFiles(folder / to));
  };
  REQUIRE(segment("open", "") == 0);
  const std::set<std::string> open = found(folder / "open", values);
  for (const std::string& value : {kJane.series, kJane.folder, std::string("not_dicom_doe.txt")})
    CHECK(open.count(value) == 1);
  REQUIRE(segment("hidden", "--anonymous") == 0);
  CHECK(filesIn(folder / "hidden") == 3 * 4 + 1 + 3 + 2 + 4);  // with the list of the frames for ParaView
  CHECK(found(folder / "hidden", values) == std::set<std::string>{});
}

TEST_CASE("nor of a frame over time that cannot be read") {
  const TemporaryFolder folder;
  writeSeries(folder / kJane.folder, bright());
  const Volume volume = readVolume(folder / kJane.folder);
  fs::create_directories(folder / "DOE_JANE");
  for (const char* name : {"DOE_JANE/f0.nii.gz", "DOE_JANE/f1.nii.gz", "DOE_JANE/f2.nii.gz"})
    writeVolume(volume, folder / name);
  std::string bytes = readBytes(folder / "DOE_JANE/f1.nii.gz");
  for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 64; ++i)
    bytes[i] = static_cast<char>(~bytes[i]);
  writeBytes(folder / "DOE_JANE/f1.nii.gz", bytes);
  const auto segment = [&](const std::string& to, const std::string& more) {
    fs::create_directories(folder / to);
    return execute("segment " + quoted(folder / "DOE_JANE") +
                   " --seed-ijk 19,19,11 --frames all --drift-check none --quiet " + more + " -o " +
                   quoted((folder / to) + "/m.vtp") + " -o " + quoted((folder / to) + "/l.nrrd") +
                   " --curve " + quoted((folder / to) + "/c.csv") + sideFiles(folder / to));
  };
  const std::set<std::string> values{"DOE_JANE", "f1.nii.gz"};
  REQUIRE(segment("open", "") == 7);
  CHECK(found(folder / "open", values) == values);
  REQUIRE(segment("hidden", "--anonymous") == 7);
  CHECK(found(folder / "hidden", values) == std::set<std::string>{});
}

namespace {

//! A folder with a series, a file that is no volume, and a study of both and of a file that is not there.
struct NamedStudy {
  TemporaryFolder folder;
  std::set<std::string> values;

  explicit NamedStudy(const std::string& anonymous) {
    writeSeries(folder / kJane.folder, bright());
    writeBytes((folder / kJane.folder) + "/not_dicom_doe.txt", "a note");
    writeBytes(folder / "DOE_JANE_broken.nii", "no volume");
    values = telling(folder / kJane.folder);
    values.insert({"DOE_JANE_broken", "DOE_JANE_gone", folder.path()});
    const std::string output = ",mesh.stl;mesh.gltf;labels.seg.nrrd;labels.seg.dcm,", end = anonymous + "\n";
    writeBytes(folder / "study.csv", "case,volume,seed-ijk,series,output,anonymous\na," + kJane.folder +
                                         ",\"19,19,11\"," + kJane.series + output + end +
                                         "b,DOE_JANE_broken.nii,\"1,1,1\",,," + end +
                                         "c,DOE_JANE_gone.nii,\"1,1,1\",,," + end);
  }
  //! Exit code of a batch over it.
  int run() const {
    return execute("batch " + quoted(folder / "study.csv") + " -o " + quoted(folder / "out"));
  }
  nlohmann::json row(std::size_t i) const {
    return nlohmann::json::parse(readBytes(folder / "out/summary.json")).at("cases").at(i);
  }
};

}  // namespace

TEST_CASE("nor in results, records, summary, page and logs of the cases of a batch that are anonymous") {
  const NamedStudy open("no"), hidden("yes");
  REQUIRE(open.run() == 7);
  const std::set<std::string> told = found(open.folder / "out", open.values);
  for (const char* value : {"Doe^Jane", "DOE_JANE_broken", "DOE_JANE_gone", "not_dicom_doe.txt"})
    CHECK(told.count(value) == 1);
  CHECK(told.count(kJane.series) == 1);

  REQUIRE(hidden.run() == 7);
  CHECK(hidden.row(0).at("status") == "done");
  CHECK(hidden.row(1).at("status") == "failed");
  CHECK(hidden.row(2).at("status") == "refused");
  CHECK(found(hidden.folder / "out", hidden.values) == std::set<std::string>{});
  CHECK(readBytes(hidden.folder / "out/cases/a/mesh.stl") == readBytes(open.folder / "out/cases/a/mesh.stl"));
}

TEST_CASE(
    "why an anonymous case of a batch has no result is told on standard error, and where in the summary") {
  const NamedStudy study("yes");
  const std::string said = study.folder / "said.txt";
  const int status =
      std::system((std::string(HANDLEBODY_CLI) + " batch " + quoted(study.folder / "study.csv") + " -o " +
                   quoted(study.folder / "out") + " > /dev/null 2> " + quoted(said))
                      .c_str());
  CHECK(WEXITSTATUS(status) == 7);
  CHECK_THAT(readBytes(said), Contains("DOE_JANE_broken.nii") && Contains("DOE_JANE_gone.nii"));
  CHECK_THAT(study.row(1).at("message").get<std::string>(), Contains("exit code 3"));
  CHECK_THAT(study.row(2).at("message").get<std::string>(), Contains("line 4, column 2 (volume)"));
}

TEST_CASE("an anonymous case of a batch that is done is kept, and done again for another series") {
  const NamedStudy study("yes");
  REQUIRE(study.run() == 7);
  const auto written = fs::last_write_time(study.folder / "out/cases/a/case.json");
  REQUIRE(study.run() == 7);
  CHECK(fs::last_write_time(study.folder / "out/cases/a/case.json") == written);
  std::string csv = readBytes(study.folder / "study.csv");
  csv.replace(csv.find(kJane.series), kJane.series.size(), "1.2.3");
  writeBytes(study.folder / "study.csv", csv);
  REQUIRE(study.run() == 7);
  CHECK(study.row(0).at("status") == "failed");  // there is none
}

TEST_CASE("an anonymous case of a batch without a name has that of its line, not that of its volume") {
  const NamedStudy study("yes");
  writeBytes(study.folder / "study.csv",
             "volume,seed-ijk,anonymous\n" + kJane.folder + ",\"19,19,11\",yes\n");
  REQUIRE(study.run() == 0);
  CHECK(study.row(0).at("case") == "line-2");
  CHECK(fs::exists(study.folder / "out/cases/line-2/mesh.stl"));
  CHECK(found(study.folder / "out", study.values) == std::set<std::string>{});
}
