// Several objects in one run of `segment`.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "app/cli/object_groups.h"
#include "core/collision/body_contact.h"
#include "core/collision/certify.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/tetrahedra/mesher_process.h"
#include "tests/app/run_cli.h"
#include "tests/support/catch.h"
#include "tests/support/test_volume.h"

using namespace handlebody;
using namespace handlebody::cli;
using namespace handlebody::testing;
using handlebody::test::TempFolder;
using Arguments = std::vector<std::string>;

namespace {

Vec3 place(double x, double y, double z) { return {x, y, z}; }
const Vec3 kLiver = place(18, 20, 20), kCyst = place(16, 20, 20), kKidney = place(36, 20, 20);

//! A dark ball (liver) with a cyst in it, and another dark ball (kidney) that overlaps it, 6 mm deep, with
//! values of its own there: no front could tell where the one ends but by the other.
std::string writeStudy(const TempFolder& folder) {
  Grid grid = cubicGrid(41);
  grid.size = {56, 41, 41};
  const Volume volume = volumeByIndex(grid, [](int i, int j, int k) {
    const Vec3 p(i, j, k);
    const auto inside = [&](const Vec3& c, double r) {
      return std::clamp(r + 0.5 - (p - c).norm(), 0.0, 1.0);
    };
    const double dark = std::max(inside(kLiver, 12), inside(kKidney, 10));
    const double cyst = inside(kCyst, 5);
    return 200 - 180 * dark + 100 * cyst + 0.5 * std::sin(i + 37.1 * j + 1234.5 * k);
  });
  writeVolume(volume, folder / "v.nrrd");
  return folder / "v.nrrd";
}

const Arguments kLiverGroup{"--object-name", "liver", "--seed", "18,28,20,2", "--range", "-inf,70"};
const Arguments kCystGroup{"--object-name", "cyst", "--seed", "16,20,20,2", "--range", "70,160"};
const Arguments kKidneyGroup{"--object-name", "kidney", "--seed", "40,20,20,3", "--range", "-inf,110"};
//! Without it the first of two that overlap has both.
const Arguments kLiverAlone{"--wall", "39,20,20,7"};

Arguments joined(const std::vector<Arguments>& parts) {
  Arguments all;
  for (const Arguments& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

struct Made {
  test::Outcome outcome;
  std::map<std::string, TriangleSoup> meshes;
};

//! Segments, and reads the meshes of the objects.
Made segment(const TempFolder& folder, const std::string& volume, const std::vector<Arguments>& groups,
             const Arguments& names, const Arguments& more = {}) {
  Arguments arguments = joined({{"segment", volume}, joined(groups), {"-o", folder / "all.seg.nrrd"}, more});
  for (const std::string& name : names)
    for (const std::string option : {"-o", ""})
      arguments.push_back(option.empty() ? name + "=" + (folder / (name + ".vtp")) : option);
  Made made{test::runCli(arguments), {}};
  INFO(made.outcome.err);
  REQUIRE(made.outcome.exitCode == 0);
  for (const std::string& name : names) made.meshes[name] = readMesh(folder / (name + ".vtp"));
  return made;
}

//! No point in common, by exact predicates; no voxel in two.
void expectApart(const std::map<std::string, TriangleSoup>& meshes, const Volume& labels) {
  std::vector<int> times(labels.grid.voxelCount(), 0);
  for (auto a = meshes.begin(); a != meshes.end(); ++a) {
    CHECK(certify(a->second).boundsBody());
    const Volume mask = rasterize(a->second, labels.grid);
    for (std::size_t i = 0; i < times.size(); ++i) times[i] += mask.data<std::uint8_t>()[i];
    for (auto b = std::next(a); b != meshes.end(); ++b) {
      INFO(a->first << " and " << b->first);
      CHECK(bodyContact(a->second, b->second) == BodyContact::none);
    }
  }
  CHECK(*std::max_element(times.begin(), times.end()) == 1);
  bool same = true;
  for (std::size_t i = 0; i < times.size(); ++i)
    same = same && (labels.data<std::uint8_t>()[i] != 0) == (times[i] == 1);
  CHECK(same);
}

//! Voxels with a label value of an object that differ from the inside of its mesh.
std::size_t differing(const Volume& labels, const TriangleSoup& mesh, int value) {
  const Volume mask = rasterize(mesh, labels.grid);
  std::size_t n = 0;
  for (std::size_t i = 0; i < labels.grid.voxelCount(); ++i)
    n += (mask.data<std::uint8_t>()[i] != 0) != (labels.data<std::uint8_t>()[i] == value);
  return n;
}

//! mm from the vertices of a mesh that lie in a ball to the nearest vertex or middle of a face of the other:
//! no less than the gap.
double gapWithin(const TriangleSoup& a, const TriangleSoup& b, const Vec3& centre, double radius) {
  std::vector<Vec3> dense;
  for (const Triangle& t : b.triangles) {
    const auto corner = [&](std::size_t i) { return b.points[t[i]]; };
    constexpr int kFine = 12;
    for (int i = 0; i <= kFine; ++i)
      for (int j = 0; i + j <= kFine; ++j)
        dense.push_back((corner(0) * i + corner(1) * j + corner(2) * (kFine - i - j)) / kFine);
  }
  double widest = 0;
  for (const Vec3& p : a.points) {
    if ((p - centre).norm() > radius) continue;
    double least = 1e9;
    for (const Vec3& q : dense) least = std::min(least, (p - q).squaredNorm());
    widest = std::max(widest, std::sqrt(least));
  }
  return widest;
}

void expectRefused(const Arguments& arguments, int exitCode, const std::string& words) {
  const test::Outcome outcome = test::runCli(arguments);
  INFO(outcome.err);
  CHECK(outcome.exitCode == exitCode);
  CHECK(outcome.err.find(words) != std::string::npos);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

}  // namespace

TEST_CASE("arguments go to the run, to all objects or to the one whose name stands before",
          "[cli][objects]") {
  const auto kindOf = [](const std::string& name) {
    if (name == "--flag") return OptionKind::flag;
    return name == "--object-name" || name == "--seed" ? OptionKind::value : OptionKind::unknown;
  };
  const ObjectGroups g = groupArguments({"V", "--flag", "-o", "a.stl", "--object-name", "x y", "--seed",
                                         "-1,2,3", "--report", "r", "--object-name=z", "--flag", "--seed"},
                                        kindOf);
  CHECK(g.run == Arguments{"V", "-o", "a.stl", "--report", "r"});
  CHECK(g.common == Arguments{"--flag"});
  REQUIRE(g.objects.size() == 2);
  CHECK(g.objects[0] == Arguments{"--object-name", "x y", "--seed", "-1,2,3"});
  CHECK(g.objects[1] == Arguments{"--object-name=z", "--flag", "--seed"});
  CHECK_FALSE(nameSeveralObjects({"segment", "--object-name", "a"}));
  CHECK(nameSeveralObjects({"segment", "--object-name", "a", "--object-name=b"}));
  CHECK_FALSE(nameSeveralObjects({"segment", "--object-name", "a", "--object-name=b", "--help"}));
}

TEST_CASE("three objects of one run touch and are apart, nested either way", "[cli][objects]") {
  const TempFolder folder;
  const std::string volume = writeStudy(folder);
  const Arguments liver = joined({kLiverGroup, kLiverAlone});
  const std::vector<Arguments> orders[] = {{liver, kCystGroup, kKidneyGroup},
                                           {kCystGroup, liver, kKidneyGroup}};
  const std::vector<Arguments>& order = orders[GENERATE(0, 1)];
  const Made made =
      segment(folder, volume, order, {"liver", "cyst", "kidney"}, {"--report", folder / "r.json"});
  const Volume labels = readVolume(folder / "all.seg.nrrd");
  expectApart(made.meshes, labels);
  CHECK(certify(made.meshes.at("liver")).cavities == 1);
  const auto report = nlohmann::json::parse(test::readBytes(folder / "r.json"));
  REQUIRE(report.at("objects").size() == 3);
  CHECK_FALSE(report.contains("mesh"));
  for (const auto& object : report.at("objects")) {
    const std::string name = object.at("name");
    CHECK(differing(labels, made.meshes.at(name), object.at("label_value")) == 0);
    CHECK(object.at("mesh").at("faces") == made.meshes.at(name).triangles.size());
    CHECK(object.at("mesh").at("self_intersections") == 0);
    for (const char* key : {"parameters", "requested", "seeds", "iterations", "stopped", "seconds", "events"})
      CHECK(object.contains(key));
  }
  CHECK(gapWithin(made.meshes.at("cyst"), made.meshes.at("liver"), kCyst, 100) <= 0.5);
  CHECK(made.outcome.out.find("liver: converged") != std::string::npos);
}

TEST_CASE("where one object is stopped by another the gap is half a voxel at most", "[cli][objects]") {
  const TempFolder folder;
  const Arguments kidney = joined({kKidneyGroup, {"--wall", "14,20,20,13"}});
  const Made made = segment(folder, writeStudy(folder), {kidney, kLiverGroup}, {"kidney", "liver"});
  expectApart(made.meshes, readVolume(folder / "all.seg.nrrd"));
  CHECK(gapWithin(made.meshes.at("kidney"), made.meshes.at("liver"), place(26.5, 20, 20), 4) <= 0.5);
}

TEST_CASE("the files of one run agree: labels, groups, names, and each object by itself", "[cli][objects]") {
  const TempFolder folder;
  const std::string volume = writeStudy(folder);
  const Arguments more{"-o",
                       folder / "all.obj",
                       "-o",
                       folder / "all.ply",
                       "-o",
                       folder / "all.vtp",
                       "-o",
                       folder / "all.stl",
                       "-o",
                       folder / "all.3mf",
                       "-o",
                       folder / "all.nii.gz",
                       "-o",
                       folder / "names.label",
                       "--label-description",
                       folder / "labels.txt"};
  const Arguments cyst = joined({kCystGroup, {"--label-value", "300", "--term", "cyst"}});
  const Arguments liver = joined({kLiverGroup, kLiverAlone});
  const Made made = segment(folder, volume, {cyst, liver}, {"cyst", "liver"}, more);
  const std::size_t faces =
      made.meshes.at("cyst").triangles.size() + made.meshes.at("liver").triangles.size();
  for (const char* ending : {"obj", "ply", "vtp", "stl"}) {
    INFO(ending);
    const TriangleSoup all = readMesh(folder / (std::string("all.") + ending));
    CHECK(all.triangles.size() == faces);
    CHECK(certify(all).passes());
  }
  const std::string obj = test::readBytes(folder / "all.obj"), vtp = test::readBytes(folder / "all.vtp"),
                    ply = test::readBytes(folder / "all.ply"), seg = test::readBytes(folder / "all.seg.nrrd"),
                    text = test::readBytes(folder / "labels.txt");
  CHECK(obj.find("g cyst\nf ") < obj.find("g liver\nf "));
  CHECK(obj.find("g liver\nf ") != std::string::npos);
  CHECK(vtp.find("Name=\"Label\"") != std::string::npos);
  CHECK(ply.find("property uchar red") != std::string::npos);
  for (const char* part : {"Segment0_Name:=cyst", "Segment0_LabelValue:=300", "SCT^367643001^Cyst",
                           "Segment1_Name:=liver", "Segment1_LabelValue:=1"})
    CHECK(seg.find(part) != std::string::npos);
  CHECK(text.find("\"cyst\"") < text.find("\"liver\""));
  CHECK(test::readBytes(folder / "names.label") == text);
  const Volume labels = readVolume(folder / "all.nii.gz");
  std::map<int, int> counts;
  visitVoxels(labels, [&](const auto* v) {
    for (std::size_t i = 0; i < labels.grid.voxelCount(); ++i) ++counts[static_cast<int>(v[i])];
  });
  CHECK(counts.size() == 3);
  CHECK((counts.count(1) == 1 && counts.count(300) == 1));
}

namespace {

//! The number behind `what` in what assimp tells of a file.
int toldBy(const std::string& text, const std::string& what) {
  const std::size_t at = text.find(what + ":");
  REQUIRE(at != std::string::npos);
  return std::stoi(text.substr(at + what.size() + 1));
}

}  // namespace

TEST_CASE("a foreign reader finds the objects in 3MF and glTF, by number, size and name", "[cli][objects]") {
  const std::optional<std::string> assimp = findProgram("assimp");
  if (!assimp) {
    WARN("skipped: assimp is not installed");
    return;
  }
  const TempFolder folder;
  const Made made = segment(folder, writeStudy(folder), {kCystGroup, joined({kLiverGroup, kLiverAlone})},
                            {"cyst", "liver"}, {"-o", folder / "all.3mf", "-o", folder / "all.gltf"});
  std::size_t points = 0, faces = 0;
  for (const auto& [name, mesh] : made.meshes) {
    points += mesh.points.size();
    faces += mesh.triangles.size();
  }
  for (const std::string ending : {"3mf", "gltf"}) {
    INFO(ending);
    const std::string told = folder / ("told_by_assimp_of_" + ending + ".txt");
    REQUIRE(std::system((*assimp + " info " + (folder / ("all." + ending)) + " > " + told).c_str()) == 0);
    const std::string text = test::readBytes(told);
    CHECK(toldBy(text, "Meshes") == 2);
    CHECK(toldBy(text, "Vertices") == static_cast<int>(points));
    CHECK(toldBy(text, "Faces") == static_cast<int>(faces));
    CHECK_THAT(text, Contains("cyst") && Contains("liver"));
  }
}

TEST_CASE("a session of several objects is made again to the last bit", "[cli][objects][session]") {
  const TempFolder folder;
  const std::string volume = writeStudy(folder);
  const Made made =
      segment(folder, volume, {kCystGroup, joined({kLiverGroup, kLiverAlone})}, {"cyst", "liver"},
              {"--session", folder / "s.json", "--report", folder / "r.json"});
  for (const char* source : {"s.json", "r.json"}) {
    const test::Outcome again =
        test::runCli({"replay", folder / source, "-o", "liver=" + (folder / "again.vtp"), "-o",
                      folder / "again.seg.nrrd"});
    INFO(again.err);
    REQUIRE(again.exitCode == 0);
    CHECK(test::readBytes(folder / "again.vtp") == test::readBytes(folder / "liver.vtp"));
    CHECK(test::readBytes(folder / "again.seg.nrrd") == test::readBytes(folder / "all.seg.nrrd"));
  }
  expectRefused({"replay", folder / "s.json", "--label-value", "4", "-o", folder / "x.stl"}, 2,
                "holds several objects");
}

TEST_CASE("what cannot be meant by several objects is refused with one sentence, and nothing is written",
          "[cli][objects]") {
  const TempFolder folder;
  const std::string volume = writeStudy(folder);
  const auto refused = [&](const std::vector<Arguments>& groups, int exitCode, const std::string& words) {
    expectRefused(joined({{"segment", volume, "-o", folder / "out.stl"}, joined(groups)}), exitCode, words);
  };
  const Arguments a{"--object-name", "a", "--seed", "18,28,20,2"}, b{"--object-name", "b"};
  refused({a, a}, 2, "two objects have the name 'a'");
  refused({a, b}, 2, "object 'b': segment needs a --seed");
  refused({b, a}, 2, "object 'b': segment needs a --seed");
  refused({{"--seed", "1,2,3"}, a, kCystGroup}, 2, "before the first --object-name");
  refused({a, {"--label-value", "2"}, kCystGroup, {"--label-value", "2"}}, 2, "have the value 2");
  refused({a, kCystGroup, {"-o", "c=" + (folder / "c.stl")}}, 2, "no object has the name 'c'");
  refused({a, kCystGroup, {"-o", "cyst=" + (folder / "c.xyz")}}, 2, "unknown extension");
  refused({a, kCystGroup, {"-o", "cyst=" + (folder / "out.stl")}}, 2, "named twice");
  refused({a, kCystGroup, {"--no-such"}}, 2, "--no-such");
  refused({a, {"--object-name"}}, 2, "--object-name");
  refused({a, {"--object-name", "x|y", "--seed", "1,2,3"}}, 2, "'x|y' holds |");
  refused({kLiverGroup, {"--object-name", "again", "--seed", "18,28,20"}}, 4,
          "object 'again': The seed at 18,28,20 mm lies in the object 'liver', which is done already.");
  refused({kLiverGroup, {"--object-name", "far", "--seed", "180,28,20"}}, 4, "object 'far': ");
  CHECK(folder.names() == Arguments{"v.nrrd"});
}

TEST_CASE("one object that is cut short gives the exit code of that, and its files", "[cli][objects]") {
  const TempFolder folder;
  const std::string volume = writeStudy(folder);
  const Arguments cut{"--max-iterations", "3"};
  const test::Outcome outcome = test::runCli(joined({{"segment", volume},
                                                     kCystGroup,
                                                     kLiverGroup,
                                                     kLiverAlone,
                                                     cut,
                                                     {"-o", "liver=" + (folder / "l.stl")}}));
  CHECK(outcome.exitCode == 5);
  CHECK(outcome.out.find("cyst: converged") != std::string::npos);
  CHECK(outcome.out.find("liver: max-iterations after 3") != std::string::npos);
  CHECK(certify(readMesh(folder / "l.stl")).passes());
}

TEST_CASE("a single object writes as before, with its name or without", "[cli][objects]") {
  const TempFolder folder;
  const auto phantom = test::makePhantomFile(folder);
  const auto run = [&](const Arguments& more) {
    const auto outcome = test::runCli(joined({{"segment", phantom.path, "--seed", phantom.seed}, more}));
    INFO(outcome.err);
    CHECK(outcome.exitCode == 0);
  };
  run({"-o", folder / "a.stl", "--report", folder / "a.json"});
  run({"--object-name", "ball", "-o", "ball=" + (folder / "b.stl")});
  CHECK(test::readBytes(folder / "a.stl") == test::readBytes(folder / "b.stl"));
  const auto report = nlohmann::json::parse(test::readBytes(folder / "a.json"));
  CHECK(report.contains("mesh"));
  CHECK_FALSE(report.contains("objects"));
}
