// compare, through the program.

#include <algorithm>
#include <random>
#include <sstream>

#include "app/cli/csv.h"
#include "core/solid/mask_surface.h"
#include "tests/app/refusal.h"
#include "tests/app/run_cli.h"
#include "tests/core/solid/voxel_topology.h"
#include "tests/support/catch.h"

using namespace handlebody::test;
using handlebody::Mask;
using handlebody::cli::parseCsv;
using handlebody::testing::VoxelTopology;
using handlebody::testing::voxelTopology;

namespace {

//! A phantom's label map and its ideal surface.
struct Truth {
  std::string labels, surface;
};

Truth makeTruth(const TempFolder& folder, const std::string& name,
                const std::vector<std::string>& more = {}) {
  Truth t{folder / name + ".nii.gz", folder / name + ".stl"};
  std::vector<std::string> arguments{"phantom", "rings",  "-o",        folder / name + ".mha",
                                     "--truth", t.labels, "--surface", t.surface};
  arguments.insert(arguments.end(), more.begin(), more.end());
  runForJson(arguments);
  return t;
}

//! Unsigned bytes of a cube of n³ voxels of 1 mm, from the origin on.
template <typename F>
std::string cube(int n, F&& value) {
  const std::string size = std::to_string(n);
  std::string bytes =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = " + size +
      " " + size + " " + size +
      "\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  for (int i = 0; i < n * n * n; ++i) bytes += static_cast<char>(value(i % n, i / n % n, i / (n * n)));
  return bytes;
}

//! What of a cube of labels has this one.
Mask maskOf(int n, const std::vector<int>& labels, int label) {
  Mask mask;
  mask.grid.size = {n, n, n};
  for (const int l : labels) mask.inside.push_back(l == label ? 1 : 0);
  return mask;
}

//! As Wavefront OBJ.
std::string objText(const handlebody::TriangleSoup& mesh) {
  std::ostringstream text;
  for (const auto& p : mesh.points) text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& t : mesh.triangles) text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return text.str();
}

VoxelTopology topologyOf(const nlohmann::json& object) {
  return {object.at("components"), object.at("cavities"), object.at("genus")};
}

}  // namespace

TEST_CASE("a label map is compared with the surface it was drawn from", "[cli][compare]") {
  const TempFolder folder;
  const Truth truth = makeTruth(folder, "t", {"--size", "48,48,48", "--spacing", "2,2,2.5"});
  const auto json = runForJson({"compare", truth.labels, truth.surface, "--sampling", "0.7", "--json"});
  CHECK(json.at("a").at("kind") == "label map");
  CHECK(json.at("b").at("kind") == "mesh");
  for (const char* object : {"a", "b"}) {
    CHECK(json.at(object).at("components") == 1);
    CHECK(json.at(object).at("genus") == 2);
    CHECK(json.at(object).at("cavities") == 0);
    CHECK(json.at(object).at("volume_mm3") > 0);
  }
  CHECK(json.at("dice") > 0.97);
  CHECK(json.at("overlap").at("points") == "voxels");
  CHECK(json.at("overlap").at("spacing_mm") == nlohmann::json::array({2.0, 2.0, 2.5}));
  CHECK(json.at("distances").at("mean_symmetric_mm") < 1);
  CHECK(json.at("distances").at("hausdorff_95_mm") <= json.at("distances").at("hausdorff_mm"));
  CHECK(json.at("distances").at("hausdorff_mm") < 0.5 * 3.8);  // half of a cell's diagonal
  CHECK(json.at("distances").at("sampling_mm") == 0.7);
  CHECK(json.at("warnings").empty());
}

TEST_CASE("label maps of one object on turned grids are alike, and different labels are not mixed",
          "[cli][compare]") {
  const TempFolder folder;
  const Truth a = makeTruth(folder, "a"),
              b = makeTruth(folder, "b", {"--rotate", "20,-30,40", "--spacing", "1.5,1.2,1.1"});
  CHECK(runForJson({"compare", a.labels, a.labels, "--json", "--sampling", "1"}).at("dice") == 1.0);
  const auto json = runForJson({"compare", a.surface, b.surface, "--json", "--sampling", "1"});
  CHECK(json.at("overlap").at("points") == "lattice");
  writeBytes(folder / "m.mha", cube(9, [](int x, int y, int) { return x < 2 ? 0 : y < 4 ? 3 : 7; }));
  writeBytes(folder / "n.mha", cube(9, [](int x, int, int) { return x < 4 ? 0 : 1; }));
  const auto labels = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all{"compare", folder / "m.mha", folder / "n.mha", "--json"};
    all.insert(all.end(), options.begin(), options.end());
    return runForJson(all);
  };
  CHECK(labels({}).at("a").at("volume_mm3") == 7 * 81);
  CHECK(labels({}).at("b").at("volume_mm3") == 5 * 81);
  CHECK(labels({}).at("dice") == Approx(10.0 / 12));
  CHECK(labels({}).at("iou") == Approx(5.0 / 7));
  CHECK(labels({}).at("volume_difference_mm3") == 2 * 81);
  CHECK(labels({}).at("volume_difference_percent") == Approx(40));
  const auto three = labels({"--label-a", "3"});
  CHECK(three.at("a").at("label") == 3);
  CHECK(three.at("a").at("volume_mm3") == 7 * 4 * 9);
  CHECK(three.at("dice") == Approx(2.0 * 5 * 4 / (7 * 4 + 5 * 9)));
  const auto none = labels({"--label", "3"});  // B has none of it
  CHECK(none.at("dice") == 0.0);
  CHECK(none.at("distances").is_null());
  CHECK(none.at("warnings").size() == 1);
}

TEST_CASE("components, cavities and genus of label maps and meshes are those counted voxel by voxel",
          "[cli][compare]") {
  constexpr int kSide = 11;
  const TempFolder folder;
  std::mt19937 random(1);
  std::vector<int> labels;  // a body full of holes, and scraps of another
  while (labels.size() < kSide * kSide * kSide) {
    const int n = static_cast<int>(random() % 1000);
    labels.push_back(n < 930 ? 1 : n % 3);
  }
  writeBytes(folder / "m.mha", cube(kSide, [&](int x, int y, int z) {
               return labels[static_cast<std::size_t>((z * kSide + y) * kSide + x)];
             }));
  const Mask one = maskOf(kSide, labels, 1), two = maskOf(kSide, labels, 2);
  writeBytes(folder / "one.obj", objText(maskSurface(one)));
  const VoxelTopology body = voxelTopology(one), scraps = voxelTopology(two);
  REQUIRE(body.cavities > 1);  // else it would prove little
  REQUIRE(body.tunnels > 1);
  REQUIRE(scraps.components > 1);

  const auto maps = runForJson({"compare", folder / "m.mha", folder / "m.mha", "--label-a", "1", "--label-b",
                                "2", "--json", "--sampling", "2"});
  CHECK(topologyOf(maps.at("a")) == body);
  CHECK(topologyOf(maps.at("b")) == scraps);
  const auto mixed = runForJson(
      {"compare", folder / "m.mha", folder / "one.obj", "--label-a", "2", "--json", "--sampling", "2"});
  CHECK(topologyOf(mixed.at("a")) == scraps);
  CHECK(topologyOf(mixed.at("b")) == body);
}

TEST_CASE("the table has units, the CSV a row, and the report is the JSON", "[cli][compare]") {
  const TempFolder folder;
  const Truth t = makeTruth(folder, "t");
  const std::vector<std::string> base{"compare", t.surface, t.labels, "--sampling", "1"};
  auto with = base;
  with.insert(with.end(), {"--report", folder / "r.json", "--csv", folder / "r.csv", "-o", folder / "d.vtp"});
  const Outcome outcome = runCli(with);
  REQUIRE(outcome.exitCode == 0);
  for (const char* text : {"Dice", "IoU", "volume (ml)", "95 % Hausdorff distance (mm)", "genus", "1 mm"})
    CHECK_THAT(outcome.out, Contains(text));
  auto json = base;
  json.push_back("--json");
  CHECK(readBytes(folder / "r.json") == runCli(json).out);
  const auto rows = parseCsv(readBytes(folder / "r.csv"), "r.csv");
  REQUIRE(rows.size() == 2);
  REQUIRE(rows[0].cells.size() == rows[1].cells.size());
  const auto written = nlohmann::json::parse(readBytes(folder / "r.json"));
  for (std::size_t i = 0; i < rows[0].cells.size(); ++i)
    if (rows[0].cells[i].text == "dice") CHECK(std::stod(rows[1].cells[i].text) == written.at("dice"));
  CHECK_THAT(readBytes(folder / "d.vtp"), Contains("signed_distance_mm"));
  CHECK(runCli({"check", folder / "d.vtp"}).exitCode == 0);
}

TEST_CASE("with --anonymous neither files nor text tell the paths of what is compared", "[cli][compare]") {
  const TempFolder folder;
  std::string labels = cube(9, [](int x, int, int) { return x < 4 ? 0 : 1; });
  const std::string spacing = "ElementSpacing = 1 1 1\n";
  labels.erase(labels.find(spacing), spacing.size());  // there is a warning, which names the file
  const std::string a = folder / "DOE_JANE.mha", b = folder / "DOE_JANE_old.mha";
  for (const std::string& path : {a, b}) writeBytes(path, labels);
  const auto told = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "compare", a, b, "--report", folder / "r.json", "--csv", folder / "r.csv", "-o", folder / "d.vtp"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runCli(arguments);
    REQUIRE(outcome.exitCode == 0);
    return outcome.out + readBytes(folder / "r.json") + readBytes(folder / "r.csv") +
           readBytes(folder / "d.vtp");
  };
  CHECK_THAT(told({}), Contains("label map " + a) && Contains("\"" + b + "\"") && Contains(b + ": "));
  CHECK_THAT(told({"--anonymous"}), !Contains("DOE_JANE") && !Contains(folder.path()));
  CHECK_THAT(told({"--anonymous", "--json"}), !Contains("DOE_JANE") && !Contains(folder.path()));
  const auto json = nlohmann::json::parse(readBytes(folder / "r.json"));
  for (const char* object : {"a", "b"}) CHECK(json.at(object).at("path").is_null());
  REQUIRE(json.at("warnings").size() == 2);
  CHECK_THAT(json.at("warnings")[0].get<std::string>(), Contains("A: ") && Contains("uncalibrated"));
  CHECK_THAT(json.at("warnings")[1].get<std::string>(), Contains("B: "));
  CHECK(json.at("dice") == 1.0);
}

TEST_CASE("an open mesh has distances alone", "[cli][compare]") {
  const TempFolder folder;
  const std::string tetrahedron = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  writeBytes(folder / "closed.obj", tetrahedron);
  writeBytes(folder / "open.obj", tetrahedron.substr(0, tetrahedron.rfind('f')));
  const auto json =
      runForJson({"compare", folder / "open.obj", folder / "closed.obj", "--json", "-o", folder / "d.vtp"});
  CHECK(json.at("dice").is_null());
  CHECK(json.at("a").at("volume_mm3").is_null());
  CHECK(json.at("b").at("volume_mm3") == Approx(64.0 / 6));
  CHECK(json.at("distances").at("a_to_b").at("mean_mm") == Approx(0).margin(1e-9));
  CHECK_THAT(json.at("warnings")[0].get<std::string>(), Contains("A is not closed"));
  CHECK(runForJson({"compare", folder / "closed.obj", folder / "closed.obj", "--json"}).at("dice") == 1.0);
}

TEST_CASE("a mesh with a part that is inside out has no figures of a body", "[cli][compare]") {
  const TempFolder folder;
  const std::string first = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
                    corners = "v 9 0 0\nv 11 0 0\nv 9 2 0\nv 9 0 2\n";
  writeBytes(folder / "whole.obj", first + corners + "f 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n");
  writeBytes(folder / "turned.obj", first + corners + "f 5 6 7\nf 5 8 6\nf 6 8 7\nf 5 7 8\n");
  const auto json = runForJson({"compare", folder / "turned.obj", folder / "whole.obj", "--json"});
  for (const char* none : {"volume_mm3", "components", "genus", "cavities"}) {
    INFO(none);
    CHECK(json.at("a").at(none).is_null());
    CHECK_FALSE(json.at("b").at(none).is_null());
  }
  CHECK(json.at("dice").is_null());
  CHECK_FALSE(json.at("distances").is_null());
  CHECK_THAT(json.at("warnings").dump(), Contains("A has parts that lie where they bound nothing"));
}

TEST_CASE("what cannot be compared is refused in one sentence", "[cli][compare]") {
  const TempFolder folder;
  writeBytes(folder / "m.mha", cube(9, [](int x, int, int) { return x < 4 ? 0 : 1; }));
  writeBytes(folder / "bad.stl", "This is a letter and not a mesh.\n");
  writeBytes(folder / "closed.obj",
             "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  writeBytes(folder / "flat.obj", "v 0 0 0\nv 4 0 0\nv 8 0 0\nf 1 3 2\n");
  const std::string m = folder / "m.mha", mesh = folder / "closed.obj";
  requireRefusal(folder, {"compare", m}, 2, "B");
  requireRefusal(folder, {"compare", m, folder / "none.stl"}, 3, "none.stl");
  requireRefusal(folder, {"compare", folder / "none.nii", m}, 3, "none.nii");
  requireRefusal(folder, {"compare", m, folder / "bad.stl"}, 3, "bad.stl");
  requireRefusal(folder, {"compare", m, folder / "flat.obj"}, 3, "flat.obj");
  requireRefusal(folder, {"compare", m, m, "--label", "1.5"}, 2, "--label");
  requireRefusal(folder, {"compare", m, mesh, "--label-b", "1"}, 2, "--label-b");
  requireRefusal(folder, {"compare", mesh, mesh, "--label", "1"}, 2, "--label");
  for (const char* sampling : {"0", "-1", "inf", "some"})
    requireRefusal(folder, {"compare", m, m, "--sampling", sampling}, 2, "--sampling");
  requireRefusal(folder, {"compare", m, m, "--sampling", "1e-4"}, 2, "--sampling");
  requireRefusal(folder, {"compare", m, m, "-o", folder / "d.stl"}, 2, ".vtp");
  requireRefusal(folder, {"compare", m, m, "-o", folder / "missing/d.vtp"}, 2, "-o");
  requireRefusal(folder, {"compare", m, m, "--report", m}, 2, "--report");
  requireRefusal(folder, {"compare", m, m, "--label", "5", "-o", folder / "d.vtp"}, 2, "empty");
}

TEST_CASE("an image is no label map", "[cli][compare]") {
  const TempFolder folder;
  runForJson({"phantom", "sphere", "-o", folder / "v.mha", "--type", "float32", "--noise", "0.1"});
  requireRefusal(folder, {"compare", folder / "v.mha", folder / "v.mha"}, 3, "no label map");
}
