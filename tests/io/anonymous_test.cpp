// --anonymous: nothing that names the patient is in any file.

#include <zlib.h>

#include <cstdlib>
#include <set>

#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/io/dicom_test_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Every value of the source that names the patient, the study or the images, as it stands in the files.
const MoreElements kPatient{{0x00080020, {"DA", "19991231"}},   {0x00080030, {"TM", "235958"}},
                            {0x00080050, {"SH", "ACC4711"}},    {0x00080080, {"LO", "Hospital X"}},
                            {0x00080090, {"PN", "House^Greg"}}, {0x00081030, {"LO", "Knee study"}},
                            {0x00100010, {"PN", "Doe^Jane"}},   {0x00100020, {"LO", "PID0815"}},
                            {0x00100030, {"DA", "19700203"}},   {0x00101010, {"AS", "029Y"}},
                            {0x00102297, {"PN", "Doe^Mother"}}, {0x00200010, {"SH", "STUDY99"}}};
const std::string kSeries = "1.2.3.4711.99.1", kFolder = "DOE_JANE_19700203";

std::vector<Slice> bright() {
  std::vector<Slice> slices = evenStack(24);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    Slice& s = slices[k];
    s.series = kSeries;
    s.columns = s.rows = 40;
    s.spacing = "2.5\\2.5";
    s.more = kPatient;
    s.number = static_cast<int>(k) + 1;
    s.pixel = [k](int x, int y) {
      const double dx = x - 19.5, dy = y - 19.5, dz = static_cast<double>(k) - 11.5;
      return dx * dx + dy * dy + dz * dz < 81 ? 500 : 100;
    };
  }
  return slices;
}

const std::vector<std::string> kOutputs{"a.stl", "a.vtp",      "a.ply",     "a.obj",
                                        "a.3mf", "a.nii",      "a.nii.gz",  "a.nrrd",
                                        "a.mha", "a.seg.nrrd", "a.seg.dcm", "a.stl.dcm"};

//! Segments the series into `to`; every kind of file. Returns the exit code.
int run(const TemporaryFolder& folder, const std::string& to, const std::string& more) {
  fs::create_directories(folder / to);
  const auto in = [&](const std::string& name) { return "'" + (folder / to) + "/" + name + "'"; };
  std::string command = std::string(HANDLEBODY_CLI) + " segment '" + (folder / kFolder) + "' --series " +
                        kSeries + " --seed-ijk 19,19,11 --quiet " + more;
  for (const std::string& name : kOutputs) command += " -o " + in(name);
  command += " --report " + in("r.json") + " --session " + in("s.json") + " --trace " + in("t.json") +
             " --picture " + in("p.png") + " --label-description " + in("l.txt") + " 2> /dev/null";
  return std::system(command.c_str());
}

//! What names the patient: the values, the UIDs, and the names of the folder and its files.
std::set<std::string> telling(const std::string& folder) {
  std::set<std::string> all{kSeries, kFolder, "DOE_JANE", "not_dicom_doe.txt"};
  for (const auto& [tag, value] : kPatient) all.insert(value.second);
  for (const DicomImage& image : loadVolume(folder).info.dicom->images) all.insert(image.instance);
  return all;
}

//! The deflated data that begin at `at`; `bits` as zlib's windowBits. Nothing if they are none.
std::string inflated(const std::string& bytes, std::size_t at, int bits) {
  z_stream stream{};
  if (inflateInit2(&stream, bits) != Z_OK) return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
  stream.avail_in = static_cast<uInt>(bytes.size() - at);
  std::string all;
  std::vector<char> part(1 << 16);
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    all.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return all;
}

//! The file, and what is packed in it (gzip, the entries of a zip archive).
std::string unpacked(const std::string& bytes) {
  std::string all = bytes;
  for (auto at = bytes.find("PK\3\4"); at != std::string::npos; at = bytes.find("PK\3\4", at + 4)) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
    if (at + 30 < bytes.size())
      all += inflated(bytes, at + 30 + (byte(26) | byte(27) << 8) + (byte(28) | byte(29) << 8), -15);
  }
  for (auto at = bytes.find("\x1f\x8b\x08"); at != std::string::npos; at = bytes.find("\x1f\x8b\x08", at + 3))
    all += inflated(bytes, at, 31);
  return all;
}

std::set<std::string> found(const TemporaryFolder& folder, const std::string& in,
                            const std::set<std::string>& values) {
  std::set<std::string> hits;
  for (const auto& entry : fs::directory_iterator(folder / in)) {
    const std::string bytes = unpacked(readBytes(entry.path().string()));
    for (const std::string& value : values)
      if (bytes.find(value) != std::string::npos) hits.insert(value);
  }
  return hits;
}

}  // namespace

TEST_CASE("no value of the source is in any file that is written anonymously") {
  const TemporaryFolder folder;
  writeSeries(folder / kFolder, bright());
  writeBytes((folder / kFolder) + "/not_dicom_doe.txt", "a note");
  const std::set<std::string> values = telling(folder / kFolder);
  REQUIRE(values.size() > 30);

  REQUIRE(run(folder, "open", "") == 0);
  const std::set<std::string> open = found(folder, "open", values);
  for (const char* value : {"Doe^Jane", "PID0815", "19700203", "DOE_JANE", "not_dicom_doe.txt", "House^Greg"})
    CHECK(open.count(value) == 1);  // else the search would prove nothing
  CHECK(open.count(kSeries) == 1);

  REQUIRE(run(folder, "hidden", "--anonymous") == 0);
  CHECK(std::distance(fs::directory_iterator(folder / "hidden"), fs::directory_iterator{}) ==
        std::ptrdiff_t(kOutputs.size()) + 5);
  CHECK(found(folder, "hidden", values) == std::set<std::string>{});
  CHECK(readBytes(folder / "hidden/a.stl") == readBytes(folder / "open/a.stl"));
  const Volume one = readVolume(folder / "open/a.seg.dcm"), other = readVolume(folder / "hidden/a.seg.dcm");
  CHECK(voxelBytes(one) == voxelBytes(other));

  const std::string replay = std::string(HANDLEBODY_CLI) + " replay '" + (folder / "hidden/s.json") +
                             "' -o '" + (folder / "again.stl") + "' --quiet";
  CHECK(std::system((replay + " 2> /dev/null").c_str()) != 0);  // it does not know its volume
  const std::string volume = " --volume '" + (folder / kFolder) + "' --series " + kSeries + " 2> /dev/null";
  REQUIRE(std::system((replay + volume).c_str()) == 0);
  CHECK(readBytes(folder / "again.stl") == readBytes(folder / "open/a.stl"));
}

TEST_CASE("nor of several objects, one of them from a file that names the patient") {
  const TemporaryFolder folder;
  writeSeries(folder / kFolder, bright());
  const Volume volume = readVolume(folder / kFolder);
  const Vec3 corner = volume.grid.toWorld(Vec3(6, 6, 4));
  writeMesh(icosphere(corner, 2, 0.8), folder / "DOE_JANE_old.stl");
  std::set<std::string> values = telling(folder / kFolder);
  values.insert("DOE_JANE_old");
  const auto segment = [&](const std::string& to, const std::string& more) {
    fs::create_directories(folder / to);
    std::string command = std::string(HANDLEBODY_CLI) + " segment '" + (folder / kFolder) + "' --quiet " +
                          more + " --object-name old --given '" + (folder / "DOE_JANE_old.stl") +
                          "' --object-name new --seed-ijk 19,19,11";
    for (const std::string& name : kOutputs) command += " -o '" + (folder / to) + "/" + name + "'";
    for (const std::string& name : kOutputs) command += " -o 'old=" + (folder / to) + "/old." + name + "'";
    command += " --report '" + (folder / to) + "/r.json' --session '" + (folder / to) + "/s.json' --trace '" +
               (folder / to) + "/t.json' --picture '" + (folder / to) + "/p.png' --label-description '" +
               (folder / to) + "/l.txt' 2> /dev/null";
    return std::system(command.c_str());
  };
  REQUIRE(segment("open", "") == 0);
  CHECK(found(folder, "open", values).count("DOE_JANE_old") == 1);
  REQUIRE(segment("hidden", "--anonymous") == 0);
  CHECK(found(folder, "hidden", values) == std::set<std::string>{});
}
