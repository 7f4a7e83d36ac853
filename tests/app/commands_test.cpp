// info, check, handles, phantom and help, through the program.

#include <cmath>

#include "tests/app/run_cli.h"
#include "tests/support/catch.h"

using namespace handlebody::test;

TEST_CASE("help and version succeed and say what the program is not", "[cli]") {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"segment", "--help"},
                                             {"info", "--help"},
                                             {"check", "--help"},
                                             {"measure", "--help"},
                                             {"edit", "--help"},
                                             {"compare", "--help"},
                                             {"mesh", "--help"},
                                             {"handles", "--help"},
                                             {"phantom", "--help"},
                                             {"replay", "--help"}}) {
    const Outcome outcome = runCli(arguments);
    CHECK(outcome.exitCode == 0);
    CHECK(outcome.err.empty());
    CHECK_THAT(outcome.out, Contains("not a medical device"));
  }
  CHECK(runCli({"--version"}).exitCode == 0);
}

TEST_CASE("a phantom prints its seed and its topology", "[cli]") {
  const TempFolder folder;
  const auto json = runForJson({"phantom", "sphere", "-o", folder / "p.nrrd", "--size", "20,24,28",
                                "--spacing", "4,3.5,3", "--rotate", "10,-20,30", "--type", "int16", "--truth",
                                folder / "t.nii.gz", "--surface", folder / "s.vtp"});
  CHECK(json.at("genus") == nlohmann::json::array({0}));
  CHECK(json.at("components") == 1);
  CHECK(json.at("seed").at("centre").size() == 3);
  CHECK(json.at("seed").at("radius") > 0);
  CHECK(folder.names() == std::vector<std::string>{"p.nrrd", "s.vtp", "t.nii.gz"});
  CHECK(runCli({"check", folder / "s.vtp"}).exitCode == 0);
}

TEST_CASE("info tells size, spacing, type and intensities", "[cli]") {
  const TempFolder folder;
  const PhantomFile phantom = makePhantomFile(folder, "p.nii.gz", {"--type", "int16", "--rotate", "0,0,90"});
  const auto json = runForJson({"info", phantom.path, "--json"});
  CHECK(json.at("size") == nlohmann::json::array({32, 32, 32}));
  CHECK(json.at("type") == "int16");
  CHECK(json.at("frames") == 1);
  for (int axis = 0; axis < 3; ++axis) CHECK(json.at("spacing")[axis].get<double>() == Approx(2.5));
  CHECK(json.at("direction")[1][0].get<double>() == Approx(1).margin(1e-6));  // the first axis points along y
  CHECK(json.at("orientation") == "PRS");
  const auto& intensities = json.at("intensities");
  CHECK(intensities.at("min") < intensities.at("mean"));
  CHECK(intensities.at("mean") < intensities.at("max"));
  CHECK(intensities.at("percentiles").at("50") <= intensities.at("percentiles").at("99"));
  CHECK(json.at("warnings").is_array());
  CHECK_THAT(runCli({"info", phantom.path}).out, Contains("32 x 32 x 32"));
}

TEST_CASE("info says which time points a 4D volume has and takes the one asked for", "[cli]") {
  const TempFolder folder;
  std::string bytes(8 * 8 * 8, '\1');
  bytes += std::string(8 * 8 * 8, '\2');
  writeBytes(
      folder / "v.mha",
      "ObjectType = Image\nNDims = 4\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = 8 8 8 2\n"
      "ElementSpacing = 1 1 1 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
          bytes);
  CHECK(runForJson({"info", folder / "v.mha", "--json"}).at("frames") == 2);
  CHECK(runForJson({"info", folder / "v.mha", "--json"}).at("warnings").size() == 1);
  CHECK(runForJson({"info", folder / "v.mha", "--frame", "1", "--json"}).at("intensities").at("max") == 2.0);
  CHECK(runCli({"info", folder / "v.mha", "--frame", "2"}).exitCode == 2);
}

TEST_CASE("check tells a closed mesh from an open one and from one that cuts itself", "[cli]") {
  const TempFolder folder;
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  // The same once more, moved by less than its size.
  const std::string second =
      "v 0.1 0.1 0.1\nv 1.1 0.1 0.1\nv 0.1 1.1 0.1\nv 0.1 0.1 1.1\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n";
  writeBytes(folder / "closed.obj", tetrahedron);
  writeBytes(folder / "open.obj", tetrahedron.substr(0, tetrahedron.rfind('f')));
  writeBytes(folder / "cut.obj", tetrahedron + second);

  const auto json = runForJson({"check", folder / "closed.obj", "--json"});
  CHECK(json.at("vertices") == 4);
  CHECK(json.at("euler") == 2);
  CHECK(json.at("genus") == nlohmann::json::array({0}));
  CHECK(json.at("self_intersections") == 0);
  CHECK(json.at("volume_mm3").get<double>() == Approx(1.0 / 6));

  const Outcome open = runCli({"check", folder / "open.obj", "--json"});
  CHECK(open.exitCode == 1);
  CHECK(nlohmann::json::parse(open.out).at("closed") == false);
  const Outcome cut = runCli({"check", folder / "cut.obj", "--json"});
  CHECK(cut.exitCode == 1);
  CHECK(nlohmann::json::parse(cut.out).at("self_intersections") > 0);
  CHECK_THAT(runCli({"check", folder / "cut.obj"}).out, Contains("does not pass"));
}

TEST_CASE("handles counts the families", "[cli]") {
  const auto all = runForJson({"handles", "--sizes", "3,3", "--family", "all", "--json"});
  CHECK(all.at("handles") == 21);  // engine.md, section 4
  CHECK(all.size() == 2);
  CHECK(all.at("generators") > 0);
  CHECK(runForJson({"handles", "--sizes", "3,3,4", "--json"}).at("handles") == 72);  // Table 1 of the paper
  CHECK_THAT(runCli({"handles", "--sizes", "3,4", "--family", "all"}).out, Contains("48 handles"));
}

TEST_CASE("check tells the shapes of the triangles and what single precision leaves", "[cli]") {
  const TempFolder folder;
  // A flat tetrahedron far out: in single precision its faces fall together.
  writeBytes(
      folder / "flat.obj",
      "v 100000 0 0\nv 100004 0 0\nv 100000 4 0\nv 100001 1 0.3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const auto json = runForJson({"check", folder / "flat.obj", "--json"});
  const auto& quality = json.at("quality");
  CHECK(quality.at("angles_degrees").at("least") > 5);
  CHECK(quality.at("edges_mm").at("largest").get<double>() == Approx(std::sqrt(32)));
  CHECK(quality.at("dihedral_angles_degrees").at("least") < 30);
  CHECK(json.at("single_precision").at("farthest_mm").get<double>() == Approx(0).margin(1e-7));
  writeBytes(folder / "thin.obj",
             "v 100000 0 0\nv 100004 0 0\nv 100000 4 0\nv 100000.001 0 0\nv 100001 1 1\n"
             "f 1 3 4\nf 4 3 2\nf 1 4 5\nf 4 2 5\nf 2 3 5\nf 3 1 5\n");
  const auto thin = runForJson({"check", folder / "thin.obj", "--json"});
  CHECK(thin.at("single_precision").at("farthest_mm").get<double>() == Approx(0.001).epsilon(0.01));
  CHECK(thin.at("single_precision").at("passes") == false);
  const std::string text = runCli({"check", folder / "thin.obj"}).out;
  for (const char* word :
       {"angles (degrees)", "dihedral angles", "radius ratio", "edges (mm)", "single precision"})
    CHECK_THAT(text, Contains(word));
}
