// Cases of a batch that are carried through the frames of a 4D volume.

#include "tests/app/batch_study.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! Three coarse frames of the beating phantom; its seed as a cell.
std::string makeHeart(const Study& study) {
  const auto json = runForJson({"phantom", "beating", "-o", study.folder / "heart.nii.gz", "--frames", "3",
                                "--ejection", "30", "--spacing", "3,3,3"});
  const auto& centre = json.at("seed").at("centre");
  std::string seed;
  for (std::size_t a = 0; a < 3; ++a) seed += (a ? "," : "") + std::to_string(centre.at(a).get<double>());
  return seed;
}

}  // namespace

TEST_CASE("a case over time has the files of single runs, bit for bit, and its ejection fraction",
          "[batch][time]") {
  const Study study;
  const std::string seed = makeHeart(study);
  writeBytes(study.csv, kHeader + ",frames,drift-check\nheart,heart.nii.gz,\"" + seed + "\",all,none\n" +
                            study.row("still", ",,"));
  const Outcome outcome = study.run();
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  const auto measures = study.row(0).at("measures");
  CHECK(measures.at("frames") == 3);
  CHECK(measures.at("frames_failed") == 0);
  CHECK(measures.at("ejection_fraction").get<double>() > 0.1);
  CHECK(study.row(1).at("measures").at("frames").is_null());
  REQUIRE(runCli({"segment", study.folder / "heart.nii.gz", "--seed=" + seed, "--frames=all",
                  "--drift-check=none", "-o", study.folder / "mesh.stl", "--quiet"})
              .exitCode == 0);
  for (const char* file : {"mesh_0000.stl", "mesh_0001.stl", "mesh_0002.stl"})
    CHECK(readBytes(study.file("heart", file)) == readBytes(study.folder / file));
  CHECK_FALSE(readBytes(study.file("heart", "curve.csv")).empty());
  const auto before = identity(study.out + "/cases/heart");
  REQUIRE(study.run().exitCode == 0);
  CHECK(identity(study.out + "/cases/heart") == before);  // it is done
  std::filesystem::remove(study.file("heart", "mesh_0001.stl"));
  REQUIRE(study.run().exitCode == 0);
  CHECK(identity(study.out + "/cases/heart") != before);
}

TEST_CASE("options over time are refused in their row where they mean nothing", "[batch][time]") {
  const Study study;
  const std::string seed = makeHeart(study);
  writeBytes(study.csv, kHeader + ",frames,topology,output\n" + "a,heart.nii.gz,\"" + seed + "\",,free,\n" +
                            "b,heart.nii.gz,\"" + seed + "\",3-1,,\n" + "c,heart.nii.gz,\"" + seed +
                            "\",all,,labels.mha\n");
  CHECK(study.run().exitCode == kIncomplete);
  CHECK(study.row(0).at("message").get<std::string>().find("--frames") != std::string::npos);
  CHECK(study.row(1).at("message").get<std::string>().find("(frames)") != std::string::npos);
  CHECK(study.row(2).at("message").get<std::string>().find("labels.mha") != std::string::npos);
}
